#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "roomgraph/breaks/site_breaks.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/relate/estimate_scale.h"
#include "roomgraph/score/run_score.h"

namespace roomgraph {
namespace {

/** docs/scoring.md on one line. */
std::string document() {
  std::ostringstream text;
  text << std::ifstream(ROOMGRAPH_SCORING).rdbuf();
  std::string line = text.str();
  std::replace(line.begin(), line.end(), '\n', ' ');
  line.erase(
      std::unique(line.begin(), line.end(), [](char l, char r) { return l == ' ' && r == ' '; }),
      line.end());
  return line;
}

void expectSaid(const char* format, double figure) {
  char text[200];
  std::snprintf(text, sizeof text, format, figure);
  EXPECT_NE(document().find(text), std::string::npos) << text;
}

double degrees(double angle) { return std::round(angle * 1800 / M_PI) / 10; }

TEST(ScoringDocument, saysWhereABreakBegins) {
  const SiteBreaksOptions breaks;
  expectSaid("Where that pose turns by %g degrees", degrees(breaks.findBreaks.minRotation));
  expectSaid("moves by %g m from one scan to the next", breaks.findBreaks.minShift);
  expectSaid("where it turns by %g degrees or", degrees(breaks.findBreaks.wideRotation));
  expectSaid("moves by %g m within four scans", breaks.findBreaks.wideShift);
  expectSaid("differ by %g degrees or ", degrees(breaks.findPieces.minRotation));
  expectSaid(" degrees or %g m, and by", breaks.findPieces.minShift);
  expectSaid("and by %g times what they bend themselves", breaks.findPieces.minContrast);
  expectSaid("turned by %g degrees (root mean square)", degrees(breaks.findPieces.maxTurnBend));
  expectSaid("runs with %g %% of the votes", 100 * breaks.minVotes);
}

TEST(ScoringDocument, saysWhatIsMeaningful) {
  const RunScoreOptions score;
  expectSaid("fewer than %g wall points", score.minWalls);
  expectSaid("%g %% of its walls in common", 100 * score.minShare);
  expectSaid("exp(−map error / %g m)", score.scoreScale);
  expectSaid("1 / (%g m + map error)⁴", score.trustFloor);
}

TEST(ScoringDocument, saysWhenAScaleIsFound) {
  const EstimateScaleOptions scale;
  expectSaid("with a probability of %g, have", scale.minConfidence);
  expectSaid("that is 10 %% away by %g", scale.minMargin);
  expectSaid("Every %g %%, the picture", 100 * scale.step);
}

TEST(ScoringDocument, saysWhereTheGateStrikes) {
  expectSaid("`--fail-on coverage` strikes below %g %%", 100 * kPartialCoverage);
}

}  // namespace
}  // namespace roomgraph
