#include "roomgraph/relate/site_poses.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <optional>
#include <utility>

namespace roomgraph {
namespace {

/** How `b` lies in `a`, whichever of both the pair names first. */
Transform2D seenFrom(const PairPoses& pairs, std::size_t a, std::size_t b) {
  return a < b ? pairs(a, b).pose : pairs(a, b).pose.inverse();
}

/** Confidence, raised by each third run over which the same pose comes out, and lowered by each
 *  over which another one does. */
double trustIn(const PairPoses& pairs, std::size_t a, std::size_t b) {
  const PairPose& pair = pairs(a, b);
  double trust = pair.confidence;
  for (const std::size_t c : pairs.othersOf(a)) {
    if (!pairs.has(c, b)) continue;
    const Transform2D way = seenFrom(pairs, a, c) * seenFrom(pairs, c, b);
    const double d = std::hypot(distance(pair.pose(pair.middle), way(pair.middle)),
                                kTurnLever * wrappedAngle(pair.pose.phi - way.phi)) /
                     (3 * kMaxMisfit);
    trust += pairs(a, c).confidence * pairs(c, b).confidence * (2 / (1 + d * d * d * d) - 1);
  }
  return trust;
}

/** Places one run after the other, each over the most trusted pair that reaches it. */
std::vector<Transform2D> tree(const PairPoses& pairs, std::size_t reference) {
  std::vector<double> trust;
  for (const auto& [a, b] : pairs.pairs()) trust.push_back(trustIn(pairs, a, b));
  std::vector<Transform2D> poses(pairs.things());
  std::vector<bool> isPlaced(pairs.things());
  isPlaced[reference] = true;
  for (;;) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < trust.size(); ++i) {
      const auto& [a, b] = pairs.pairs()[i];
      if (isPlaced[a] != isPlaced[b] && (!best || trust[i] > trust[*best])) best = i;
    }
    if (!best) return poses;
    auto [from, to] = pairs.pairs()[*best];
    if (isPlaced[to]) std::swap(from, to);
    poses[to] = poses[from] * seenFrom(pairs, from, to);
    isPlaced[to] = true;
  }
}

/** What a pair says about its two runs, linearised: the misfit of b's middle in a's turned frame
 *  and, times the lever, that of the angle. */
struct Row {
  Eigen::Matrix3d ja, jb;
  Eigen::Vector3d r;
};

Row rowOf(const PairPose& pair, const Transform2D& a, const Transform2D& b) {
  const Point inSite = b(pair.middle), target = a(pair.pose(pair.middle));
  const Point leverB = inSite - b.shift(), leverA = target - a.shift();
  Row row;
  row.r << inSite.x - target.x, inSite.y - target.y,
      kTurnLever * wrappedAngle(b.phi - a.phi - pair.pose.phi);
  row.jb << 1, 0, -leverB.y, 0, 1, leverB.x, 0, 0, kTurnLever;
  row.ja << -1, 0, leverA.y, 0, -1, -leverA.x, 0, 0, -kTurnLever;
  return row;
}

class NormalEquations {
 public:
  explicit NormalEquations(std::size_t runs)
      : n_(3 * Eigen::Index(runs)), g_(Eigen::VectorXd::Zero(n_)) {
    for (Eigen::Index i = 0; i < n_; ++i) terms_.emplace_back(i, i, 1e-9);
  }

  void add(std::size_t run, std::size_t other, const Eigen::Matrix3d& block) {
    const Eigen::Index row = 3 * Eigen::Index(run), column = 3 * Eigen::Index(other);
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j) terms_.emplace_back(row + i, column + j, block(i, j));
  }
  void subtract(std::size_t run, const Eigen::Vector3d& gradient) {
    g_.segment<3>(3 * Eigen::Index(run)) -= gradient;
  }

  Eigen::VectorXd solution() const {
    Eigen::SparseMatrix<double> h(n_, n_);
    h.setFromTriplets(terms_.begin(), terms_.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(h).solve(g_);
  }

 private:
  Eigen::Index n_;
  std::vector<Eigen::Triplet<double>> terms_;
  Eigen::VectorXd g_;
};

/** One step of all runs but the reference; how far it moved them. */
double step(const PairPoses& pairs, std::size_t reference, std::vector<Transform2D>& poses) {
  NormalEquations equations(poses.size());
  for (const auto& [a, b] : pairs.pairs()) {
    const PairPose& pair = pairs(a, b);
    const Row row = rowOf(pair, poses[a], poses[b]);
    const double s = row.r.squaredNorm() / (kMaxMisfit * kMaxMisfit);
    const double w = pair.confidence / ((1 + s) * (1 + s));
    equations.add(a, a, w * row.ja.transpose() * row.ja);
    equations.add(b, b, w * row.jb.transpose() * row.jb);
    equations.add(a, b, w * row.ja.transpose() * row.jb);
    equations.add(b, a, w * row.jb.transpose() * row.ja);
    equations.subtract(a, w * row.ja.transpose() * row.r);
    equations.subtract(b, w * row.jb.transpose() * row.r);
  }
  equations.add(reference, reference, Eigen::Matrix3d::Identity() * 1e9);
  const Eigen::VectorXd by = equations.solution();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i == reference) continue;
    const Eigen::Vector3d d = by.segment<3>(3 * Eigen::Index(i));
    Transform2D& pose = poses[i];
    pose = {pose.x + d[0], pose.y + d[1], wrappedAngle(pose.phi + d[2])};
  }
  return by.cwiseAbs().maxCoeff();
}

}  // namespace

std::vector<Transform2D> sitePoses(const PairPoses& pairs, std::size_t reference) {
  std::vector<Transform2D> poses = tree(pairs, reference);
  for (int i = 0; i < 50; ++i)
    if (step(pairs, reference, poses) < 1e-9) break;
  return poses;
}

}  // namespace roomgraph
