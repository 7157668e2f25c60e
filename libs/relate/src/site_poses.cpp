#include "roomgraph/relate/site_poses.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/PairTable.h"

namespace roomgraph {
namespace {

/** The pair's pose as seen from run `from`: from <- other. */
Transform2D seenFrom(const PairPose& pair, std::size_t from) {
  return pair.a == from ? pair.pose : pair.pose.inverse();
}

/** How far apart two poses a <- b lay the pair's walls [m]. */
double apart(const PairPose& pair, const Transform2D& l, const Transform2D& r) {
  return std::hypot(distance(l(pair.middle), r(pair.middle)),
                    kTurnLever * wrappedAngle(l.phi - r.phi));
}

/** Of each two runs the pair that is used, the first of several; by its index. */
using UsedPairs = PairTable<std::optional<std::size_t>>;

UsedPairs usedPairs(std::size_t runs, const std::vector<PairPose>& pairs) {
  std::vector<PairOfThings> sure;
  for (const PairPose& pair : pairs)
    if (pair.confidence >= kMinPairConfidence) sure.emplace_back(pair.a, pair.b);
  UsedPairs used(runs, sure);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].confidence < kMinPairConfidence) continue;
    if (auto& entry = used(pairs[i].a, pairs[i].b); !entry) entry = i;
  }
  return used;
}

/** Confidence, raised by each third run over which the same pose comes out, and lowered by each
 *  over which another one does. */
double trustIn(const PairPose& pair, const std::vector<PairPose>& pairs, const UsedPairs& used) {
  double trust = pair.confidence;
  for (const std::size_t c : used.othersOf(pair.a)) {
    if (!used.has(c, pair.b)) continue;
    const auto ac = used(pair.a, c), cb = used(c, pair.b);
    const Transform2D way = seenFrom(pairs[*ac], pair.a) * seenFrom(pairs[*cb], c);
    const double d = apart(pair, pair.pose, way) / (3 * kMaxMisfit);
    const double weight = pairs[*ac].confidence * pairs[*cb].confidence;
    trust += weight * (2 / (1 + d * d * d * d) - 1);
  }
  return trust;
}

/** Places one run after the other, each over the most trusted pair that reaches it. */
std::vector<SitePose> tree(const std::vector<PairPose>& pairs, const UsedPairs& used,
                           std::size_t reference) {
  std::vector<double> trust;
  for (const PairPose& pair : pairs) trust.push_back(trustIn(pair, pairs, used));
  std::vector<SitePose> runs(used.things());
  runs[reference].isPlaced = true;
  for (;;) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool isUsed = used(pairs[i].a, pairs[i].b) == i;
      if (!isUsed || runs[pairs[i].a].isPlaced == runs[pairs[i].b].isPlaced) continue;
      if (!best || trust[i] > trust[*best]) best = i;
    }
    if (!best) return runs;
    const PairPose& pair = pairs[*best];
    const std::size_t from = runs[pair.a].isPlaced ? pair.a : pair.b;
    const std::size_t to = from == pair.a ? pair.b : pair.a;
    runs[to] = {runs[from].pose * seenFrom(pair, from), true};
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

/** Normal equations, term by term. */
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
    if (n_ >= 180) {  // the pairs of so many runs are few beside what could be
      Eigen::SparseMatrix<double> h(n_, n_);
      h.setFromTriplets(terms_.begin(), terms_.end());
      return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(h).solve(g_);
    }
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(n_, n_);
    for (const auto& term : terms_) h(term.row(), term.col()) += term.value();
    return h.ldlt().solve(g_);
  }

 private:
  Eigen::Index n_;
  std::vector<Eigen::Triplet<double>> terms_;
  Eigen::VectorXd g_;
};

/** One step of all placed runs but the reference; how far it moved them. */
double step(const std::vector<PairPose>& pairs, const UsedPairs& used, std::size_t reference,
            std::vector<SitePose>& runs) {
  NormalEquations equations(runs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairPose& p = pairs[i];
    if (used(p.a, p.b) != i || !runs[p.a].isPlaced || !runs[p.b].isPlaced) continue;
    const Row row = rowOf(p, runs[p.a].pose, runs[p.b].pose);
    const double s = row.r.squaredNorm() / (kMaxMisfit * kMaxMisfit);
    const double w = p.confidence / ((1 + s) * (1 + s));
    equations.add(p.a, p.a, w * row.ja.transpose() * row.ja);
    equations.add(p.b, p.b, w * row.jb.transpose() * row.jb);
    equations.add(p.a, p.b, w * row.ja.transpose() * row.jb);
    equations.add(p.b, p.a, w * row.jb.transpose() * row.ja);
    equations.subtract(p.a, w * row.ja.transpose() * row.r);
    equations.subtract(p.b, w * row.jb.transpose() * row.r);
  }
  equations.add(reference, reference, Eigen::Matrix3d::Identity() * 1e9);
  const Eigen::VectorXd by = equations.solution();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].isPlaced || i == reference) continue;
    const Eigen::Vector3d d = by.segment<3>(3 * Eigen::Index(i));
    Transform2D& pose = runs[i].pose;
    pose = {pose.x + d[0], pose.y + d[1], wrappedAngle(pose.phi + d[2])};
  }
  return by.cwiseAbs().maxCoeff();
}

void check(std::size_t runs, const std::vector<PairPose>& pairs, std::size_t reference) {
  if (reference >= runs)
    throw UsageError("site_poses: there is no run " + std::to_string(reference));
  for (const PairPose& pair : pairs)
    if (pair.a >= runs || pair.b >= runs || pair.a == pair.b)
      throw UsageError("site_poses: there is no pair of the runs " + std::to_string(pair.a) +
                       " and " + std::to_string(pair.b));
}

}  // namespace

SitePoses sitePoses(std::size_t runs, const std::vector<PairPose>& pairs, std::size_t reference) {
  check(runs, pairs, reference);
  const UsedPairs used = usedPairs(runs, pairs);
  SitePoses out;
  out.runs = tree(pairs, used, reference);
  for (int i = 0; i < 50; ++i)
    if (step(pairs, used, reference, out.runs) < 1e-9) break;
  for (const PairPose& pair : pairs) {
    const SitePose &a = out.runs[pair.a], &b = out.runs[pair.b];
    const bool isPlaced = a.isPlaced && b.isPlaced;
    out.misfit.push_back(isPlaced ? apart(pair, pair.pose, a.pose.inverse() * b.pose) : 0);
  }
  return out;
}

}  // namespace roomgraph
