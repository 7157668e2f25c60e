#include "move_pieces.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "belief.h"
#include "graph_terms.h"

namespace roomgraph {
namespace {

constexpr double kGaveWay = 10;   // half the robust squared residual of a link from which on it did
constexpr double kDoubted = 0.5;  // belief under which a piece is asked where it would have its run
constexpr int kRounds = 8;
constexpr double kLenient = 4;  // times the noise of matches: what is left over the solver mends
constexpr double kBetter = 1;   // by which the cost must fall, so that rounding decides nothing
constexpr std::size_t kMostPlaces = 24;  // that are tried for a stretch

/** Submaps first to last of a run. */
struct Stretch {
  std::size_t run = 0;
  std::uint32_t first = 0, last = 0;

  bool operator==(const Stretch& o) const {
    return run == o.run && first == o.first && last == o.last;
  }
};

/** A match, as one of its two submaps sees it. */
struct Tie {
  std::size_t piece = 0, match = 0;
};

/** What the matches of a piece say. */
struct PieceSum {
  double cost = 0, borneOut = 0;  // as if all of it were believed
};

class Mover {
 public:
  Mover(const PoseGraph& graph, SubmapPoses& poses)
      : graph_(graph),
        poses_(poses),
        changes_(graph.matches.size()),
        isTouched_(graph.matches.size()) {
    for (const RunSubmaps& run : graph.runs) ties_.emplace_back(run.submaps.size());
    for (std::size_t p = 0; p < graph.matches.size(); ++p) {
      const RunMatches& piece = graph.matches[p];
      sums_.emplace_back();
      states_.emplace_back();
      for (std::size_t m = 0; m < piece.matches.size(); ++m) {
        ties_[piece.of][piece.matches[m].submap].push_back({p, m});
        ties_[piece.in][piece.matches[m].in].push_back({p, m});
        states_[p].push_back(stateOf({p, m}));
        add(sums_[p], states_[p][m], 1);
      }
    }
  }

  void move() {
    for (int round = 0; round < kRounds; ++round) {
      bool hasMoved = false;
      for (const Stretch& stretch : stretches()) hasMoved |= place(stretch);
      if (!hasMoved) return;
    }
  }

 private:
  struct MatchState {
    double cost = 0;
    bool isBorneOut = false;
  };

  const SubmapMatch& matchOf(const Tie& tie) const {
    return graph_.matches[tie.piece].matches[tie.match];
  }

  MatchState stateOf(const Tie& tie) const {
    const RunMatches& piece = graph_.matches[tie.piece];
    const SubmapMatch& match = matchOf(tie);
    return stateAt(match, poses_[piece.in][match.in], poses_[piece.of][match.submap]);
  }

  static MatchState stateAt(const SubmapMatch& match, const Transform2D& in,
                            const Transform2D& of) {
    GraphTerm term = matchTerm(match, 1);
    term.noise = term.noise.times(kLenient);
    const Transform2D found = in.inverse() * of;
    return {term.cost(found), isBorneOut(match, found, kBorneOut)};
  }

  static void add(PieceSum& sum, const MatchState& state, double sign) {
    sum.cost += sign * state.cost, sum.borneOut += sign * state.isBorneOut;
  }

  /** What a piece costs, believed as far as its matches are borne out. */
  double costOf(std::size_t piece, const PieceSum& sum) const {
    const double count = double(graph_.matches[piece].matches.size());
    const double belief = beliefOf(sum.borneOut / count);
    return belief * sum.cost + (1 - belief) * costOfGivingUp(graph_.matches[piece]);
  }

  /** The stretches that may belong elsewhere, shortest first: between links that gave way, all
   *  before and all behind one, whole runs, and what a piece that is doubted was found of. */
  std::vector<Stretch> stretches() const {
    std::vector<Stretch> all;
    for (std::size_t r = 0; r < graph_.runs.size(); ++r) addStretches(r, all);
    for (std::size_t p = 0; p < graph_.matches.size(); ++p) {
      const RunMatches& piece = graph_.matches[p];
      const double share = sums_[p].borneOut / double(piece.matches.size());
      if (!isMovable(piece.of) || beliefOf(share) >= kDoubted) continue;
      const std::uint32_t first = piece.matches.front().submap, last = piece.matches.back().submap;
      addCuts({piece.of, first, last}, all);
    }
    std::stable_sort(all.begin(), all.end(), [](const Stretch& l, const Stretch& r) {
      return l.last - l.first < r.last - r.first;
    });
    return all;
  }

  bool isMovable(std::size_t run) const {
    return graph_.runs[run].areScans && !graph_.runs[run].submaps.empty() &&
           run != graph_.reference;
  }

  std::uint32_t lastOf(std::size_t run) const {
    return std::uint32_t(graph_.runs[run].submaps.size() - 1);
  }

  void addStretches(std::size_t r, std::vector<Stretch>& all) const {
    if (!isMovable(r)) return;
    std::uint32_t first = 0;
    addOnce({r, 0, lastOf(r)}, all);
    for (const SubmapLink& link : graph_.runs[r].links) {
      if (linkCost(r, link, poses_[r][link.from], poses_[r][link.to]) <= kGaveWay) continue;
      addCuts({r, first, link.from}, all);
      first = link.to;
    }
    if (first > 0) addCuts({r, first, lastOf(r)}, all);
  }

  /** A stretch, and all from its ends on either way. */
  void addCuts(const Stretch& stretch, std::vector<Stretch>& all) const {
    addOnce(stretch, all);
    addOnce({stretch.run, 0, stretch.last}, all);
    addOnce({stretch.run, stretch.first, lastOf(stretch.run)}, all);
  }

  static void addOnce(const Stretch& stretch, std::vector<Stretch>& all) {
    if (std::find(all.begin(), all.end(), stretch) == all.end()) all.push_back(stretch);
  }

  double linkCost(std::size_t run, const SubmapLink& link, const Transform2D& from,
                  const Transform2D& to) const {
    return linkTerm(graph_.runs[run], link, graph_.slack[run]).cost(from, to);
  }

  static bool isIn(const Stretch& stretch, std::uint32_t k) {
    return k >= stretch.first && k <= stretch.last;
  }

  /** The links that hold a stretch. */
  template <class Do>
  void eachLinkOf(const Stretch& stretch, const Do& todo) const {
    for (const SubmapLink& link : graph_.runs[stretch.run].links)
      if (isIn(stretch, link.from) != isIn(stretch, link.to)) todo(link);
  }

  /** By how much the cost changes once the stretch has been moved (site <- site). */
  double changeBy(const Stretch& stretch, const Transform2D& motion) {
    double change = 0;
    eachLinkOf(stretch, [&](const SubmapLink& link) {
      const Transform2D &from = poses_[stretch.run][link.from], &to = poses_[stretch.run][link.to];
      change -= linkCost(stretch.run, link, from, to);
      change += isIn(stretch, link.from) ? linkCost(stretch.run, link, motion * from, to)
                                         : linkCost(stretch.run, link, from, motion * to);
    });
    for (std::uint32_t k = stretch.first; k <= stretch.last; ++k) {
      const Transform2D pose = motion * poses_[stretch.run][k];
      for (const Tie& tie : ties_[stretch.run][k]) noteChange(stretch.run, pose, tie);
    }
    for (const std::size_t p : touched_) {
      const PieceSum now{sums_[p].cost + changes_[p].cost,
                         sums_[p].borneOut + changes_[p].borneOut};
      change += costOf(p, now) - costOf(p, sums_[p]);
      changes_[p] = {}, isTouched_[p] = false;
    }
    touched_.clear();
    return change;
  }

  void noteChange(std::size_t run, const Transform2D& pose, const Tie& tie) {
    const RunMatches& piece = graph_.matches[tie.piece];
    const SubmapMatch& match = matchOf(tie);
    PieceSum& change = changes_[tie.piece];
    if (!isTouched_[tie.piece]) touched_.push_back(tie.piece);
    isTouched_[tie.piece] = true;
    const bool isOf = piece.of == run;
    add(change,
        stateAt(match, isOf ? poses_[piece.in][match.in] : pose,
                isOf ? pose : poses_[piece.of][match.submap]),
        1);
    add(change, states_[tie.piece][tie.match], -1);
  }

  /** Motions that bring the stretch to where one of its links or matches would have it. */
  std::vector<Transform2D> motionsOf(const Stretch& stretch) const {
    std::vector<Transform2D> motions;
    const auto& poses = poses_[stretch.run];
    const Point middle = poses[(stretch.first + stretch.last) / 2].shift();
    const auto offer = [&](std::uint32_t k, const Transform2D& wanted) {
      const Transform2D motion = wanted * poses[k].inverse();
      const auto isKnown = [&](const Transform2D& known) {
        return areNear(known, motion, middle, kSameStart);
      };
      if (motions.size() < kMostPlaces && !areNear({}, motion, middle, kBorneOut) &&
          std::none_of(motions.begin(), motions.end(), isKnown))
        motions.push_back(motion);
    };
    eachLinkOf(stretch, [&](const SubmapLink& link) {
      const Transform2D step = stepOf(graph_.runs[stretch.run], link);
      if (isIn(stretch, link.to))
        offer(link.to, poses[link.from] * step);
      else
        offer(link.from, poses[link.to] * step.inverse());
    });
    for (std::uint32_t k = stretch.first; k <= stretch.last; ++k)
      for (const Tie& tie : ties_[stretch.run][k]) offer(k, wantedBy(tie, stretch.run));
    return motions;
  }

  /** Where a match would have the submap of this run. */
  Transform2D wantedBy(const Tie& tie, std::size_t run) const {
    const RunMatches& piece = graph_.matches[tie.piece];
    const SubmapMatch& match = matchOf(tie);
    return piece.of == run ? poses_[piece.in][match.in] * match.pose
                           : poses_[piece.of][match.submap] * match.pose.inverse();
  }

  bool place(const Stretch& stretch) {
    double best = -kBetter;
    std::optional<Transform2D> chosen;
    for (const Transform2D& motion : motionsOf(stretch))
      if (const double change = changeBy(stretch, motion); change < best)
        best = change, chosen = motion;
    if (!chosen) return false;
    for (std::uint32_t k = stretch.first; k <= stretch.last; ++k)
      poses_[stretch.run][k] = *chosen * poses_[stretch.run][k];
    for (std::uint32_t k = stretch.first; k <= stretch.last; ++k)
      for (const Tie& tie : ties_[stretch.run][k]) {
        MatchState& state = states_[tie.piece][tie.match];
        add(sums_[tie.piece], state, -1);
        add(sums_[tie.piece], state = stateOf(tie), 1);
      }
    return true;
  }

  const PoseGraph& graph_;
  SubmapPoses& poses_;
  std::vector<std::vector<std::vector<Tie>>> ties_;  // [run][submap]
  std::vector<std::vector<MatchState>> states_;      // [piece][match]
  std::vector<PieceSum> sums_, changes_;             // of each piece: now, and by a motion
  std::vector<bool> isTouched_;                      // whether changes_ is something
  std::vector<std::size_t> touched_;                 // those pieces
};

}  // namespace

void movePieces(const PoseGraph& graph, SubmapPoses& poses) { Mover(graph, poses).move(); }

}  // namespace roomgraph
