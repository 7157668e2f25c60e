// Any bytes as a map: as they are, packed, or as a png with the right checksums.
#include "ByteSource.h"
#include "as_file.h"
#include "or_refused.h"
#include "roomgraph/base/compressed.h"
#include "roomgraph/images/read_labels.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/read_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomgraph;
  test::ByteSource bytes(data, size);
  const unsigned wrapping = bytes.byte() % 3;
  std::string content = bytes.rest();
  if (wrapping == 1) content = compressed(content, Compression::gzip);
  if (wrapping == 2) content = test::withPngChecksums(std::move(content));
  const std::string& file = test::asFile(content);
  test::orRefused([&] { loadMap(file, {}); });
  test::orRefused([&] { readLabels(file); });
  test::orRefused([&] { readRecording(file); });
  return 0;
}
