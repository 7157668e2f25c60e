#include "consensus_rooms.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fitted_ledger.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/grid/polygon_cells.h"

namespace roomgraph {
namespace {

/** Where a few beams have looked through a window or a slit: a narrow end of corridor that leads
 *  nowhere. Each run has others, so they are no places of the site. */
bool isGap(const RunAreas& run, std::size_t area) {
  const SiteShape& shape = run.shapes[area];
  const std::vector<AreaDoor>& doors = run.doors[area];
  const bool leadsNowhere =
      allOf(doors, [&](const AreaDoor& door) { return door.to == doors.front().to; });
  return shape.isCorridor && leadsNowhere &&
         2 * shape.area < fitted::kNarrow * perimeter(shape.polygon);
}

struct Candidate {
  ConsensusRooms::Source source;
  double support = 0;
  double power = 0;  ///< sum over the voters of their squared weights
  std::size_t voters = 0;
};

class Choosing {
 public:
  Choosing(const SiteAreas& site, const ForEach& forEach)
      : site_(site),
        forEach_(forEach),
        order_(numbersFrom(0, site.runs.size())),
        isCovered_(site.frame.cellCount()),
        fits_(site.runs.size()) {
    sortDownBy(order_, [&](std::size_t run) { return site_.runs[run].weight; });
  }

  ConsensusRooms run() {
    double all = 0;
    for (const RunAreas& one : site_.runs) all += one.weight;
    choose(candidates({}),
           [&](const Candidate& c) { return c.voters >= 2 || 2 * c.support >= all; });
    match();
    const double second = powerOf(order_[std::min<std::size_t>(1, order_.size() - 1)]);
    choose(candidates(leftAreas()),
           [&](const Candidate& c) { return c.power >= fitted::kLeastPower * second; });
    match();
    return std::move(result_);
  }

 private:
  using Left = std::vector<std::vector<bool>>;  // by run and area

  double powerOf(std::size_t run) const { return site_.runs[run].weight * site_.runs[run].weight; }

  bool isCandidate(const Left& left, std::size_t run, std::size_t area) const {
    return site_.runs[run].shapes[area].area >= fitted::kMinCandidate &&
           !isGap(site_.runs[run], area) && (left.empty() || left[run][area]);
  }

  /** The areas of the most trusted runs with the votes of those runs, best first. */
  std::vector<Candidate> candidates(const Left& left) const {
    std::vector<std::pair<std::size_t, std::size_t>> places;  // voter, area
    const std::size_t voters = std::min(order_.size(), kMaxVoters);
    for (std::size_t v = 0; v < voters; ++v)
      for (std::size_t a = 0; a < site_.runs[order_[v]].shapes.size(); ++a)
        if (isCandidate(left, order_[v], a)) places.emplace_back(v, a);
    std::vector<Candidate> all(places.size());
    forEach_(places.size(), [&](std::size_t i) {
      all[i] = candidate(places[i].first, places[i].second, voters, left);
    });
    sortBy(all, [&](const Candidate& c) {
      return std::make_tuple(-c.support, -site_.runs[c.source.run].shapes[c.source.area].area);
    });
    return all;
  }

  Candidate candidate(std::size_t v, std::size_t area, std::size_t voters, const Left& left) const {
    const std::size_t own = order_[v];
    Candidate c{{own, area}, site_.runs[own].weight, powerOf(own), 1};
    const SiteShape shape = sampled(site_.runs[own].shapes[area], site_.frame);
    for (std::size_t other = 0; other < voters; ++other) {
      const std::size_t j = order_[other];
      if (j == own) continue;
      double best = 0;
      for (const auto& [b, fit] : fitShape(shape, site_.frame, site_.runs[j], {{}}, kRoughSearch))
        if (isCandidate(left, j, b)) best = std::max(best, fit.overlap);
      if (best < kMajority) continue;
      c.support += site_.runs[j].weight * best;
      c.power += powerOf(j);
      ++c.voters;
    }
    return c;
  }

  double coveredShare(const SiteShape& shape) const {
    std::size_t covered = 0;
    for (const Point p : shape.samples) covered += isCovered_[cellIndexAt(site_.frame, p)];
    return shape.samples.empty() ? 1 : double(covered) / double(shape.samples.size());
  }

  template <class Accepts>
  void choose(const std::vector<Candidate>& candidates, const Accepts& accepts) {
    for (const Candidate& c : candidates) {
      if (!accepts(c)) continue;
      SiteShape shape = sampled(site_.runs[c.source.run].shapes[c.source.area], site_.frame);
      if (coveredShare(shape) > fitted::kMaxCovered) continue;
      result_.rooms.shapes.push_back(std::move(shape));
      result_.sources.push_back(c.source);
      cover(site_.runs[c.source.run], c.source.area);
    }
  }

  void cover(const RunAreas& run, std::size_t area) {
    for (const Cell c : cellsIn(run.shapes[area].polygon, site_.frame)) {
      const std::size_t i = site_.frame.index(c);
      if (run.labels[i] == RunAreas::firstArea + area) isCovered_[i] = 1;
    }
  }

  void match() {
    result_.rooms.neighbours.assign(result_.rooms.shapes.size(), {});
    matchRuns();
    findNeighbours();
    matchRuns();
  }

  void matchRuns() {
    result_.matches.assign(site_.runs.size(), {});
    forEach_(site_.runs.size(), [&](std::size_t i) {
      addFits(result_.rooms.shapes, site_.frame, site_.runs[i], fits_[i]);
      result_.matches[i] = matchAreas(result_.rooms, fits_[i], site_.frame, site_.runs[i]);
    });
  }

  /** Two rooms are neighbours where most runs, by weight, say so. */
  void findNeighbours() {
    const std::size_t n = result_.rooms.shapes.size();
    for (std::size_t s = 0; s < n; ++s)
      for (std::size_t t = 0; t < n; ++t) {
        double open = 0, all = 0;
        for (std::size_t i = 0; i < site_.runs.size() && s != t; ++i) {
          const AreaMatch &a = result_.matches[i][s], &b = result_.matches[i][t];
          if (!a.isMatched() || !b.isMatched() || a.isMerged || b.isMerged) continue;
          all += site_.runs[i].weight;
          if (site_.runs[i].isOpenTo(a.areas[0], b.areas[0])) open += site_.runs[i].weight;
        }
        if (open > 0.5 * all) result_.rooms.neighbours[s].push_back(t);
      }
  }

  Left leftAreas() const {
    Left left;
    for (std::size_t i = 0; i < site_.runs.size(); ++i) {
      left.emplace_back(site_.runs[i].shapes.size(), true);
      for (const AreaMatch& match : result_.matches[i])
        for (const std::size_t area : match.areas) left[i][area] = false;
    }
    return left;
  }

  const SiteAreas& site_;
  const ForEach& forEach_;
  std::vector<std::size_t> order_;  // runs, most trusted first
  std::vector<std::uint8_t> isCovered_;
  std::vector<RoomFits> fits_;  // by run
  ConsensusRooms result_;
};

}  // namespace

ConsensusRooms consensusRooms(const SiteAreas& site, const ForEach& forEach) {
  if (site.runs.empty()) return {};
  return Choosing(site, forEach).run();
}

}  // namespace roomgraph
