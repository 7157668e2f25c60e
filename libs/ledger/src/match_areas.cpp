#include "match_areas.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "fitted_ledger.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

// From where a room should be: as far as it is looked for, and its neighbours the same.
constexpr double kMostSurprise = 2 * kWideSearch.reach;

class Matching {
 public:
  Matching(const RoomSet& rooms, const RoomFits& fits, const GridFrame& frame, const RunAreas& run)
      : rooms_(rooms), frame_(frame), run_(run), fits_(fits) {
    areaOf_.resize(rooms.shapes.size());
  }

  std::vector<AreaMatch> run() {
    assign();
    for (int round = 1; round < fitted::kMatchRounds; ++round) {
      for (std::size_t s = 0; s < fits_.size(); ++s) lookBesideNeighbours(s);
      assign();
    }
    matches_.resize(fits_.size());
    for (std::size_t s = 0; s < fits_.size(); ++s) setMatch(s);
    for (std::size_t s = 0; s < fits_.size(); ++s) addPieces(s);
    merge();
    return std::move(matches_);
  }

 private:
  const ShapeFit* fitOf(std::size_t s) const {
    return areaOf_[s] ? &fits_[s].at(*areaOf_[s]) : nullptr;
  }

  /** The neighbours of a room that have an area, and those of them whose area is open to one. */
  struct Neighbourhood {
    double open = 0, all = 0;
    double share() const { return all > 0 ? open / all : 0; }
  };

  Neighbourhood neighbourhood(std::size_t s, std::size_t area) const {
    Neighbourhood result;
    for (const std::size_t n : rooms_.neighbours[s]) {
      if (!areaOf_[n]) continue;
      ++result.all;
      if (run_.isOpenTo(area, *areaOf_[n])) ++result.open;
    }
    return result;
  }

  void assign() {
    std::vector<std::tuple<double, std::size_t, std::size_t>> offers;  // -value, room, area
    for (std::size_t s = 0; s < fits_.size(); ++s) {
      const Point expected = guessOf(s).shift;
      for (const auto& [area, fit] : fits_[s]) {
        const Neighbourhood near = neighbourhood(s, area);
        // A bent corridor overlaps little, but the same rooms open to it.
        const bool isKnownByDoors = near.open >= fitted::kFewDoors && near.share() >= 0.5;
        if (fit.overlap < kMinOverlap && !isKnownByDoors) continue;
        double value = fit.overlap + fitted::kNeighbourBonus * near.share();
        if (run_.shapes[area].isCorridor != rooms_.shapes[s].isCorridor)
          value -= fitted::kOtherKindCost;
        value -=
            fitted::kSurpriseCost * std::min(kMostSurprise, distance(fit.move.shift, expected));
        offers.emplace_back(-value, s, area);
      }
    }
    std::sort(offers.begin(), offers.end());
    areaOf_.assign(fits_.size(), std::nullopt);
    isTaken_.assign(run_.shapes.size(), false);
    for (const auto& [value, s, area] : offers)
      if (!areaOf_[s] && !isTaken_[area]) areaOf_[s] = area, isTaken_[area] = true;
  }

  void lookBesideNeighbours(std::size_t s) {
    const Point middle = rooms_.shapes[s].middle;
    if (const ShapeFit* fit = fitOf(s); fit && fit->overlap >= kWideSearch.good) return;
    std::vector<RoomMove> starts;
    for (const std::size_t n : rooms_.neighbours[s]) {
      const ShapeFit* fit = fitOf(n);
      if (!fit) continue;
      const RoomMove start = moveOf(fit->move.about(rooms_.shapes[n].middle), middle);
      const bool isNew = !anyOf(starts, [&](const RoomMove& other) {
        return distance(other.shift, start.shift) < kSameStart.place;
      });
      if (isNew && norm(start.shift) >= kSameStart.place) starts.push_back(start);
    }
    addFreeAreas(s, starts);
    if (starts.empty()) return;
    for (const auto& [area, fit] : fitShape(rooms_.shapes[s], frame_, run_, starts, kNearSearch)) {
      ShapeFit& known = fits_[s][area];
      if (fit.overlap > known.overlap) known = fit;
    }
  }

  /** Starts at areas without a room that lie behind the neighbours' doors, not far from where the
   *  nearest room with an area says. */
  void addFreeAreas(std::size_t s, std::vector<RoomMove>& starts) const {
    if (areaOf_[s]) return;
    const RoomMove guess = guessOf(s);
    const Point expected = rooms_.shapes[s].middle + guess.shift;
    for (const std::size_t n : rooms_.neighbours[s]) {
      if (!areaOf_[n]) continue;
      for (const AreaDoor& door : run_.doors[*areaOf_[n]]) {
        const Point middle = run_.shapes[door.to].middle;
        if (isTaken_[door.to] || distance(middle, expected) > kMostSurprise) continue;
        starts.push_back({middle - rooms_.shapes[s].middle, guess.turn});
      }
    }
  }

  /** Where a room should lie by the others: as the nearest neighbour with an area, else room. */
  RoomMove guessOf(std::size_t s) const {
    const Point middle = rooms_.shapes[s].middle;
    const auto nearest = [&](const std::vector<std::size_t>& among) {
      std::optional<std::size_t> best;
      for (const std::size_t n : among) {
        if (n == s || !areaOf_[n]) continue;
        if (!best || squaredNorm(rooms_.shapes[n].middle - middle) <
                         squaredNorm(rooms_.shapes[*best].middle - middle))
          best = n;
      }
      return best;
    };
    std::optional<std::size_t> guide = nearest(rooms_.neighbours[s]);
    if (!guide) guide = nearest(numbersFrom(0, fits_.size()));
    if (!guide) return {};
    return moveOf(fitOf(*guide)->move.about(rooms_.shapes[*guide].middle), middle);
  }

  void setMatch(std::size_t s) {
    AreaMatch& match = matches_[s];
    if (const ShapeFit* fit = fitOf(s)) {
      match.areas = {*areaOf_[s]};
      match.move = fit->move;
      match.overlap = fit->overlap;
    } else {
      match.move = guessOf(s);
    }
    const Footprint print = footprint(rooms_.shapes[s], match.move, frame_, run_, buffer_);
    if (print.samples == 0) return;
    match.known = print.known / print.samples;
    match.free = print.free / print.samples;
  }

  double sizeOf(std::size_t area) const { return double(run_.shapes[area].size); }

  void addPieces(std::size_t s) {
    AreaMatch& match = matches_[s];
    const Footprint print = footprint(rooms_.shapes[s], match.move, frame_, run_, buffer_);
    std::vector<std::pair<double, std::size_t>> pieces;  // -size, area
    double together = 0;
    for (const auto& [area, count] : print.in)
      if (!isTaken_[area] && count >= fitted::kMinInside * sizeOf(area)) {
        pieces.emplace_back(-count, area);
        together += count;
      }
    if (!match.isMatched() && together < 0.5 * print.known) return;
    std::sort(pieces.begin(), pieces.end());
    for (const auto& [count, area] : pieces) {
      match.areas.push_back(area);
      isTaken_[area] = true;
    }
  }

  /** Gives rooms that have no area the one that holds them, if it is large enough for all. */
  void merge() {
    std::map<std::size_t, std::vector<std::size_t>> held;  // rooms by area
    for (std::size_t s = 0; s < matches_.size(); ++s) {
      if (matches_[s].isMatched()) continue;
      const Footprint print = footprint(rooms_.shapes[s], matches_[s].move, frame_, run_, buffer_);
      for (const auto& [area, count] : print.in)
        if (print.known >= 0.5 * print.samples && count >= fitted::kMinInside * print.known)
          held[area].push_back(s);
    }
    for (auto& [area, rooms] : held) {
      const std::size_t without = rooms.size();
      for (std::size_t s = 0; s < areaOf_.size(); ++s)
        if (areaOf_[s] == area) rooms.push_back(s);
      double size = 0;
      for (const std::size_t s : rooms) size += double(rooms_.shapes[s].size);
      if (sizeOf(area) < fitted::kMinContainer * size) continue;
      for (std::size_t i = 0; i < rooms.size(); ++i) {
        AreaMatch& match = matches_[rooms[i]];
        match.isMerged = true;
        if (i < without) match.areas = {area};
      }
    }
  }

  const RoomSet& rooms_;
  const GridFrame& frame_;
  const RunAreas& run_;
  RoomFits fits_;
  std::vector<std::optional<std::size_t>> areaOf_;
  std::vector<bool> isTaken_;
  std::vector<AreaMatch> matches_;
  LabelCounts buffer_;
};

}  // namespace

void addFits(const std::vector<SiteShape>& rooms, const GridFrame& frame, const RunAreas& run,
             RoomFits& fits) {
  while (fits.size() < rooms.size()) fits.push_back(fitShape(rooms[fits.size()], frame, run, {{}}));
}

std::vector<AreaMatch> matchAreas(const RoomSet& rooms, const RoomFits& fits,
                                  const GridFrame& frame, const RunAreas& run) {
  return Matching(rooms, fits, frame, run).run();
}

}  // namespace roomgraph
