#include "file_authors.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/compressed.h"
#include "roomgraph/base/csv_text.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/images/png_bytes.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/map_files/map_sha256.h"
#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

/** The first lines of a file; none where it cannot be read, which its reader will say. */
std::string firstLines(const std::string& file) {
  return orNothing([&] { return CheckedFile(file).head().text(); });
}

/** The first bytes of a file as they lie on the disk; none where it is no file. */
std::string storedHead(const std::string& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  // As far as the longest palette that we write, and what stands before it.
  constexpr std::size_t enough = 512;
  std::string head(enough, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), std::streamsize(enough));
  head.resize(std::size_t(in.gcount()));
  return head;
}

bool hasAuthorLine(const std::string& file) { return storedHead(file).rfind(kRosMapMark, 0) == 0; }

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/** A simplemap says it where it is gzip; any other one is what the path beside it was written
 *  with. */
bool isOurSimplemap(const std::string& file) {
  if (holds(storedHead(file), kGzipMark)) return true;
  const std::string path = (fs::path(file).parent_path() / (mapStem(file) + ".tum")).string();
  return orNothing([&] { return hasAuthorLine(path) && holds(storedHead(path), mapSha256(file)); });
}

/** By a yaml of its folder: that of the same name mostly, but a mask that was carried has names
 *  that somebody else gave. */
bool isOurPicture(const std::string& file) {
  const std::string yaml = fs::path(file).replace_extension(".yaml").string();
  return (hasAuthorLine(yaml) && areSameFile(pictureOf(yaml), file)) ||
         anyOf(mapsWithPicture(file), hasAuthorLine);
}

/** Rooms of a site that were not carried are kept from call to call, with names that users give. */
bool isOurJson(const std::string& file) {
  const std::string head = storedHead(file);
  return holds(head, "\"format\"") && holds(head, "\"roomgraph/") &&
         !holds(head, "\"roomgraph/site\"");
}

/** By the first names of the columns, as many as no table of somebody else has. */
bool isOurTable(const std::string& file) {
  const std::string head = storedHead(file);
  const auto begins = [&](const char* names) { return head.rfind(names, 0) == 0; };
  return begins("rank,name,file,score,score_low,") || begins("id,name,kind,x,y,area_m2,run,") ||
         begins("site,robot,time,file,sha256,state,") || begins("distance_px,percent,");
}

bool isCarriedFile(const std::string& file) {
  return orNothing([&] { return isCarried(readFile(file)); });
}

/** Whether it may be something marked on a map, or a list of runs, by its content. */
bool isMarkedOrList(const std::string& file) {
  return orNothing([&] {
           const std::string head = firstLines(file);
           const auto names = CsvReader(head, file).nextLine();
           const auto has = [&](const char* name) { return columnOf(names, name).has_value(); };
           return (has("x") && has("y")) || (has("site") && has("file"));
         }) ||
         orNothing([&] { return !readMarked(file).files.empty(); });
}

}  // namespace

std::string withAuthor(const std::string& text) { return std::string(kRosMapMark) + "\n" + text; }

std::string pictureOf(const std::string& mapFile) {
  if (!endsWith(mapFile, ".yaml") && !endsWith(mapFile, ".yml")) return {};
  std::istringstream in(firstLines(mapFile));
  std::string line;
  while (std::getline(in, line)) {
    if (line.rfind("image:", 0) != 0) continue;
    const auto first = line.find_first_not_of(" \t\"'", 6);
    if (first == std::string::npos) return {};
    const auto last = line.find_last_not_of(" \t\r\"'");
    return (fs::path(mapFile).parent_path() / line.substr(first, last + 1 - first)).string();
  }
  return {};
}

std::vector<std::string> mapsWithPicture(const std::string& picture) {
  const fs::path folder = fs::path(picture).parent_path();
  std::vector<std::string> maps;
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; at != end && !error;
       at.increment(error))
    if (areSameFile(pictureOf(at->path().string()), picture)) maps.push_back(at->path().string());
  return maps;
}

std::string foreignMapOf(const std::string& file) {
  for (const char* extension : {".yaml", ".yml"}) {
    std::string yaml = fs::path(file).replace_extension(extension).string();
    if (areSameFile(pictureOf(yaml), file) && !hasAuthorLine(yaml)) return yaml;
  }
  return {};
}

bool isMapOrArchive(const std::string& file) {
  if (storedHead(file).rfind("SQLite format 3", 0) == 0) return true;
  return orNothing([&] {
    CheckedFile opened(file);
    const std::vector<MapFormat>& formats = mapFormats();
    return anyOf(formats, [&](const MapFormat& format) { return format.looksLike(opened); });
  });
}

bool isOurs(const std::string& file) {
  const auto isOf = [&file](const auto&... kinds) { return (endsWith(file, kinds) || ...); };
  if (isOf(".yaml", ".yml", ".tum", ".g2o", ".ini")) return hasAuthorLine(file);
  if (isOf(".png")) return holds(storedHead(file), std::string("Software") + '\0' + kPngSoftware);
  if (isOf(".pgm")) return isOurPicture(file);
  if (isOf(".gridmap", ".gridmap.gz", ".rawlog")) return holds(storedHead(file), kGzipMark);
  if (isOf(".simplemap", ".simplemap.gz", ".simplemap.zst")) return isOurSimplemap(file);
  if (isOf(".json")) return isOurJson(file) || isCarriedFile(file);
  if (isOf(".geojson"))
    return holds(storedHead(file), "\"name\": \"roomgraph") || isCarriedFile(file);
  if (isOf(".osm"))
    return holds(storedHead(file), "generator=\"roomgraph\"") || isCarriedFile(file);
  if (isOf(".csv")) return isOurTable(file) || isCarriedFile(file);
  if (hasAuthorLine(file)) return true;
  if (isMapOrArchive(file)) return isOurPicture(file);
  return !isMarkedOrList(file) || isOurJson(file) || isOurTable(file) || isCarriedFile(file);
}

}  // namespace roomgraph
