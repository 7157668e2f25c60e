#include "roomgraph/base/write_file.h"

#include <unistd.h>

#include <filesystem>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/StagedFiles.h"

namespace roomgraph {

void writeFileAtomically(const std::string& path, const std::string& bytes) {
  StagedFiles files;
  files.add(path, bytes);
  files.commit();
}

void makeWritableFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder) || access(folder.c_str(), W_OK | X_OK) != 0)
    throw DataError(folder + ": cannot be written to" +
                    (error ? " (" + error.message() + ")" : std::string()) +
                    ": choose another folder");
}

}  // namespace roomgraph
