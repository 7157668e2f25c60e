#include "stage_result.h"

#include "output_names.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {

std::string stageResult(const Comparison& comparison, const std::filesystem::path& folder,
                        const std::string& name, const std::string& bytes, StagedFiles& staged) {
  std::string file = (folder / name).string();
  for (const ComparedRun& run : comparison.runs)
    if (areSameFile(file, run.file))
      throw UsageError(file + ": would replace a map: choose another folder with --output");
  staged.add(file, bytes);
  return file;
}

}  // namespace roomgraph
