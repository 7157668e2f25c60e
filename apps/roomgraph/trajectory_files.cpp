#include "trajectory_files.h"

#include <set>

#include "file_word.h"
#include "roomgraph/report/evo_files.h"
#include "stage_result.h"

namespace roomgraph {

std::vector<std::string> addTrajectories(const Comparison& comparison,
                                         const std::filesystem::path& folder, StagedFiles& staged) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, const std::string& bytes) {
    if (!bytes.empty()) names.push_back(stageResult(comparison, folder, name, bytes, staged));
  };
  std::set<std::string> taken;
  for (const ComparedRun& run : comparison.runs) {
    const std::string word = fileWord(run.name, taken);
    add("comparison." + word + ".tum", pathTum(run));
    add("comparison." + word + ".evo.zip", evoResult(run, word));
  }
  return names;
}

}  // namespace roomgraph
