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

void visitPairs(const Site& site, const std::vector<PairOfThings>& pairs, const ForEach& forEach,
                const std::function<void(std::size_t, FullMaps&)>& visit) {
  const auto jobs = pairJobs(pairs, [&](std::size_t i) { return site.mapOf(i).isBare(); });
  forEach(jobs.size(), [&](std::size_t job) {
    FullMaps maps;
    for (const std::size_t k : jobs[job]) visit(k, maps);
  });
}

}  // namespace roomgraph
