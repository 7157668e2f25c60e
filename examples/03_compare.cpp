// Which of several maps of one site is the best: 03_compare MAP MAP... prints the maps by rank,
// with the estimate of their error, and what speaks against each.
#include <cstdio>
#include <exception>

#include "roomgraph/compare/compare_maps.h"

int main(int count, char** arguments) try {
  const std::vector<std::string> files(arguments + 1, arguments + count);
  const roomgraph::Comparison comparison = roomgraph::compareMaps(files, {});

  for (const roomgraph::ComparedRun& run : comparison.runs)
    if (run.score)
      std::printf("%zu. %s: %.2f m, %s\n", run.rank, run.name.c_str(), run.score->mapError,
                  run.reason.c_str());
    else
      std::printf("-. %s: %s\n", run.name.c_str(), run.reason.c_str());
  for (const roomgraph::LeftOutRun& run : comparison.leftOut)
    std::printf("-. %s: %s\n", run.name.c_str(), run.reason.c_str());
  std::puts(comparison.verdict.c_str());
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
