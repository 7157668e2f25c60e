#include "ResultFolder.h"

#include <filesystem>
#include <utility>

#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"

namespace roomgraph {

ResultFolder::ResultFolder(const std::string& folder, std::vector<std::string> inputs)
    : folder_(folder), inputs_(std::move(inputs)) {
  makeWritableFolder(folder);
}

std::string ResultFolder::add(const std::string& name, const std::string& bytes) {
  std::string file = (std::filesystem::path(folder_) / name).string();
  for (const std::string& input : inputs_)
    if (areSameFile(file, input))
      throw UsageError(file + ": would replace what is read: choose another folder with --output");
  if (!added_.insert(file).second)
    throw UsageError(file + ": would be written twice: ask for files of one name one by one");
  staged_.add(file, bytes);
  return file;
}

}  // namespace roomgraph
