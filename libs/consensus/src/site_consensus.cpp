#include "roomgraph/consensus/site_consensus.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "confirm_runs.h"
#include "extend_errors.h"
#include "fitted_consensus.h"
#include "match_runs.h"
#include "own_matches.h"
#include "refine_poses.h"
#include "roomgraph/base/return_memory.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/consensus/add_to_consensus.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/find_consensus.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

/** For each run the one that counts of those with its map: the first with as many scans; for one
 *  without scans the first that has some, as they tell more. */
std::vector<std::size_t> standIns(const Site& site, const DistinctMaps& maps) {
  const auto scansOf = [&](std::size_t run) { return site.runs[run]->scans.size(); };
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    chosen.push_back(maps.firstOf(i));
    for (std::size_t j = site.runs.size(); j-- > 0;)
      if (maps.firstOf(j) == maps.firstOf(i) &&
          (scansOf(i) > 0 ? scansOf(j) == scansOf(i) : scansOf(j) > 0))
        chosen.back() = j;
  }
  return chosen;
}

/** Which runs count, those first among which the consensus is worked out, each straightest first:
 *  the likeliest to be sound. */
struct CountedRuns {
  std::vector<std::size_t> order;
  std::size_t core = 0;  ///< so many of them are the core

  CountedRuns(const Site& site, const MapPairs& pairs, const std::vector<std::size_t>& standIns) {
    std::set<std::size_t> first;
    for (const std::size_t run : pairs.core) first.insert(standIns[run]);
    const std::set<std::size_t> distinct(standIns.begin(), standIns.end());
    order.assign(distinct.begin(), distinct.end());
    sortBy(order, [&](std::size_t run) {
      return std::make_pair(first.count(run) == 0,
                            site.runs[run]->map.axisDeviation.value_or(M_PI));
    });
    core = first.empty() ? order.size() : first.size();
  }
};

/** Numbers the runs that count, and makes nodes and links of them. */
void addRuns(Consensus& consensus, const Site& site, const std::vector<std::size_t>& standIns,
             const std::vector<std::size_t>& order) {
  std::vector<RunId> runs(site.runs.size());
  for (const std::size_t i : order) {
    runs[i] = addRunNodes(*site.runs[i], consensus.graph);
    consensus.siteRuns.add(i);
  }
  for (std::size_t i = 0; i < site.runs.size(); ++i) consensus.graphRuns[i] = runs[standIns[i]];
  if (site.reference) consensus.graph.reference = consensus.graphRuns[*site.reference];
}

/** What the runs that count have of breaks of their own, where `asked` (run) wants to know. */
template <class Asked>
std::vector<FoundGroup> allOwnMatches(const Consensus& consensus, const Site& site,
                                      const ForEach& forEach, const Asked& asked) {
  return gathered<FoundGroup>(consensus.graph, forEach, [&](RunId run) {
    return ownMatches(consensus.graph, run, *site.runs[consensus.siteRuns[run]], asked(run));
  });
}

/** The link that what a run has of a break of its own contradicts. */
PoseEdgeId brokenLink(const PoseGraph& graph, const FoundGroup& own) {
  const GraphRun& run = graph.runs[own.group.from];
  return run.links[run.nodes.placeOf(own.matches.front().to) - 1];
}

/** They stand for the links that they contradict. */
void addOwn(PoseGraph& graph, const std::vector<FoundGroup>& own) {
  for (const FoundGroup& found : own) {
    graph.edges[brokenLink(graph, found)].share = beliefOf(0);
    graph.addGroup(found.group, found.matches);
  }
}

/** What the runs that count were found of in each other, and each by itself. */
void addMatches(Consensus& consensus, const Site& site, const MapPairs& pairs,
                const ForEach& forEach) {
  PoseGraph& graph = consensus.graph;
  const std::vector<FoundGroup> own = allOwnMatches(consensus, site, forEach, [&](RunId run) {
    return barelyHeldSteps(*site.runs[consensus.siteRuns[run]]);
  });
  for (const FoundGroup& found : matchRuns(site, pairs, graph, consensus.siteRuns, forEach))
    graph.addGroup(found.group, found.matches);
  addOwn(graph, own);
}

/** The same of steps to what no other run confirms, that hold in the consensus; whether there is
 *  any. */
bool addOwnToUnconfirmed(Consensus& consensus, const Site& site, const ForEach& forEach) {
  PoseGraph& graph = consensus.graph;
  const auto isConfirmed = confirmedNodes(graph, consensus.poses, consensus.trust.belief);
  std::vector<FoundGroup> own = allOwnMatches(consensus, site, forEach, [&](RunId run) {
    return stepsToUnconfirmed(graph.runs[run].nodes, isConfirmed);
  });
  eraseIf(own, [&](const FoundGroup& found) {  // what is known
    const PoseEdge& link = graph.edges[brokenLink(graph, found)];
    return link.share < 1 || !isInlier(link, gapOf(link, consensus.poses), kInlier);
  });
  addOwn(graph, own);
  return !own.empty();
}

/** The first runs of a graph, and what they found of each other. Nodes and links keep their ids. */
PoseGraph coreOf(const PoseGraph& graph, std::size_t runs) {
  PoseGraph core;
  core.reference = graph.reference;
  for (std::size_t r = 0; r < runs; ++r) core.addRun(graph, RunId(r));
  for (const MatchGroup& group : graph.groups) {
    if (group.from.index() >= runs || group.to.index() >= runs) continue;
    core.addGroup(group, mapped(group.edges, [&](PoseEdgeId edge) { return graph.edges[edge]; }));
  }
  return core;
}

/** What all runs that count agree on, from one or another start. */
struct Agreement {
  NodePoses poses;
  ById<RunId, double> stretches;
  ById<RunId, double> slack;
  ById<RunId, MapError> errors;
};

/** The runs of the core agree among themselves. The best first. */
std::vector<Agreement> agreementsOf(const PoseGraph& core, const ForEach& forEach) {
  ConsensusPoses found = findConsensus(core, forEach);
  std::vector<NodePoses> all{std::move(found.best)};
  for (NodePoses& other : found.others) all.push_back(std::move(other));
  std::vector<Agreement> agreements;
  for (NodePoses& poses : all) {
    ById<RunId, MapError> errors = mapErrors(core, poses);
    agreements.push_back({std::move(poses), found.stretches, found.trust.slack, std::move(errors)});
  }
  return agreements;
}

/** Adds the other runs, each by itself. */
void addOthers(Agreement& agreement, const PoseGraph& graph, const ForEach& forEach) {
  const std::size_t core = agreement.errors.size(), others = graph.runs.size() - core;
  const auto isCore = [&](RunId run) { return run.index() < core; };
  ById<RunId, std::vector<MatchGroupId>> own(graph.runs.size());
  for (const MatchGroupId id : graph.groups.ids()) {
    const MatchGroup& group = graph.groups[id];
    const auto [other, added] = std::minmax(group.from, group.to);
    if (!isCore(added) && (isCore(other) || other == added)) own[added].push_back(id);
  }
  std::vector<AddedToConsensus> added(others);
  forEach(others, [&](std::size_t i) {
    const RunId run(core + i);
    added[i] = addToConsensus(graph, run, own[run], agreement.poses);
  });
  for (AddedToConsensus& one : added) {
    for (const Transform2D& pose : one.poses) agreement.poses.add(pose);
    agreement.stretches.add(one.stretch);
    agreement.slack.add(one.slack);
    agreement.errors.add(std::move(one.error));
  }
}

/** Lets the intervals hold what another solution has, which may be the right one. */
void widen(ById<RunId, MapError>& errors, const ById<RunId, MapError>& others) {
  for (const RunId run : errors.ids()) {
    errors[run].low = std::min(errors[run].low, others[run].low);
    errors[run].high = std::max(errors[run].high, others[run].high);
  }
}

/** What all runs agree on: those of the core first, then the others. */
void agree(Consensus& consensus, std::size_t core, const ForEach& forEach) {
  PoseGraph& graph = consensus.graph;
  std::vector<Agreement> agreements = agreementsOf(coreOf(graph, core), forEach);
  for (Agreement& one : agreements) addOthers(one, graph, forEach);
  Agreement& best = agreements.front();
  for (std::size_t k = 1; k < agreements.size(); ++k) widen(best.errors, agreements[k].errors);
  consensus.poses = std::move(best.poses), consensus.errors = std::move(best.errors);
  graph.setStretches(best.stretches);
  consensus.trust = {std::move(best.slack), beliefIn(graph, consensus.poses, kInlier)};
}

/** Makes the links firm that runs hold against their consensus; whether that has led to another
 *  one. A run that is wrong over a whole stretch holds each of its steps with good reason: where
 *  others are torn for it, it does not have its way. */
bool holdSteps(Consensus& consensus, const Site& site, std::size_t core, const ForEach& forEach) {
  const std::vector<PoseEdgeId> held = heldSteps(site, consensus, forEach);
  if (held.empty()) return false;
  Consensus holding = consensus;
  for (const PoseEdgeId link : held) holding.graph.edges[link].share = fitted::kHeldShare;
  agree(holding, core, forEach);
  if (tornRuns(holding) > tornRuns(consensus)) return false;
  consensus = std::move(holding);
  return true;
}

}  // namespace

SolvedSite solveSite(const std::vector<Run>& runs, const MapPairs& related,
                     std::optional<std::size_t> reference, const ForEach& forEach) {
  Site site = placeRuns(runs, related, reference);
  MapPairs pairs = pairsInSite(site, related, forEach);
  PairBends bends = bendsOf(pairs);
  DistinctMaps maps(bends);
  Consensus consensus = siteConsensus(site, pairs, maps, forEach);
  refinePoses(consensus, site, pairs, forEach);
  returnMemory();  // of hundreds of runs, what it is worked out from is much
  return {std::move(site), std::move(pairs), std::move(bends), std::move(maps),
          std::move(consensus)};
}

Consensus siteConsensus(const Site& site, const MapPairs& pairs, const DistinctMaps& maps,
                        const ForEach& forEach) {
  Consensus consensus;
  consensus.graphRuns.resize(site.runs.size());
  if (allOf(site.runs, [](const Run* run) { return run->scans.empty(); })) return consensus;
  const std::vector<std::size_t> counted = standIns(site, maps);
  const CountedRuns runs(site, pairs, counted);
  PoseGraph& graph = consensus.graph;
  addRuns(consensus, site, counted, runs.order);
  addMatches(consensus, site, pairs, forEach);
  agree(consensus, runs.core, forEach);
  if (addOwnToUnconfirmed(consensus, site, forEach)) agree(consensus, runs.core, forEach);
  int round = 0;
  while (round < fitted::kHoldRounds && holdSteps(consensus, site, runs.core, forEach)) ++round;
  if (graph.runs.size() == 1 && site.runs.size() > 1)
    consensus.errors[RunId(0)].seen = 1;  // by its copies
  for (const RunId run : graph.runs.ids())
    if (graph.reference && run != graph.reference)
      consensus.errors[run].givenUp = givenUpBetween(graph, consensus.poses, run, graph.reference);
  addJitter(consensus, site);
  confirmRuns(consensus, site, pairs);
  tellScales(consensus);
  return consensus;
}

}  // namespace roomgraph
