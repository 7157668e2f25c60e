#include "roomgraph/consensus/estimate_map_errors.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/** What a residual costs, and the weight that its square has for the next step. */
struct Kernel {
  double cost = 0, slope = 0;
};

/** An outlier moves little. */
Kernel cauchy(double r, double width) {
  const double s = 1 + (r / width) * (r / width);
  return {width * width / 2 * std::log(s), 1 / s};
}

/** An outlier counts as far as it is off. */
Kernel pseudoHuber(double r, double width) {
  const double s = std::sqrt(1 + (r / width) * (r / width));
  return {width * width * (s - 1), 1 / s};
}

/** What the logs of the errors, and the log of the deviations' free factor behind them, have to
 *  explain. */
class Problem {
 public:
  Problem(const PairBends& bends, const std::vector<std::optional<double>>& deviations,
          std::optional<std::size_t> truth)
      : bends_(bends), n_(Eigen::Index(bends.things())), truth_(truth) {
    for (const auto& deviation : deviations)
      told_.push_back(deviation ? std::optional(fitted::kDeviationPower *
                                                std::log(*deviation + fitted::kDeviationNoise))
                                : std::nullopt);
    if (truth) told_[*truth].reset();
    for (std::size_t i = 0; i < bends.things(); ++i) mostShare_.push_back(mostShare(bends, i));
  }

  /** Half the cost, with its gradient and the normal equations of a step. */
  struct Linearised {
    double cost = 0;
    VectorXd g;
    MatrixXd h;
  };

  Linearised linearise(const VectorXd& x) const {
    Linearised out{0, VectorXd::Zero(n_ + 1), MatrixXd::Zero(n_ + 1, n_ + 1)};
    for (Eigen::Index i = 0; i < n_; ++i) {
      addDeviation(out, x, i);
      for (const std::size_t j : bends_.othersOf(std::size_t(i)))
        if (Eigen::Index(j) > i) addPair(out, x, i, Eigen::Index(j));
    }
    if (truth_) hold(out, Eigen::Index(*truth_));
    return out;
  }

  /** From the median bend of each map on. */
  VectorXd startFromBends() const {
    VectorXd x = VectorXd::Zero(n_ + 1);
    for (Eigen::Index i = 0; i < n_; ++i) x[i] = std::log(std::max(0.7 * medianBend(i), 1e-3));
    return withFactor(clamped(std::move(x)));
  }

  /** From what the maps tell of themselves on, at the same mean. */
  VectorXd startFromDeviations() const {
    const VectorXd before = startFromBends();
    VectorXd x = before;
    for (Eigen::Index i = 0; i < n_; ++i)
      if (told_[std::size_t(i)]) x[i] = *told_[std::size_t(i)] + before[n_];
    return withFactor(clamped(std::move(x)));
  }

  VectorXd clamped(VectorXd x) const {
    const double low = std::log(fitted::kLeastError), high = std::log(kMaxBend);
    for (Eigen::Index i = 0; i < n_; ++i) x[i] = std::clamp(x[i], low, high);
    if (truth_) x[Eigen::Index(*truth_)] = low;
    return x;
  }

 private:
  /** Keeps one of the unknowns where it is. */
  void hold(Linearised& out, Eigen::Index i) const {
    out.g[i] = 0;
    out.h.row(i).setZero(), out.h.col(i).setZero();
    out.h(i, i) = 1;
  }

  double medianBend(Eigen::Index i) const {
    std::vector<double> all;
    for (const std::size_t j : bends_.othersOf(std::size_t(i)))
      if (bendOf(i, Eigen::Index(j)).share > 0) all.push_back(bendOf(i, Eigen::Index(j)).bend);
    return all.empty() ? 0 : median(all);
  }

  /** Sets the free factor to what suits the errors. */
  VectorXd withFactor(VectorXd x) const {
    double sum = 0, count = 0;
    for (Eigen::Index i = 0; i < n_; ++i)
      if (told_[std::size_t(i)])
        sum += std::log(std::exp(x[i]) + fitted::kErrorNoise) - *told_[std::size_t(i)], ++count;
    x[n_] = count > 0 ? sum / count : 0;
    return x;
  }

  const PairBend& bendOf(Eigen::Index i, Eigen::Index j) const {
    return bends_(std::size_t(i), std::size_t(j));
  }

  void addPair(Linearised& out, const VectorXd& x, Eigen::Index i, Eigen::Index j) const {
    const PairBend& pair = bendOf(i, j);
    if (pair.share <= 0) return;
    const double vi = std::exp(2 * x[i]), vj = std::exp(2 * x[j]), both = std::sqrt(vi + vj);
    const double r = std::log((pair.bend + fitted::kBendNoise) / (both + fitted::kBendNoise));
    const auto [cost, slope] =
        r > 0 ? cauchy(r, fitted::kBendAbove) : pseudoHuber(r, fitted::kBendBelow);
    const double w = pair.share * slope;
    out.cost += pair.share * cost;
    const double scale = 1 / (both * (both + fitted::kBendNoise));
    const double ji = -vi * scale, jj = -vj * scale;
    out.g[i] += w * r * ji, out.g[j] += w * r * jj;
    out.h(i, i) += w * ji * ji, out.h(j, j) += w * jj * jj;
    out.h(i, j) += w * ji * jj, out.h(j, i) += w * ji * jj;
  }

  void addDeviation(Linearised& out, const VectorXd& x, Eigen::Index i) const {
    if (!told_[std::size_t(i)]) return;
    const double e = std::exp(x[i]);
    const double r = std::log(e + fitted::kErrorNoise) - *told_[std::size_t(i)] - x[n_];
    const double share = r > 0 ? mostShare_[std::size_t(i)] : 1;
    const auto [cost, slope] = cauchy(r, fitted::kDeviationWidth);
    const double w = fitted::kDeviationWeight * share * share * slope;
    const double j = e / (e + fitted::kErrorNoise);
    out.cost += fitted::kDeviationWeight * share * share * cost;
    out.g[i] += w * r * j, out.g[n_] -= w * r;
    out.h(i, i) += w * j * j, out.h(n_, n_) += w;
    out.h(i, n_) -= w * j, out.h(n_, i) -= w * j;
  }

  const PairBends& bends_;
  Eigen::Index n_;
  std::optional<std::size_t> truth_;
  std::vector<std::optional<double>> told_;  // log of what the deviation tells
  // A small piece of a site deviates little, which says nothing of it; one that deviates much is
  // bad.
  std::vector<double> mostShare_;
};

struct ErrorSolution {
  VectorXd x;
  double cost = 0;
};

/** Levenberg and Marquardt. */
ErrorSolution solve(const Problem& problem, VectorXd x) {
  Problem::Linearised here = problem.linearise(x);
  double damping = 1e-3;
  for (int i = 0; i < 200 && damping < 1e6; ++i) {
    MatrixXd h = here.h;
    h.diagonal().array() += damping;
    const VectorXd next = problem.clamped(x - h.ldlt().solve(here.g));
    const Problem::Linearised there = problem.linearise(next);
    if (there.cost > here.cost) {
      damping *= 4;
      continue;
    }
    const double moved = (next - x).cwiseAbs().maxCoeff();
    x = next, here = there;
    damping = std::max(1e-6, damping / 4);
    if (moved < 1e-9) break;
  }
  return {x, here.cost};
}

bool hasPair(const PairBends& bends, std::size_t i) {
  const std::vector<std::size_t>& others = bends.othersOf(i);
  return anyOf(others, [&](std::size_t j) { return bends(i, j).share > 0; });
}

/** `error` with an interval for a standard deviation of its log. */
MapError withInterval(double error, double deviation) {
  const double factor = std::exp(kEightyPercent * deviation);
  MapError result;
  result.error = error, result.low = error / factor, result.high = error * factor;
  return result;
}

}  // namespace

std::vector<std::optional<MapError>> estimateMapErrors(
    const PairBends& bends, const std::vector<std::optional<double>>& deviations,
    std::optional<std::size_t> truth) {
  std::vector<std::optional<MapError>> errors(bends.things());
  if (bends.things() < 2) return errors;
  const Problem problem(bends, deviations, truth);
  ErrorSolution best = solve(problem, problem.startFromBends());
  const ErrorSolution other = solve(problem, problem.startFromDeviations());
  if (other.cost < best.cost) best = other;
  MatrixXd h = problem.linearise(best.x).h;
  h.diagonal().array() += 1e-3;  // for what nothing tells
  const MatrixXd covariance = h.inverse();
  for (std::size_t i = 0; i < bends.things(); ++i) {
    if (i == truth || !hasPair(bends, i)) continue;
    const auto k = Eigen::Index(i);
    const double variance = fitted::kErrorSpread * fitted::kErrorSpread * covariance(k, k) +
                            fitted::kLeastErrorSpread * fitted::kLeastErrorSpread;
    errors[i] = withInterval(std::exp(best.x[k]) - fitted::kLeastError, std::sqrt(variance));
    errors[i]->high = std::max(errors[i]->high, fitted::kBendNoise);  // less cannot be told from 0
  }
  return errors;
}

}  // namespace roomgraph
