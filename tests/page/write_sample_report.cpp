// write_sample_report FILE [RUNS [TURN]]: a report for the tests in a browser, of the sample or of
// as many runs like those of it, in a site that is turned by so much [rad].
#include <cstdlib>

#include "roomgraph/base/write_file.h"
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

/** The same site in another frame. */
void turn(Comparison& comparison, double by) {
  const roomgraph::Transform2D move{0, 0, by};
  for (roomgraph::ComparedRun& run : comparison.runs) {
    run.pose = move * run.pose;
    for (roomgraph::PathPose& at : run.path) at.pose = move * at.pose;
  }
  for (roomgraph::SiteRoom& room : comparison.rooms) {
    room.center = move(room.center);
    for (roomgraph::Point& corner : room.polygon.outer) corner = move(corner);
    for (roomgraph::Ring& hole : room.polygon.holes)
      for (roomgraph::Point& corner : hole) corner = move(corner);
  }
  for (roomgraph::MapBreak& tear : comparison.breaks) {
    tear.place = move(tear.place);
    if (tear.torn) tear.torn = {move * tear.torn->drawn, move * tear.torn->untorn};
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  auto sample = roomgraph::test::sampleComparison();
  if (argc > 2) enlarge(sample.comparison, std::strtoul(argv[2], nullptr, 10));
  if (argc > 3) turn(sample.comparison, std::strtod(argv[3], nullptr));
  roomgraph::writeFileAtomically(argv[1],
                                 roomgraph::comparisonReport(sample.comparison, sample.runs));
}
