#pragma once
#include <map>
#include <vector>

#include "keep_pairs.h"
#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/relate_runs.h"

namespace roomgraph {

/** The pairs of some runs that have been related so far. */
class RelatedPairs {
 public:
  /** All of these must outlive it. */
  RelatedPairs(const std::vector<Run>& runs, const RelateRunsOptions& options,
               const ForEach& forEach, const KeptPairs& kept);

  /** Completes maps in which others will be looked for again and again. */
  void complete(const std::vector<std::size_t>& runs);
  /** Relates each of `others` to the hub. */
  void search(std::size_t hub, const std::vector<std::size_t>& others);
  /** Relates pairs over their hubs, to which both have been related; without one where it is one
   *  of both. */
  void relate(std::vector<PairOver> pairs);

  /** The pair with the hub named first. */
  MapPair between(std::size_t hub, std::size_t run) const;
  /** All pairs, which are moved out. */
  MapPairs all();

 private:
  const WallMap& mapOf(std::size_t run) const { return full_.known(runs_[run].map); }
  MapPair related(const PairOver& pair, FullMaps& maps) const;

  const std::vector<Run>& runs_;
  bool areAligned_, areOneSite_;
  const ForEach& forEach_;
  RelatePair relate_;
  FullMaps full_;
  std::map<PairOfThings, MapPair> found_;
};

}  // namespace roomgraph
