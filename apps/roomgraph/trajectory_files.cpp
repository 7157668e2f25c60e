#include "trajectory_files.h"

#include <set>

#include "file_word.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/report/evo_files.h"

namespace roomgraph {

std::vector<std::string> addTrajectories(const Comparison& comparison,
                                         const std::filesystem::path& folder, StagedFiles& staged) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, const std::string& bytes) {
    if (bytes.empty()) return;
    names.push_back((folder / name).string());
    for (const ComparedRun& run : comparison.runs)
      if (areSameFile(names.back(), run.file))
        throw UsageError(names.back() + ": would replace a map: choose another folder with " +
                         "--output");
    staged.add(names.back(), bytes);
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
