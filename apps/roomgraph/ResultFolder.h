#pragma once
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "output_names.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/write_file.h"

namespace roomgraph {

/** A folder for the results of a call. It is made if it is not there, and goes with the call if
 *  that has left nothing in it. */
class ResultFolder {
 public:
  /** @throws DataError with one line where files cannot be written to it. */
  explicit ResultFolder(std::string folder) : folder_(std::move(folder)) {
    std::error_code isUnknown;
    isNew_ = !std::filesystem::exists(folder_, isUnknown);
    makeWritableFolder(folder_);
  }
  ~ResultFolder() {
    std::error_code isInUse;
    if (isNew_) std::filesystem::remove(folder_, isInUse);
  }
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

 private:
  std::string folder_;
  bool isNew_ = false;
};

/** Files that appear together in one folder, and their names in the order in which they were added.
 *  What belongs elsewhere is added to `staged` alone. */
struct FolderFiles {
  std::string folder;
  StagedFiles staged{};
  std::vector<std::string> names{};

  /** Returns the name under which it can be read until they appear. */
  std::string add(const std::string& name, const std::string& bytes) {
    names.push_back(inFolder(folder, name));
    return staged.add(names.back(), bytes);
  }
};

}  // namespace roomgraph
