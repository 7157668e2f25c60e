#include "output_names.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "roomgraph/base/file_name.h"
#include "roomgraph/map_files/map_formats.h"

namespace roomgraph {

namespace fs = std::filesystem;

std::optional<FileIdentity> identityOf(const std::string& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return {};
  return FileIdentity(status.st_dev, status.st_ino);
}

bool areSameFile(const std::string& one, const std::string& other) {
  const auto identity = identityOf(one);
  return identity && identity == identityOf(other);
}

std::string placeOnDisk(const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error).lexically_normal();
  const fs::path followed = fs::weakly_canonical(whole, error);
  return (error ? whole : followed).string();
}

bool wouldBeSameFile(const std::string& one, const std::string& other) {
  return areSameFile(one, other) || placeOnDisk(one) == placeOnDisk(other);
}

std::string inFolder(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

std::string outputFile(const std::string& folder, const std::string& mapFile,
                       const std::string& extension) {
  return inFolder(folder, mapStem(mapFile) + "." + extension);
}

std::string repairedName(const std::string& file) {
  const std::string name = fileName(file), stem = mapStem(file);
  return stem + ".repaired" + name.substr(std::min(stem.size(), name.size()));
}

}  // namespace roomgraph
