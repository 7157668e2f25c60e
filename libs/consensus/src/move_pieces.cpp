#include "move_pieces.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "graph_terms.h"
#include "roomgraph/align/near_poses.h"

namespace roomgraph {
namespace {

constexpr double kGaveWay = 10;  // half the robust squared residual of a link from which on it did
constexpr int kRounds = 8;
constexpr double kBetter = 1;  // by which the cost must fall, so that rounding decides nothing
constexpr PoseTolerance kSolvers{0.3, 1.5};  // nearer places are left to the solver
constexpr std::size_t kMostPlaces = 24;      // that are tried for a piece

/** A term of the graph, as one of its two submaps sees it. */
struct Tie {
  GraphTerm term;  // the submap's pose in the other, or the other's in it
  std::size_t otherRun = 0;
  std::uint32_t other = 0;
  bool isFromOther = false;  // `term` is other <- this
};

/** Submaps first to last of a run, held together by links that hold. */
struct Piece {
  std::size_t run = 0;
  std::uint32_t first = 0, last = 0;
};

class Mover {
 public:
  Mover(const PoseGraph& graph, SubmapPoses& poses) : graph_(graph), poses_(poses) {
    for (const RunSubmaps& run : graph.runs) ties_.emplace_back(run.submaps.size());
    for (std::size_t r = 0; r < graph.runs.size(); ++r)
      for (const SubmapLink& link : graph.runs[r].links)
        tie(linkTerm(graph.runs[r], link, graph.slack[r]), r, link.from, r, link.to);
    for (std::size_t m = 0; m < graph.matches.size(); ++m) {
      const RunMatches& matches = graph.matches[m];
      for (const SubmapMatch& match : matches.matches)
        tie(matchTerm(match, graph.belief[m]), matches.in, match.in, matches.of, match.submap);
    }
  }

  void move() {
    for (int round = 0; round < kRounds; ++round) {
      bool hasMoved = false;
      for (const Piece& piece : pieces()) hasMoved |= place(piece);
      if (!hasMoved) return;
    }
  }

 private:
  void tie(const GraphTerm& term, std::size_t fromRun, std::uint32_t from, std::size_t toRun,
           std::uint32_t to) {
    ties_[toRun][to].push_back({term, fromRun, from, true});
    ties_[fromRun][from].push_back({term, toRun, to, false});
  }

  /** All pieces of all runs, smallest first. */
  std::vector<Piece> pieces() const {
    std::vector<Piece> all;
    for (std::size_t r = 0; r < graph_.runs.size(); ++r) {
      const RunSubmaps& run = graph_.runs[r];
      if (!run.areScans || run.submaps.empty() || r == graph_.reference) continue;
      std::vector<Piece> ofRun{{r, 0, 0}};
      for (const SubmapLink& link : run.links) {
        const GraphTerm term = linkTerm(run, link, graph_.slack[r]);
        if (term.cost(poses_[r][link.from], poses_[r][link.to]) > kGaveWay)
          ofRun.push_back({r, link.to, link.to});
        ofRun.back().last = link.to;
      }
      // All before a link that gave way, and all behind it, may belong elsewhere together.
      const std::size_t count = ofRun.size();
      for (std::size_t i = 1; i < count; ++i) {
        ofRun.push_back({r, 0, ofRun[i].first - 1});
        ofRun.push_back({r, ofRun[i].first, std::uint32_t(run.submaps.size() - 1)});
      }
      if (count > 1)
        ofRun.push_back({r, 0, std::uint32_t(run.submaps.size() - 1)});
      else
        ofRun.front().last = std::uint32_t(run.submaps.size() - 1);
      all.insert(all.end(), ofRun.begin(), ofRun.end());
    }
    std::stable_sort(all.begin(), all.end(), [](const Piece& l, const Piece& r) {
      return l.last - l.first < r.last - r.first;
    });
    return all;
  }

  bool isIn(const Piece& piece, const Tie& tie) const {
    return tie.otherRun == piece.run && tie.other >= piece.first && tie.other <= piece.last;
  }

  /** What ties the piece to all else costs once it has been moved (site <- site). */
  double costOf(const Piece& piece, const Transform2D& motion) const {
    double sum = 0;
    for (std::uint32_t k = piece.first; k <= piece.last; ++k) {
      const Transform2D pose = motion * poses_[piece.run][k];
      for (const Tie& tie : ties_[piece.run][k]) {
        if (isIn(piece, tie)) continue;
        const Transform2D& other = poses_[tie.otherRun][tie.other];
        sum += tie.isFromOther ? tie.term.cost(other, pose) : tie.term.cost(pose, other);
      }
    }
    return sum;
  }

  /** Motions that bring the piece to where one of its ties would have it, links first. */
  std::vector<Transform2D> motionsOf(const Piece& piece) const {
    std::vector<Transform2D> motions;
    const Point middle = poses_[piece.run][(piece.first + piece.last) / 2].shift();
    const auto offer = [&](std::uint32_t k, const Tie& tie) {
      if (isIn(piece, tie) || motions.size() >= kMostPlaces) return;
      const Transform2D& other = poses_[tie.otherRun][tie.other];
      const Transform2D wanted =
          other * (tie.isFromOther ? tie.term.measured : tie.term.measured.inverse());
      const Transform2D motion = wanted * poses_[piece.run][k].inverse();
      const auto isKnown = [&](const Transform2D& known) {
        return areNear(known, motion, middle, kSameStart);
      };
      if (!areNear({}, motion, middle, kSolvers) &&
          std::none_of(motions.begin(), motions.end(), isKnown))
        motions.push_back(motion);
    };
    for (const bool isLink : {true, false})
      for (std::uint32_t k = piece.first; k <= piece.last; ++k)
        for (const Tie& tie : ties_[piece.run][k])
          if ((tie.otherRun == piece.run) == isLink) offer(k, tie);
    return motions;
  }

  bool place(const Piece& piece) {
    double best = costOf(piece, {}) - kBetter;
    std::optional<Transform2D> chosen;
    for (const Transform2D& motion : motionsOf(piece))
      if (const double cost = costOf(piece, motion); cost < best) best = cost, chosen = motion;
    if (!chosen) return false;
    for (std::uint32_t k = piece.first; k <= piece.last; ++k)
      poses_[piece.run][k] = *chosen * poses_[piece.run][k];
    return true;
  }

  const PoseGraph& graph_;
  SubmapPoses& poses_;
  std::vector<std::vector<std::vector<Tie>>> ties_;  // [run][submap]
};

}  // namespace

void movePieces(const PoseGraph& graph, SubmapPoses& poses) { Mover(graph, poses).move(); }

}  // namespace roomgraph
