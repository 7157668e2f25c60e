#include "FleetFolder.h"

#include "roomgraph/files/InputFile.h"
#include "roomgraph/files/StagedFiles.h"
#include "roomgraph/files/write_file.h"
#include "roomgraph/fleet/task_lines.h"

namespace roomgraph {

void FleetFolder::write(const std::vector<FleetTask>& tasks,
                        const CompareMapsOptions& options) const {
  makeWritableFolder(folder_.string());
  makeWritableFolder((folder_ / "results").string());
  CompareMapsOptions written = options;
  StagedFiles staged;
  staged.add(optionsFile().string(), toIni(describe(written)));
  staged.add(taskFile().string(), taskLines(tasks));
  staged.commit();
}

std::vector<FleetTask> FleetFolder::tasks() const {
  const std::string file = taskFile().string();
  return parseTaskLines(readFile(file, 4 * kLargestText), file);
}

CompareMapsOptions FleetFolder::options() const {
  const std::string file = optionsFile().string();
  CompareMapsOptions options;
  FieldTable table = describe(options);
  fromIni(readFile(file), file, table);
  return options;
}

}  // namespace roomgraph
