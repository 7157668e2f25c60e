#include "roomgraph/relate/relate_runs.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "choose_runs.h"
#include "fitted_relate.h"
#include "keep_pairs.h"
#include "roomgraph/align/shared_edges.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/relate/pair_jobs.h"
#include "roomgraph/relate/place_runs.h"
#include "roomgraph/relate/shared_drives.h"

namespace roomgraph {
namespace {

/** The pairs of some runs that have been related so far. */
class RelatedPairs {
 public:
  RelatedPairs(const std::vector<Run>& runs, const RelateRunsOptions& options,
               const ForEach& forEach, const KeptPairs& kept)
      : runs_(runs), options_(options), forEach_(forEach) {
    const auto how = options.areAligned ? "aligned" : options.areOneSite ? "one site" : "searched";
    relate_ =
        keepPairs([this](const PairOver& pair, FullMaps& maps) { return related(pair, maps); },
                  runs, how, kept);
  }

  /** Completes maps in which others will be looked for again and again. */
  void complete(const std::vector<std::size_t>& runs) {
    full_.complete(mapped(runs, [this](std::size_t run) { return &runs_[run].map; }), forEach_);
  }

  /** Relates each of `others` to the hub. */
  void search(std::size_t hub, const std::vector<std::size_t>& others) {
    relate(mapped(others, [&](std::size_t other) { return PairOver{hub, hub, other}; }));
  }

  /** Relates pairs over their hubs, to which both have been related; without one where it is one
   *  of both. */
  void relate(std::vector<PairOver> pairs) {
    for (PairOver& pair : pairs) {
      if (pair.a > pair.b) std::swap(pair.a, pair.b);
      if (options_.areAligned) pair.hub = pair.a;
    }
    eraseIf(pairs, [&](const PairOver& pair) {  // what is known
      return pair.a == pair.b || !found_.try_emplace({pair.a, pair.b}).second;
    });
    const auto runs = mapped(pairs, [](const PairOver& p) { return PairOfThings(p.a, p.b); });
    const auto jobs = pairJobs(runs, [&](std::size_t run) { return mapOf(run).isBare(); });
    forEach_(jobs.size(), [&](std::size_t job) {
      FullMaps maps;
      for (const std::size_t i : jobs[job]) found_.at(runs[i]) = relate_(pairs[i], maps);
    });
  }

  /** The pair with the hub named first. */
  MapPair between(std::size_t hub, std::size_t run) const {
    return hub < run ? found_.at({hub, run}) : swapped(found_.at({run, hub}));
  }

  /** All pairs, which are moved out. */
  MapPairs all() {
    MapPairs all(runs_.size(), mapped(found_, [](const auto& found) { return found.first; }));
    for (auto& [runs, pair] : found_) all(runs.first, runs.second) = std::move(pair);
    return all;
  }

 private:
  const WallMap& mapOf(std::size_t run) const { return full_.known(runs_[run].map); }

  MapPair related(const PairOver& pair, FullMaps& maps) const {
    const WallMap& a = maps(mapOf(pair.a));
    const WallMap& b = maps(mapOf(pair.b));
    if (options_.areAligned) return relateAlignedMaps(a, b);
    if (pair.hub == pair.a || pair.hub == pair.b) return relateMaps(a, b, options_.areOneSite);
    return relateMapsOver(between(pair.hub, pair.a), between(pair.hub, pair.b), a, b);
  }

  const std::vector<Run>& runs_;
  const RelateRunsOptions& options_;
  const ForEach& forEach_;
  RelatePair relate_;
  FullMaps full_;
  std::map<PairOfThings, MapPair> found_;
};

/** Relates runs in sets that may be sites: each to a hub, and to a choice of the others. */
class SiteBySite {
 public:
  SiteBySite(const std::vector<Run>& runs, const RelateRunsOptions& options, RelatedPairs& relating)
      : runs_(runs), options_(options), relating_(relating), order_(byStraightness(runs)) {}

  /** The runs of all cores, ascending. */
  std::vector<std::size_t> relate() {
    while (!order_.empty()) relateFirst();
    std::sort(core_.begin(), core_.end());
    return core_;
  }

 private:
  /** A run that lies in another one of its site. */
  struct Member {
    std::size_t run = 0;
    std::size_t in = 0;  ///< of the core, or the hub itself
    Transform2D pose;    ///< hub <- run
  };

  /** Relates the runs that lie in the first of those that are left, and takes them out. */
  void relateFirst() {
    if (order_.size() <= options_.core) return relateAll();
    const std::size_t hub = order_.front();
    relating_.complete({hub});
    relating_.search(hub, {order_.begin() + 1, order_.end()});
    std::vector<Member> members{{hub, hub, {}}};
    std::vector<std::size_t> lost;
    for (auto run = order_.begin() + 1; run != order_.end(); ++run)
      if (const auto pose = poseIn(hub, *run))
        members.push_back({*run, hub, *pose});
      else
        lost.push_back(*run);
    moveReferenceUp(members);
    const std::vector<std::size_t> core = relateCore(hub, members);
    order_ = seek(core, lost, members);
    relateToJudges(core, members);
  }

  void relateAll() {
    const std::size_t hub = order_.front();
    relating_.complete(order_);
    relating_.search(hub, order_);
    std::vector<PairOver> pairs;
    for (const auto& [a, b] : pairsOf(order_.size())) pairs.push_back({hub, order_[a], order_[b]});
    relating_.relate(pairs);
    core_.insert(core_.end(), order_.begin(), order_.end());
    order_.clear();
  }

  /** hub <- run, if the two are joined. */
  std::optional<Transform2D> poseIn(std::size_t hub, std::size_t run) const {
    const MapPair pair = relating_.between(hub, run);
    if (!isJoined(pair)) return std::nullopt;
    return pair.alignment.pose;
  }

  /** The reference is always in the core of its site, behind the hub. */
  void moveReferenceUp(std::vector<Member>& members) const {
    for (std::size_t i = 2; i < members.size(); ++i)
      if (members[i].run == options_.reference)
        std::rotate(members.begin() + 1, members.begin() + std::ptrdiff_t(i),
                    members.begin() + std::ptrdiff_t(i) + 1);
  }

  std::size_t fixedIn(const std::vector<Member>& members) const {
    return members.size() > 1 && members[1].run == options_.reference ? 2 : 1;
  }

  /** The core of some runs, as their places in `members`, each related to each. */
  std::vector<std::size_t> relateCore(std::size_t hub, const std::vector<Member>& members) {
    std::vector<const Run*> runs;
    std::vector<SeenPlaces> seen;
    for (const Member& member : members) {
      runs.push_back(&runs_[member.run]);
      seen.push_back(seenPlaces(runs.back()->map, member.pose));
    }
    auto core = chooseCore(runs, seen, options_.core, fixedIn(members));
    const auto chosen = mapped(core, [&](std::size_t place) { return members[place].run; });
    relating_.complete(chosen);
    std::vector<PairOver> pairs;
    for (const auto& [a, b] : pairsOf(core.size())) pairs.push_back({hub, chosen[a], chosen[b]});
    relating_.relate(pairs);
    core_.insert(core_.end(), chosen.begin(), chosen.end());
    return core;
  }

  /** Looks for runs that do not lie in the hub in some more of the core; those that were not found
   *  come back, the others become members. */
  std::vector<std::size_t> seek(const std::vector<std::size_t>& core, std::vector<std::size_t> lost,
                                std::vector<Member>& members) {
    for (std::size_t s = 1; s <= std::min(fitted::kSeekers, core.size() - 1); ++s) {
      // Those that were chosen last have seen most that the hub has not.
      const Member seeker = members[core[core.size() - s]];
      relating_.search(seeker.run, lost);
      std::vector<std::size_t> left;
      for (const std::size_t run : lost)
        if (const auto pose = poseIn(seeker.run, run))
          members.push_back({run, seeker.run, seeker.pose * *pose});
        else
          left.push_back(run);
      lost = left;
    }
    return lost;
  }

  /** Relates all members that are not of the core to their judges, and to their first copies. */
  void relateToJudges(const std::vector<std::size_t>& core, const std::vector<Member>& members) {
    std::vector<SeenPlaces> seen;
    for (const std::size_t place : core)
      seen.push_back(seenPlaces(runs_[members[place].run].map, members[place].pose));
    std::vector<PairOver> pairs = copies(members);
    for (const Member& member : members) {
      const SeenPlaces own = seenPlaces(runs_[member.run].map, member.pose);
      for (const std::size_t judge : chooseJudges(own, seen, fitted::kJudges, fixedIn(members)))
        pairs.push_back({member.in, members[core[judge]].run, member.run});
    }
    relating_.relate(pairs);
  }

  /** Each run and the first that has the same map. */
  std::vector<PairOver> copies(const std::vector<Member>& members) const {
    std::map<std::tuple<std::size_t, int, int>, std::vector<const Member*>> alike;
    for (const Member& member : members) {
      const WallMap& map = runs_[member.run].map;
      alike[{map.walls.size(), map.frame.width, map.frame.height}].push_back(&member);
    }
    std::vector<PairOver> pairs;
    for (auto& [size, some] : alike) {
      sortBy(some, &Member::run);
      for (std::size_t i = 0; i < some.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (areIdentical(runs_[some[j]->run].map, runs_[some[i]->run].map)) {
            pairs.push_back({some[j]->run, some[j]->run, some[i]->run});
            break;
          }
    }
    return pairs;
  }

  const std::vector<Run>& runs_;
  const RelateRunsOptions& options_;
  RelatedPairs& relating_;
  std::vector<std::size_t> order_;  // those that are left, the straightest first
  std::vector<std::size_t> core_;
};

}  // namespace

MapPairs relateRuns(const std::vector<Run>& runs, const RelateRunsOptions& options,
                    const ForEach& forEach, const KeptPairs& kept) {
  RelatedPairs relating(runs, options, forEach, kept);
  std::vector<std::size_t> core = SiteBySite(runs, options, relating).relate();
  MapPairs related = relating.all();
  if (!options.areAligned) joinDrives(related, runs, forEach);
  if (core.size() < runs.size()) related.core = std::move(core);
  return related;
}

}  // namespace roomgraph
