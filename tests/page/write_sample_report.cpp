// write_sample_report FILE [RUNS]: a report for the tests in a browser, of the sample or of as many
// runs like those of it.
#include <cstdlib>

#include "roomgraph/files/write_file.h"
#include "roomgraph/page/comparison_report.h"
#include "sample_comparison.h"

namespace {

using roomgraph::Comparison;

/** As many runs; only the first have maps. */
void enlarge(Comparison& comparison, std::size_t count) {
  const std::size_t few = comparison.runs.size();
  for (std::size_t i = few; i < count; ++i) {
    comparison.runs.push_back(comparison.runs[i % few]);
    comparison.runs.back().name = "night " + std::to_string(i);
    comparison.runs.back().rank = i + 1;
    for (roomgraph::SiteRoom& room : comparison.rooms) {
      room.runs.push_back(room.runs[i % few]);
      room.runs.back().run = comparison.runs.back().name;
    }
  }
  const roomgraph::ComparedPair pair = comparison.pairs.front();
  comparison.pairs.clear();
  for (std::size_t a = 0; a < comparison.runs.size(); ++a)
    for (std::size_t b = a + 1; b < comparison.runs.size(); ++b) {
      comparison.pairs.push_back(pair);
      comparison.pairs.back().a = comparison.runs[a].name;
      comparison.pairs.back().b = comparison.runs[b].name;
    }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  auto sample = roomgraph::test::sampleComparison();
  if (argc > 2) enlarge(sample.comparison, std::strtoul(argv[2], nullptr, 10));
  roomgraph::writeFileAtomically(argv[1],
                                 roomgraph::comparisonReport(sample.comparison, sample.runs));
}
