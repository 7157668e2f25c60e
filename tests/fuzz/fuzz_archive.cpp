// Any bytes as an archive of a site. What is taken can be listed and exported.
#include "ByteSource.h"
#include "as_file.h"
#include "or_refused.h"
#include "roomgraph/archive/Archive.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomgraph;
  test::ByteSource bytes(data, size);
  const std::string file = test::asFile(bytes.rest());
  test::orRefused([&] {
    const Archive archive(file, Archive::Access::existing);
    for (const std::string& site : archive.sites()) {
      test::orRefused([&] { (void)archive.runs(site); });
      test::orRefused([&] { (void)archive.history(site); });
    }
  });
  return 0;
}
