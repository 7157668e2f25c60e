#include "external_file.h"

#include <filesystem>
#include <sstream>

#include "point_bytes.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;
using mrpt::math::TPoint3Df;

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

}  // namespace

std::string externalFolder(const std::string& map) { return stemOf(map).string() + "_Images"; }

std::unique_ptr<CheckedFile> openExternalFile(const std::string& map, const std::string& name) {
  const fs::path folder = fs::path(map).parent_path();
  for (const fs::path& place : {fs::path(externalFolder(map)), folder}) {
    const fs::path file = place / name;  // a full name stays as it is
    std::error_code error;
    if (fs::is_regular_file(file, error)) return std::make_unique<CheckedFile>(file.string());
  }
  return nullptr;
}

std::vector<TPoint3Df> kittiPoints(const ByteReader& bytes) {
  std::vector<TPoint3Df> points;
  for (std::size_t i = 0; i + 4 <= bytes.left() / sizeof(float); i += 4) {
    const TPoint3Df p(floatAt(bytes.peek(), i), floatAt(bytes.peek(), i + 1),
                      floatAt(bytes.peek(), i + 2));
    if (isFinite(p)) points.push_back(p);
  }
  return points;
}

std::vector<TPoint3Df> textPoints(const ByteReader& bytes) {
  std::istringstream text(std::string(reinterpret_cast<const char*>(bytes.peek()), bytes.left()));
  std::vector<TPoint3Df> points;
  for (std::string line; std::getline(text, line);) {
    std::istringstream numbers(line);
    TPoint3Df p;
    if (numbers >> p.x >> p.y >> p.z && isFinite(p)) points.push_back(p);
  }
  return points;
}

}  // namespace roomgraph
