#include "external_file.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

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

/** The folders of other maps' files, in the order of their names. */
std::vector<fs::path> otherFolders(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::string end = kFolderEnd;
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
      found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::string externalFolder(const std::string& map) { return stemOf(map).string() + kFolderEnd; }

std::string findExternalFile(const std::string& map, const std::string& name) {
  fs::path folder = fs::path(map).parent_path();
  std::vector<fs::path> places{externalFolder(map), folder};
  if (folder.empty()) folder = ".";
  for (fs::path& place : otherFolders(folder)) places.push_back(std::move(place));
  for (const fs::path& place : places) {
    const fs::path file = place / name;  // a full name stays as it is
    std::error_code error;
    if (fs::is_regular_file(file, error)) return file.string();
  }
  return "";
}

CloudPoints kittiPoints(const ByteReader& bytes) {
  CloudPoints points;
  for (std::size_t i = 0; i + 4 <= bytes.left() / sizeof(float); i += 4) {
    const TPoint3Df p(floatAt(bytes.peek(), i), floatAt(bytes.peek(), i + 1),
                      floatAt(bytes.peek(), i + 2));
    if (isFinite(p)) points.push_back(p);
  }
  return points;
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
