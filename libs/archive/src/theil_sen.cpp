#include "roomgraph/archive/theil_sen.h"

#include "roomgraph/base/statistics.h"

namespace roomgraph {

std::optional<SlopeFit> theilSen(const Samples& samples) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = i + 1; j < samples.size(); ++j)
      if (samples[i].time != samples[j].time)
        slopes.push_back((samples[j].value - samples[i].value) /
                         (samples[j].time - samples[i].time));
  if (slopes.empty()) return {};
  SlopeFit fit;
  fit.perDay = median(std::move(slopes));
  std::vector<double> rest;
  for (const Sample& sample : samples) rest.push_back(sample.value - fit.perDay * sample.time);
  fit.at0 = median(std::move(rest));
  return fit;
}

}  // namespace roomgraph
