#include "FleetFolder.h"

#include <sstream>

#include "file_authors.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/write_file.h"

namespace roomgraph {

std::string linesOf(const std::vector<std::string>& failures) {
  std::string text;
  for (const std::string& line : failures) text += line + "\n";
  return text;
}

void FleetFolder::write(const std::vector<FleetTask>& tasks, const CompareMapsOptions& options,
                        const std::vector<std::string>& failures) const {
  makeWritableFolder(folder_.string());
  makeWritableFolder((folder_ / "results").string());
  CompareMapsOptions written = options;
  StagedFiles staged;
  staged.add(optionsFile().string(), withAuthor(toIni(describe(written))));
  staged.add(taskFile().string(), taskLines(tasks));
  staged.add(this->failures().string(), linesOf(failures));
  staged.commit();
}

std::vector<std::string> FleetFolder::failuresIn(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  std::vector<std::string> lines;
  std::istringstream text(readFile(file.string()));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
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
