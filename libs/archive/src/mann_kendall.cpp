#include "roomgraph/archive/mann_kendall.h"

#include <cmath>
#include <map>

namespace roomgraph {
namespace {

int signOf(double value) { return (value > 0) - (value < 0); }

/** Of the sum of signs, where there is no trend; groups of equal values have less of it. */
double varianceOf(const Samples& samples) {
  const auto term = [](double n) { return n * (n - 1) * (2 * n + 5) / 18; };
  std::map<double, double> times;
  for (const Sample& sample : samples) ++times[sample.value];
  double variance = term(double(samples.size()));
  for (const auto& [value, count] : times) variance -= term(count);
  return variance;
}

}  // namespace

TrendTest mannKendall(const Samples& samples) {
  TrendTest test;
  const double variance = varianceOf(samples);
  if (samples.size() < 3 || variance <= 0) return test;
  int sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = i + 1; j < samples.size(); ++j)
      sum += signOf(samples[j].value - samples[i].value);
  const double n = double(samples.size());
  test.tau = sum / (n * (n - 1) / 2);
  // The sum moves in steps of two, hence the one.
  const double z = (sum - signOf(sum)) / std::sqrt(variance);
  test.pRising = 0.5 * std::erfc(z / std::sqrt(2.0));
  return test;
}

}  // namespace roomgraph
