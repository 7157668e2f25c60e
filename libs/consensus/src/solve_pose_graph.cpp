#include "roomgraph/consensus/solve_pose_graph.h"

#include <ceres/ceres.h>
#include <ceres/normal_prior.h>

#include <array>
#include <cmath>
#include <vector>

#include "edge_cost.h"
#include "roomgraph/base/sequences.h"
#include "wall_axes.h"

namespace roomgraph {
namespace {

constexpr int kStageSteps = 3;  // until the kernels are halved

/** An angle up to whole periods [rad], within half of one; with the derivatives of Ceres. */
template <typename T>
T upTo(double period, const T& angle) {
  using std::floor;
  return angle - period * floor(angle / period + 0.5);
}

/** The pose of one node in another is as it was measured, but for the stretch of its run. */
struct RelativePose {
  Transform2D measured;
  PoseNoise noise;

  template <typename T>
  bool operator()(const T* a, const T* b, const T* stretch, T* residuals) const {
    using std::cos, std::sin;
    const T c = cos(a[2]), s = sin(a[2]), x = b[0] - a[0], y = b[1] - a[1];
    residuals[0] = (c * x + s * y - *stretch * measured.x) / noise.place;
    residuals[1] = (c * y - s * x - *stretch * measured.y) / noise.place;
    residuals[2] = upTo(2 * M_PI, b[2] - a[2] - measured.phi) / noise.turn;
    return true;
  }
};

/** The axes of a node lie along those of the building, up to quarter turns. */
struct AlongAxes {
  double turn;

  template <typename T>
  bool operator()(const T* pose, const T* direction, T* residual) const {
    *residual = upTo(M_PI / 2, pose[2] + turn - *direction) / fitted::kAxesTurn;
    return true;
  }
};

/** The links of a run are about as long as drawn. */
ceres::CostFunction* usualStretch() {
  return new ceres::NormalPrior(ceres::Matrix::Constant(1, 1, 1 / fitted::kUsualStretch),
                                ceres::Vector::Ones(1));
}

/** The direction of each pair of axes [rad]. */
std::vector<double> directionsOf(const WallAxes& wallAxes, const PoseGraph& graph,
                                 const NodePoses& poses) {
  std::vector<Point> sums(wallAxes.count);
  for (const NodeId node : poses.ids())
    if (const auto pair = wallAxes.ofNode[node]) {
      const ScanAxes& axes = *graph.nodes[node].axes;
      sums[*pair].x += axes.weight * std::cos(4 * (poses[node].phi + axes.turn));
      sums[*pair].y += axes.weight * std::sin(4 * (poses[node].phi + axes.turn));
    }
  return mapped(sums, [](Point sum) { return std::atan2(sum.y, sum.x) / 4; });
}

class Solver {
 public:
  Solver(const PoseGraph& graph, const GraphTrust& trust, const NodePoses& start)
      : graph_(graph),
        trust_(trust),
        wallAxes_(wallAxes(graph, start)),
        axes_(directionsOf(wallAxes_, graph, start)) {
    for (const GraphRun& run : graph.runs) stretches_.add(run.stretch);
    for (const Transform2D& pose : start) values_.add({pose.x, pose.y, pose.phi});
    for (const RunId run : graph.runs.ids()) addRun(run);
    for (const MatchGroup& group : graph.groups)
      for (const PoseEdgeId match : group.edges) addEdge(graph.edges[match], one_);
    hold();
  }

  PoseGraphSolution solve(StartIs startIs) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    options.logging_type = ceres::SILENT;
    options.function_tolerance = 1e-4;
    ceres::Solver::Summary summary;
    int widening = startIs == StartIs::good ? 1 : fitted::kFirstWidening;
    if (startIs == StartIs::good) holdStretches();
    for (; widening >= 1; widening /= 2) {
      options.max_num_iterations = (widening > 1 ? 1 : 8) * kStageSteps;
      widenKernels(widening);
      ceres::Solve(options, &problem_, &summary);
    }
    return {poses(), stretches_, summary.final_cost};
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

  void addRun(RunId id) {
    const GraphRun& run = graph_.runs[id];
    const bool isFree = graph_.showsStretch(id);
    double& stretch = isFree ? stretches_[id] : one_;
    for (const PoseEdgeId link : run.links) addEdge(graph_.edges[link], stretch);
    for (const NodeId node : run.nodes) addAxes(node);
    if (isFree) problem_.AddResidualBlock(usualStretch(), new ceres::CauchyLoss(1), &stretch);
  }

  /** An edge that is stretched so far already, which may become another one. */
  void addEdge(const PoseEdge& edge, double& stretch) {
    if (!takesPart(edge, trust_)) return;
    const EdgeTerm term = termOf(graph_, edge, trust_);
    const Transform2D drawn{edge.measured.x / stretch, edge.measured.y / stretch,
                            edge.measured.phi};
    problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<RelativePose, 3, 3, 3, 1>(
                                  new RelativePose{drawn, term.noise}),
                              kernel(term.width, term.weight), values_[edge.from].data(),
                              values_[edge.to].data(), &stretch);
  }

  void addAxes(NodeId node) {
    const auto pair = wallAxes_.ofNode[node];
    if (!pair) return;
    const ScanAxes& axes = *graph_.nodes[node].axes;
    problem_.AddResidualBlock(
        new ceres::AutoDiffCostFunction<AlongAxes, 1, 3, 1>(new AlongAxes{axes.turn}),
        new ceres::ScaledLoss(new ceres::TukeyLoss(fitted::kAxesWidth), axes.weight,
                              ceres::TAKE_OWNERSHIP),
        values_[node].data(), &axes_[*pair]);
  }

  /** Keeps in place what nothing else would. */
  void hold() {
    if (problem_.HasParameterBlock(&one_)) problem_.SetParameterBlockConstant(&one_);
    const RunId fixed = graph_.reference ? graph_.reference : RunId(0);
    for (const NodeId node : graph_.runs[fixed].nodes) {
      const bool isHeld = graph_.reference || node == graph_.runs[fixed].nodes.front();
      if (isHeld && problem_.HasParameterBlock(values_[node].data()))
        problem_.SetParameterBlockConstant(values_[node].data());
    }
  }

  void holdStretches() {
    for (double& stretch : stretches_)
      if (problem_.HasParameterBlock(&stretch)) problem_.SetParameterBlockConstant(&stretch);
  }

  NodePoses poses() const {
    NodePoses poses;
    for (const auto& value : values_) poses.add({value[0], value[1], wrappedAngle(value[2])});
    return poses;
  }

  const PoseGraph& graph_;
  const GraphTrust& trust_;
  ById<NodeId, std::array<double, 3>> values_;
  WallAxes wallAxes_;
  std::vector<double> axes_;       // directions of its pairs
  ById<RunId, double> stretches_;  // of the links
  double one_ = 1;                 // that of a match
  std::vector<Kernel> kernels_;
  ceres::Problem problem_;
};

}  // namespace

PoseGraphSolution solvePoseGraph(const PoseGraph& graph, const GraphTrust& trust,
                                 const NodePoses& start, StartIs startIs) {
  return Solver(graph, trust, start).solve(startIs);
}

}  // namespace roomgraph
