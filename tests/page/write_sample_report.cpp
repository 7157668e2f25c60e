// write_sample_report FILE: a report for the tests in a browser.
#include "roomgraph/files/write_file.h"
#include "roomgraph/page/comparison_report.h"
#include "sample_comparison.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto sample = roomgraph::test::sampleComparison();
  roomgraph::writeFileAtomically(argv[1],
                                 roomgraph::comparisonReport(sample.comparison, sample.runs));
}
