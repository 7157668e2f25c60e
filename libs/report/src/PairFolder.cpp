#include "roomgraph/report/PairFolder.h"

#include <filesystem>
#include <utility>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/write_file.h"

namespace roomgraph {

PairFolder::PairFolder(std::string folder) : folder_(std::move(folder)) {
  if (!folder_.empty()) makeWritableFolder(folder_);
}

KeptPairs PairFolder::kept() {
  if (folder_.empty()) return {};
  return {[this](const std::string& name) -> std::optional<std::string> {
            // It may not be there yet, or be no file of ours.
            return orNothing([&] { return std::optional(readFile(fileOf(name))); });
          },
          [this](const std::string& name, const std::string& bytes) { write(name, bytes); }};
}

std::string PairFolder::fileOf(const std::string& name) const {
  return (std::filesystem::path(folder_) / (name + ".pair")).string();
}

void PairFolder::write(const std::string& name, const std::string& bytes) {
  try {
    writeFileAtomically(fileOf(name), bytes);
  } catch (const DataError& error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    failure_ = error.what();
  }
}

}  // namespace roomgraph
