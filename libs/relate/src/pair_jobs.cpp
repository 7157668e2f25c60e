#include "roomgraph/relate/pair_jobs.h"

#include <map>

namespace roomgraph {

std::vector<std::vector<std::size_t>> pairJobs(const std::vector<PairOfThings>& pairs,
                                               const std::function<bool(std::size_t)>& isBare) {
  std::vector<std::vector<std::size_t>> jobs;
  std::map<std::size_t, std::size_t> jobOf;  // of each bare map
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [a, b] = pairs[k];
    if (!isBare(a) && !isBare(b)) {
      jobs.push_back({k});
      continue;
    }
    const auto [job, isNew] = jobOf.try_emplace(isBare(b) ? b : a, jobs.size());
    if (isNew) jobs.emplace_back();
    jobs[job->second].push_back(k);
  }
  return jobs;
}

}  // namespace roomgraph
