#include "external_file.h"

#include <filesystem>
#include <sstream>

#include "point_bytes.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;
using mrpt::math::TPoint3Df;

constexpr const char* kFolderEnd = "_Images";

/** The map's name without what its format and compression add. */
fs::path stemOf(const std::string& map) {
  fs::path stem = map;
  while (stem.has_extension() && stem.extension().string().size() > 1) {
    const std::string extension = stem.extension().string();
    stem.replace_extension();
    if (extension == ".simplemap") break;
  }
  return stem;
}

bool hasMap(const fs::path& folder, const std::string& stem) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (!entry.is_directory(error) && stemOf(entry.path().string()).filename() == stem) return true;
  return false;
}

/** The one folder of files whose map is not there any more; empty for none or several. */
fs::path strayFolder(const fs::path& folder) {
  const std::string end = kFolderEnd;
  fs::path found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.size() <= end.size() || name.substr(name.size() - end.size()) != end ||
        !entry.is_directory(error) || hasMap(folder, name.substr(0, name.size() - end.size())))
      continue;
    if (!found.empty()) return {};
    found = entry.path();
  }
  return found;
}

/** The name, or of one that leads elsewhere its last part. */
fs::path nameBelow(const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  return path.is_absolute() || *path.begin() == ".." ? path.filename() : path;
}

bool isFile(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

}  // namespace

std::string externalFolder(const std::string& map) { return stemOf(map).string() + kFolderEnd; }

std::optional<ExternalFile> findExternalFile(const std::string& map, const std::string& name) {
  if (name.empty()) return std::nullopt;
  const fs::path below = nameBelow(name), own = externalFolder(map);
  fs::path folder = fs::path(map).parent_path();
  if (folder.empty()) folder = ".";
  for (const fs::path& place : {own, folder})
    if (isFile(place / below)) return ExternalFile{(place / below).string(), ""};
  std::error_code error;
  if (fs::exists(own, error)) return std::nullopt;
  const fs::path stray = strayFolder(folder);
  if (stray.empty() || !isFile(stray / below)) return std::nullopt;
  return ExternalFile{(stray / below).string(), stray.filename().string()};
}

CloudPoints kittiPoints(const ByteReader& bytes) {
  return pointsInRow(bytes.peek(), bytes.left() / (4 * sizeof(float)), 4);
}

CloudPoints textPoints(const ByteReader& bytes) {
  std::istringstream text(std::string(reinterpret_cast<const char*>(bytes.peek()), bytes.left()));
  CloudPoints points;
  for (std::string line; std::getline(text, line);) {
    std::istringstream numbers(line);
    TPoint3Df p;
    if (numbers >> p.x >> p.y >> p.z && isFinite(p)) points.push_back(p);
  }
  return points;
}

}  // namespace roomgraph
