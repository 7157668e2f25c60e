#include "graph_measures.h"

#include <cmath>

namespace roomgraph {
namespace {

/** Counts figures together. */
class Mean {
 public:
  explicit Mean(bool isSquared) : isSquared_(isSquared) {}

  void add(const MeasuredValue& figure, double weight) {
    if (!figure.value || weight * figure.support <= 0) return;
    const double value = isSquared_ ? *figure.value * *figure.value : *figure.value;
    sum_ += weight * figure.support * value, weights_ += weight * figure.support;
  }
  std::optional<double> value() const {
    if (weights_ <= 0) return std::nullopt;
    return isSquared_ ? std::sqrt(sum_ / weights_) : sum_ / weights_;
  }

 private:
  bool isSquared_;
  double sum_ = 0, weights_ = 0;
};

}  // namespace

ComparedGraphs comparedGraphs(const Site& site, const MapPairs& pairs, const ForEach& forEach) {
  ComparedGraphs graphs(site.runs.size(), pairs.pairs());
  const std::vector<PairOfThings>& all = graphs.pairs();
  forEach(all.size(), [&](std::size_t k) {
    const auto [i, j] = all[k];
    const Run &a = *site.runs[i], &b = *site.runs[j];
    const MapPair& pair = pairs(i, j);
    const GraphMatch match =
        matchGraphs({a.graph, a.map.patches, pair.aInB}, {b.graph, b.map.patches, pair.bInA});
    graphs(i, j) = compareGraphs(a.graph, b.graph, match, {site.poses[i], site.poses[j]});
  });
  return graphs;
}

MeasuredValue graphMeasureOf(const GraphFigure& figure, const ComparedGraphs& graphs,
                             const Trust& trust, std::size_t run) {
  const std::vector<std::size_t>& others = graphs.othersOf(run);
  std::vector<MeasuredValue> figures;
  std::vector<double> supports;
  for (const std::size_t j : others) {
    figures.push_back(figure.of(graphs(run, j), run < j));
    supports.push_back(figures.back().value && trust[j] > 0 ? figures.back().support : 0);
  }
  return measureOverOthers(supports, [&](std::size_t but) {
    Mean mean(figure.isSquared);
    for (std::size_t k = 0; k < others.size(); ++k)
      if (k != but) mean.add(figures[k], trust[others[k]]);
    return mean.value();
  });
}

MeasuredValue graphMeasureOfPair(const GraphFigure& figure, const GraphComparison& graphs) {
  const MeasuredValue first = figure.of(graphs, true), second = figure.of(graphs, false);
  Mean mean(figure.isSquared);
  mean.add(first, 1), mean.add(second, 1);
  // The two ways are the same things but for coverage and nearest vertices.
  const bool isOneThing = first.support == second.support && first.value == second.value;
  return {mean.value(), isOneThing ? first.support : first.support + second.support};
}

}  // namespace roomgraph
