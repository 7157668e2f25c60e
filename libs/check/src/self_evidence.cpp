#include "self_evidence.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "roomgraph/base/statistics.h"
#include "roomgraph/measures/measure_kinds.h"

namespace roomgraph {
namespace {

Evidence stepsContradicted(const MendedSteps& mended) {
  Evidence row{"steps_contradicted", "Steps that its scans contradict", "1", {}, {}, 0};
  double wrong = 0;
  for (const StepEvidence step : mended.evidence) {
    row.support += step != StepEvidence::none;
    wrong += speaksAgainst(step);
  }
  if (row.support > 0) row.drawn = wrong / row.support;
  return row;
}

/** Of what was found again: 9 of 10 lie nearer than this to where `poses` have it. */
std::optional<double> revisitsApart(const std::vector<PoseEdge>& revisits,
                                    const std::vector<Transform2D>& poses) {
  std::vector<double> apart;
  for (const PoseEdge& edge : revisits)
    apart.push_back(
        distance(poses[edge.from.index()](edge.measured.shift()), poses[edge.to.index()].shift()));
  if (apart.empty()) return std::nullopt;
  return quantile(std::move(apart), 0.9);
}

Evidence revisitsApart(const Run& run, const SelfConsensus& consensus) {
  std::vector<PoseEdge> fit;
  std::copy_if(consensus.revisits.begin(), consensus.revisits.end(), std::back_inserter(fit),
               [&](const PoseEdge& edge) { return isInlier(edge, consensus.poses); });
  return {"revisits_apart",
          "90th percentile of how far revisits are from where they were drawn",
          "m",
          revisitsApart(fit, drawnPoses(run.scans)),
          revisitsApart(fit, consensus.poses),
          double(fit.size())};
}

Evidence beamsThrough(const BeamsThroughWalls& drawn, const BeamsThroughWalls& agreed) {
  return {"beams_through_walls",
          "Walls that beams of another pass go through",
          "1",
          drawn.share(),
          agreed.share(),
          double(drawn.walls)};
}

/** Measured as in a comparison. */
Evidence ofMap(const char* name, std::optional<double> value, const Run& run) {
  const MeasureKind& kind = *findMeasureKind(name);
  return {kind.name, kind.label, kind.unit, value, {}, double(run.map.walls.size())};
}

}  // namespace

std::vector<Evidence> mapEvidence(const Run& run) {
  std::optional<double> degrees;
  if (run.map.axisDeviation) degrees = *run.map.axisDeviation * 180 / M_PI;
  return {ofMap("axis_deviation", degrees, run), ofMap("wall_doubling", run.map.wallDoubling, run),
          ofMap("wall_sharpness", run.map.wallSharpness, run)};
}

std::vector<Evidence> selfEvidence(const Run& run, const MendedSteps& mended,
                                   const SelfConsensus& consensus, const BeamsThroughWalls& drawn,
                                   const BeamsThroughWalls& agreed) {
  std::vector<Evidence> rows{stepsContradicted(mended), revisitsApart(run, consensus),
                             beamsThrough(drawn, agreed)};
  const std::vector<Evidence> map = mapEvidence(run);
  rows.insert(rows.end(), map.begin(), map.end());
  return rows;
}

}  // namespace roomgraph
