// Any bytes as places that somebody has marked on a map. What is taken can be written, and read
// again.
#include "ByteSource.h"
#include "as_file.h"
#include "or_refused.h"
#include "roomgraph/repair/MarkedFile.h"
#include "roomgraph/repair/carry_things.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomgraph;
  test::ByteSource bytes(data, size);
  const std::string name = test::asFile(bytes.rest());
  test::orRefused([&] {
    const MarkedFile marked = readMarked(name);
    std::vector<CarriedPlace> carried;
    for (const Place& place : marked.places) {
      CarriedPlace& there = carried.emplace_back();
      there.pose = place.pose, there.state = CarryState::carried;
    }
    const auto written = marked.write(carriedThings(marked, carried, {}), {});
    if (written.size() != 1) return;  // a mask, with its picture
    try {
      (void)readMarked(test::asFile(written[0].bytes));
    } catch (const DataError&) {
      std::abort();
    }
  });
  return 0;
}
