#include "roomgraph/consensus/add_to_consensus.h"

#include <map>
#include <utility>

#include "roomgraph/consensus/find_consensus.h"

namespace roomgraph {
namespace {

constexpr std::size_t kFixed = 0, kAdded = 1;  // places in the pose graph

/** Those of all matches that have the run on one side. */
std::vector<const RunMatches*> matchesOf(std::size_t run, const std::vector<RunMatches>& all) {
  std::vector<const RunMatches*> own;
  for (const RunMatches& piece : all)
    if (piece.of == run || piece.in == run) own.push_back(&piece);
  return own;
}

/** The submaps of several runs, where they lie, as those of one run without links. */
class FixedRun {
 public:
  void add(std::size_t run, const RunSubmaps& submaps, const std::vector<Transform2D>& poses) {
    if (!firsts_.emplace(run, std::uint32_t(fixed_.submaps.size())).second) return;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      fixed_.submaps.push_back(submaps.submaps[k]);
      fixed_.submaps.back().pose = poses[k];
    }
    fixed_.areScans = true;
  }

  std::uint32_t placeOf(std::size_t run, std::uint32_t submap) const {
    return firsts_.at(run) + submap;
  }
  RunSubmaps submaps() { return std::move(fixed_); }

 private:
  RunSubmaps fixed_;
  std::map<std::size_t, std::uint32_t> firsts_;
};

std::vector<Transform2D> posesAmong(FixedRun& fixed, const RunSubmaps& added, std::size_t run,
                                    const std::vector<const RunMatches*>& matches) {
  std::vector<RunMatches> both;
  for (const RunMatches* piece : matches) {
    const bool isOf = piece->of == run;
    both.push_back(
        {isOf ? kAdded : kFixed, isOf ? kFixed : kAdded, piece->matches, piece->likeness});
    for (SubmapMatch& match : both.back().matches) {
      std::uint32_t& submap = isOf ? match.in : match.submap;
      submap = fixed.placeOf(isOf ? piece->in : piece->of, submap);
    }
  }
  ConsensusOptions options;
  options.reference = kFixed;
  return findConsensus({fixed.submaps(), added}, both, options).best[kAdded];
}

}  // namespace

AddedToConsensus addToConsensus(const std::vector<RunSubmaps>& runs, std::size_t added,
                                const std::vector<RunMatches>& matches, const SubmapPoses& poses) {
  const std::vector<const RunMatches*> own = matchesOf(added, matches);
  FixedRun fixed;
  std::map<std::size_t, std::size_t> places;  // of the runs among which the error is taken
  std::vector<RunSubmaps> among;
  SubmapPoses posesOfThem;
  std::vector<RunMatches> ofThem;
  const auto placeOf = [&](std::size_t run) { return run == added ? among.size() : places[run]; };
  for (const RunMatches* piece : own) {
    const std::size_t other = piece->of == added ? piece->in : piece->of;
    fixed.add(other, runs[other], poses[other]);
    if (!places.emplace(other, among.size()).second) continue;
    among.push_back(runs[other]);
    posesOfThem.push_back(poses[other]);
  }
  for (const RunMatches* piece : own)
    ofThem.push_back({placeOf(piece->of), placeOf(piece->in), piece->matches});
  AddedToConsensus result{posesAmong(fixed, runs[added], added, own), {}};
  among.push_back(runs[added]);
  posesOfThem.push_back(result.poses);
  result.error = mapErrors(among, ofThem, posesOfThem).back();
  return result;
}

}  // namespace roomgraph
