#include "roomgraph/consensus/pose_covariances.h"

// Ceres works covariances out by a QR decomposition, which with Eigen's takes minutes where the
// Cholesky decomposition of the normal equations takes a tenth of a second.
#include <Eigen/LU>
#include <Eigen/Sparse>

#include "edge_cost.h"

namespace roomgraph {
namespace {

// Information [1/m^2, 1/rad^2] that fixes the first node, or all of the reference. Its inverse
// leaves all others as good as free, but puts each part of the graph somewhere.
constexpr double kFixed = 1e6;

using Eigen::Matrix3d;
using Blocks = std::vector<Eigen::Triplet<double>>;

void addBlock(NodeId row, NodeId column, const Matrix3d& block, Blocks& blocks) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      blocks.emplace_back(3 * int(row.index()) + r, 3 * int(column.index()) + c, block(r, c));
}

/** The normal equations of an edge, by how its measured pose changes with those of its nodes. */
void addEdge(const PoseGraph& graph, const PoseEdge& edge, const GraphTrust& trust,
             const NodePoses& poses, Blocks& blocks) {
  const Transform2D &a = poses[edge.from], &b = poses[edge.to];
  const double c = std::cos(a.phi), s = std::sin(a.phi), x = b.x - a.x, y = b.y - a.y;
  Matrix3d from, to;
  from << -c, -s, -s * x + c * y, s, -c, -c * x - s * y, 0, 0, -1;
  to << c, s, 0, -s, c, 0, 0, 0, 1;
  const PoseInformation known = informationOf(graph, edge, trust, poses);
  Matrix3d weights = Matrix3d::Zero();
  weights.diagonal() << known.place, known.place, known.turn;
  addBlock(edge.from, edge.from, from.transpose() * weights * from, blocks);
  addBlock(edge.to, edge.to, to.transpose() * weights * to, blocks);
  addBlock(edge.from, edge.to, from.transpose() * weights * to, blocks);
  addBlock(edge.to, edge.from, to.transpose() * weights * from, blocks);
}

using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

/** Of the normal equations of all runs. */
void decompose(const PoseGraph& graph, const GraphTrust& trust, const NodePoses& poses,
               Factor& factor) {
  Blocks blocks;
  for (const PoseEdge& edge : graph.edges)
    if (takesPart(edge, trust)) addEdge(graph, edge, trust, poses, blocks);
  for (const NodeId node : poses.ids())
    addBlock(node, node, 1 / kFixed * Matrix3d::Identity(), blocks);
  for (const NodeId node : graph.reference ? graph.runs[graph.reference].nodes : poses.ids()) {
    addBlock(node, node, kFixed * Matrix3d::Identity(), blocks);
    if (!graph.reference) break;
  }
  const auto size = 3 * Eigen::Index(poses.size());
  Eigen::SparseMatrix<double> normal(size, size);
  normal.setFromTriplets(blocks.begin(), blocks.end());
  factor.compute(normal);
}

class RunCovariances {
 public:
  RunCovariances(const Factor& factor, const NodePoses& poses, IdRange<NodeId> nodes)
      : factor_(factor), poses_(poses), nodes_(nodes), size_(3 * Eigen::Index(poses.size())) {
    fitAll();
  }

  /** Of one node, against the run as a whole. */
  Matrix3d of(NodeId node) const {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(size_, 3);
    unit.middleRows<3>(at(node)).setIdentity();
    const Matrix3d own = factor_.solve(unit).middleRows<3>(at(node));
    const Matrix3d g = motionOf(node), shared = g * withAll_.middleRows<3>(at(node)).transpose();
    const Matrix3d all = own - shared - shared.transpose() + g * ofAll_ * g.transpose();
    return (all + all.transpose()) / 2;
  }

 private:
  static Eigen::Index at(NodeId node) { return 3 * Eigen::Index(node.index()); }

  /** How a node moves when the run turns and shifts as a whole. */
  Matrix3d motionOf(NodeId node) const {
    Matrix3d motion = Matrix3d::Identity();
    motion(0, 2) = middle_.y - poses_[node].y, motion(1, 2) = poses_[node].x - middle_.x;
    return motion;
  }

  /** The turn and shift that fit the places of the run best, as a linear function of its poses,
   *  and the covariances of it. */
  void fitAll() {
    for (const NodeId node : nodes_)
      middle_ = middle_ + 1.0 / double(nodes_.size()) * poses_[node].shift();
    Matrix3d places = Matrix3d::Zero();
    places(0, 0) = places(1, 1) = 1;
    Matrix3d square = Matrix3d::Zero();
    for (const NodeId node : nodes_) {
      const Matrix3d motion = motionOf(node);
      square += motion.transpose() * places * motion;
    }
    square(2, 2) += 1 / kFixed;  // of a run that stands still
    const Matrix3d inverse = square.inverse();
    Eigen::MatrixXd fit = Eigen::MatrixXd::Zero(size_, 3);
    for (const NodeId node : nodes_)
      fit.middleRows<3>(at(node)) = places * motionOf(node) * inverse;
    withAll_ = factor_.solve(fit);
    ofAll_ = fit.transpose() * withAll_;
  }

  const Factor& factor_;
  const NodePoses& poses_;
  IdRange<NodeId> nodes_;
  Eigen::Index size_;
  Point middle_{0, 0};
  Eigen::MatrixXd withAll_;  ///< of each node and of the run as a whole
  Matrix3d ofAll_;           ///< of the run as a whole
};

PlanarCovariance planar(const Matrix3d& c) {
  return {c(0, 0), c(1, 1), c(2, 2), c(0, 1), c(0, 2), c(1, 2)};
}

std::vector<PlanarCovariance> covariancesOf(IdRange<NodeId> nodes,
                                            const RunCovariances& covariances) {
  // About 60 are worked out.
  const std::size_t step = nodes.size() / 60 + 1, last = nodes.size() - 1;
  Matrix3d before = covariances.of(nodes.front());
  std::vector<PlanarCovariance> all{planar(before)};
  for (std::size_t from = 0; from < last; from += step) {
    const std::size_t to = std::min(from + step, last);
    const Matrix3d behind = covariances.of(nodes[to]);
    for (std::size_t k = from + 1; k <= to; ++k) {
      const double share = double(k - from) / double(to - from);
      all.push_back(planar((1 - share) * before + share * behind));
    }
    before = behind;
  }
  return all;
}

}  // namespace

std::vector<std::vector<PlanarCovariance>> poseCovariances(const PoseGraph& graph,
                                                           const GraphTrust& trust,
                                                           const NodePoses& poses,
                                                           const std::vector<RunId>& runs) {
  std::vector<std::vector<PlanarCovariance>> all(runs.size());
  if (runs.empty() || poses.size() == 0) return all;
  Factor factor;
  decompose(graph, trust, poses, factor);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const IdRange<NodeId> nodes = graph.runs[runs[i]].nodes;
    if (!nodes.isEmpty()) all[i] = covariancesOf(nodes, RunCovariances(factor, poses, nodes));
  }
  return all;
}

}  // namespace roomgraph
