#include "roomgraph/consensus/pose_graph.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "graph_terms.h"

namespace roomgraph {
namespace {

// From stage to stage the kernels are halved.
constexpr int kStages = 6, kStageSteps = 3, kLastSteps = 18;

/** The pose of one submap in another is as it was measured. */
class RelativePose : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  RelativePose(const Transform2D& measured, const LinkNoise& noise)
      : measured_(measured), noise_(noise) {}

  bool Evaluate(double const* const* poses, double* residuals, double** jacobians) const override {
    const double *a = poses[0], *b = poses[1];
    const double c = std::cos(a[2]), s = std::sin(a[2]), x = b[0] - a[0], y = b[1] - a[1];
    const double place = 1 / noise_.place, turn = 1 / noise_.turn;
    residuals[0] = place * (c * x + s * y - measured_.x);
    residuals[1] = place * (-s * x + c * y - measured_.y);
    residuals[2] = turn * wrappedAngle(b[2] - a[2] - measured_.phi);
    if (!jacobians) return true;
    if (double* j = jacobians[0]) {
      j[0] = -c * place, j[1] = -s * place, j[2] = (-s * x + c * y) * place;
      j[3] = s * place, j[4] = -c * place, j[5] = (-c * x - s * y) * place;
      j[6] = 0, j[7] = 0, j[8] = -turn;
    }
    if (double* j = jacobians[1]) {
      j[0] = c * place, j[1] = s * place, j[2] = 0;
      j[3] = -s * place, j[4] = c * place, j[5] = 0;
      j[6] = 0, j[7] = 0, j[8] = turn;
    }
    return true;
  }

 private:
  Transform2D measured_;
  LinkNoise noise_;
};

/** The axes of a submap lie along those of the building, up to quarter turns. */
class AlongAxes : public ceres::SizedCostFunction<1, 3, 1> {
 public:
  explicit AlongAxes(double turn) : turn_(turn) {}

  bool Evaluate(double const* const* values, double* residuals, double** jacobians) const override {
    residuals[0] = wrappedAngle(4 * (values[0][2] + turn_ - values[1][0])) / 4 / fitted::kAxesTurn;
    if (!jacobians) return true;
    if (double* j = jacobians[0]) j[0] = 0, j[1] = 0, j[2] = 1 / fitted::kAxesTurn;
    if (double* j = jacobians[1]) j[0] = -1 / fitted::kAxesTurn;
    return true;
  }

 private:
  double turn_;
};

/** The direction that the axes of most submaps have [rad]. */
double axesOfAll(const std::vector<RunSubmaps>& runs, const SubmapPoses& poses) {
  double cosine = 0, sine = 0;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::size_t k = 0; k < poses[r].size(); ++k)
      if (const auto& axes = runs[r].submaps[k].axes) {
        cosine += axes->weight * std::cos(4 * (poses[r][k].phi + axes->turn));
        sine += axes->weight * std::sin(4 * (poses[r][k].phi + axes->turn));
      }
  return std::atan2(sine, cosine) / 4;
}

class Solver {
 public:
  Solver(const PoseGraph& graph, SubmapPoses start) : graph_(graph) {
    values_.resize(start.size());
    for (std::size_t r = 0; r < start.size(); ++r)
      for (const Transform2D& pose : start[r]) values_[r].push_back({pose.x, pose.y, pose.phi});
    axes_ = axesOfAll(graph.runs, start);
    for (std::size_t r = 0; r < graph.runs.size(); ++r) addRun(r);
    for (std::size_t m = 0; m < graph.matches.size(); ++m) addMatches(m);
    hold();
  }

  PoseGraphSolution solve(StartIs startIs) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    options.logging_type = ceres::SILENT;
    options.function_tolerance = 1e-4;
    ceres::Solver::Summary summary;
    double widening = startIs == StartIs::good ? 1 : fitted::kFirstWidening;
    for (int stage = startIs == StartIs::good ? kStages - 1 : 0; stage < kStages; ++stage) {
      const bool isLast = stage + 1 == kStages;
      options.max_num_iterations = isLast ? kLastSteps : kStageSteps;
      widenKernels(isLast ? 1 : widening);
      ceres::Solve(options, &problem_, &summary);
      widening = std::max(1.0, widening / 2);
    }
    return {poses(), summary.final_cost};
  }

 private:
  struct Kernel {
    ceres::LossFunctionWrapper* loss;
    double width, weight;
  };

  ceres::LossFunction* kernel(double width, double weight) {
    auto* loss = new ceres::LossFunctionWrapper(nullptr, ceres::TAKE_OWNERSHIP);
    kernels_.push_back({loss, width, weight});
    return loss;  // the problem takes it
  }

  void widenKernels(double factor) {
    for (const Kernel& kernel : kernels_)
      kernel.loss->Reset(new ceres::ScaledLoss(new ceres::CauchyLoss(kernel.width * factor),
                                               kernel.weight, ceres::TAKE_OWNERSHIP),
                         ceres::TAKE_OWNERSHIP);
  }

  double* value(std::size_t run, std::uint32_t submap) { return values_[run][submap].data(); }

  void addRun(std::size_t r) {
    const RunSubmaps& run = graph_.runs[r];
    for (const SubmapLink& link : run.links)
      addTerm(linkTerm(run, link, graph_.slack[r]), value(r, link.from), value(r, link.to));
    for (std::uint32_t k = 0; k < run.submaps.size(); ++k)
      if (const auto& axes = run.submaps[k].axes)
        problem_.AddResidualBlock(new AlongAxes(axes->turn),
                                  new ceres::ScaledLoss(new ceres::TukeyLoss(fitted::kAxesWidth),
                                                        axes->weight, ceres::TAKE_OWNERSHIP),
                                  value(r, k), &axes_);
  }

  void addMatches(std::size_t m) {
    const RunMatches& matches = graph_.matches[m];
    for (const SubmapMatch& match : matches.matches)
      addTerm(matchTerm(match, graph_.belief[m]), value(matches.in, match.in),
              value(matches.of, match.submap));
  }

  void addTerm(const GraphTerm& term, double* from, double* to) {
    problem_.AddResidualBlock(new RelativePose(term.measured, term.noise),
                              kernel(term.width, term.weight), from, to);
  }

  /** Keeps in place what nothing else would. */
  void hold() {
    const std::size_t fixed = graph_.reference.value_or(0);
    for (std::size_t k = 0; k < values_[fixed].size(); ++k) {
      double* pose = values_[fixed][k].data();
      if ((k == 0 || graph_.reference) && problem_.HasParameterBlock(pose))
        problem_.SetParameterBlockConstant(pose);
    }
  }

  SubmapPoses poses() const {
    SubmapPoses all(values_.size());
    for (std::size_t r = 0; r < values_.size(); ++r)
      for (const auto& value : values_[r])
        all[r].push_back({value[0], value[1], wrappedAngle(value[2])});
    return all;
  }

  const PoseGraph& graph_;
  std::vector<std::vector<std::array<double, 3>>> values_;
  double axes_ = 0;
  std::vector<Kernel> kernels_;
  ceres::Problem problem_;
};

}  // namespace

PoseGraphSolution solvePoseGraph(const PoseGraph& graph, SubmapPoses start, StartIs startIs) {
  return Solver(graph, std::move(start)).solve(startIs);
}

double meanStrain(const RunSubmaps& run, const std::vector<Transform2D>& poses) {
  std::vector<double> strains;
  for (const SubmapLink& link : run.links) {
    const Transform2D step = stepOf(run, link);
    const Transform2D now = poses[link.from].inverse() * poses[link.to];
    const LinkNoise noise = linkNoise(step);
    const double place = distance(now.shift(), step.shift()) / noise.place;
    const double turn = wrappedAngle(now.phi - step.phi) / noise.turn;
    strains.push_back((place * place + turn * turn) / 3);
  }
  std::sort(strains.begin(), strains.end());
  strains.resize(std::size_t(fitted::kCountedLinks * double(strains.size())));
  double sum = 0;
  for (const double strain : strains) sum += strain;
  return strains.empty() ? 0 : sum / double(strains.size());
}

}  // namespace roomgraph
