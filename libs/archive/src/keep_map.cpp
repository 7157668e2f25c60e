#include "roomgraph/archive/keep_map.h"

#include <filesystem>
#include <limits>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/map_files/map_sha256.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNameLength = 16;  // of a folder: enough of the hash to be the only one

void copy(const std::string& from, const fs::path& to) {
  writeFileAtomically(to.string(), readFile(from, std::numeric_limits<std::uint64_t>::max()));
}

bool isKept(const std::string& file, const std::string& sha256) {
  try {
    return mapSha256(file) == sha256;
  } catch (const DataError&) {
    return false;
  }
}

}  // namespace

std::string keepMap(const std::string& file, const std::string& sha256, const std::string& folder) {
  const fs::path home = fs::absolute(folder).lexically_normal() / sha256.substr(0, kNameLength);
  std::string kept = (home / fs::path(file).filename()).string();
  if (isKept(kept, sha256)) return kept;
  makeWritableFolder(folder);
  makeWritableFolder(home.string());
  if (const std::string picture = pictureOfMap(file); !picture.empty()) {
    const fs::path place = fs::path(picture).lexically_relative(fs::path(file).parent_path());
    if (place.empty() || place.has_parent_path())
      refuse(file, "names a picture in another folder, " + picture, "keep both in one folder");
    copy(picture, home / place);
  }
  copy(file, kept);
  if (!isKept(kept, sha256)) refuse(file, "was changed while it was added", "add it again");
  return kept;
}

}  // namespace roomgraph
