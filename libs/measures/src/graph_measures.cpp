#include "graph_measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "measure_over_others.h"

namespace roomgraph {
namespace {

/** A figure of a run against one other, and how it is told. */
struct Kind {
  std::string name;
  bool isSquared = false;  ///< means are taken of its square
  /** Of the first of both, or of the second. */
  std::function<Figure(const GraphComparison&, bool isFirst)> figure;
};

Kind plain(const std::string& name, Figure GraphComparison::*figure, bool isSquared = false) {
  return {name, isSquared,
          [figure](const GraphComparison& graphs, bool) { return graphs.*figure; }};
}

std::vector<Kind> allKinds() {
  std::vector<Kind> kinds{{"path_coverage", false,
                           [](const GraphComparison& g, bool isFirst) {
                             return isFirst ? g.coverageOfA : g.coverageOfB;
                           }},
                          plain("global_accuracy", &GraphComparison::globalAccuracy, true),
                          plain("relative_accuracy", &GraphComparison::relativeAccuracy, true)};
  for (std::size_t k = 0; k < kConsistencyHops.size(); ++k)
    kinds.push_back({"consistency_" + std::to_string(kConsistencyHops[k]), false,
                     [k](const GraphComparison& g, bool) { return g.consistency[k]; }});
  kinds.push_back(plain("path_length_error", &GraphComparison::lengthError));
  kinds.push_back(plain("path_frechet", &GraphComparison::frechet));
  kinds.push_back({"nearest_vertex", false, [](const GraphComparison& g, bool isFirst) {
                     return isFirst ? g.nearestA : g.nearestB;
                   }});
  return kinds;
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = allKinds();
  return all;
}

/** Counts figures together. */
class Mean {
 public:
  explicit Mean(bool isSquared) : isSquared_(isSquared) {}

  void add(const Figure& figure, double weight) {
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

Measure measureOf(const Kind& kind, const std::vector<Figure>& figures, const Trust& trust) {
  Measure measure = measureNamed(kind.name);
  std::vector<double> supports;
  for (std::size_t j = 0; j < figures.size(); ++j)
    supports.push_back(figures[j].value && trust[j] > 0 ? figures[j].support : 0);
  measureOverOthers(measure, supports, [&](std::size_t but) {
    Mean mean(kind.isSquared);
    for (std::size_t j = 0; j < figures.size(); ++j)
      if (j != but) mean.add(figures[j], trust[j]);
    return mean.value();
  });
  return measure;
}

}  // namespace

ComparedGraphs comparedGraphs(const Site& site, const MapPairs& pairs, const ForEach& forEach) {
  ComparedGraphs graphs(site.runs.size());
  const auto all = graphs.pairs();
  forEach(all.size(), [&](std::size_t k) {
    const auto [i, j] = all[k];
    const Run &a = *site.runs[i], &b = *site.runs[j];
    const MapPair& pair = pairs(i, j);
    const GraphMatch match =
        matchGraphs({a.graph, a.map.patches, pair.aInB}, {b.graph, b.map.patches, pair.bInA}, {});
    graphs(i, j) = compareGraphs(a.graph, b.graph, match, {site.poses[i], site.poses[j]});
  });
  return graphs;
}

std::vector<Measure> graphMeasuresOf(const ComparedGraphs& graphs, const Trust& trust,
                                     std::size_t run) {
  std::vector<Measure> measures;
  for (const Kind& kind : kinds()) {
    std::vector<Figure> figures(graphs.things());
    for (std::size_t j = 0; j < figures.size(); ++j)
      if (j != run) figures[j] = kind.figure(graphs(run, j), run < j);
    measures.push_back(measureOf(kind, figures, trust));
  }
  return measures;
}

std::vector<Measure> graphMeasuresOfPair(const GraphComparison& graphs) {
  std::vector<Measure> measures;
  for (const Kind& kind : kinds()) {
    const Figure first = kind.figure(graphs, true), second = kind.figure(graphs, false);
    Mean mean(kind.isSquared);
    mean.add(first, 1), mean.add(second, 1);
    // The two ways are the same things but for coverage and nearest vertices.
    const bool isOneThing = first.support == second.support && first.value == second.value;
    measures.push_back(measureNamed(kind.name, mean.value(),
                                    isOneThing ? first.support : first.support + second.support));
  }
  return measures;
}

}  // namespace roomgraph
