#pragma once
#include <string>
#include <vector>

#include "output_names.h"
#include "roomgraph/base/StagedFiles.h"

namespace roomgraph {

/** Files that appear together in one folder, and their names in the order in which they were added.
 *  What belongs elsewhere is added to `staged` alone. */
struct FolderFiles {
  std::string folder;
  StagedFiles staged{};
  std::vector<std::string> names{};

  void add(const std::string& name, const std::string& bytes) {
    names.push_back(inFolder(folder, name));
    staged.add(names.back(), bytes);
  }
};

}  // namespace roomgraph
