#include "output_names.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/compressed.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/images/png_bytes.h"
#include "roomgraph/map_files/map_formats.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

/** The first lines of a file; none where it cannot be read, which its reader will say. */
std::string firstLines(const std::string& file) {
  try {
    const CheckedFile opened(file);
    const ByteView head = opened.head();
    return {reinterpret_cast<const char*>(head.data), head.size};
  } catch (const DataError&) {
    return {};
  }
}

/** The picture that a ROS map's yaml names; empty for any other file. */
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

bool isOurYaml(const std::string& file) { return storedHead(file).rfind(kRosMapMark, 0) == 0; }

/** Whether a file that is there has been written by this program, as far as files of its kind say
 *  who has written them. */
bool isOurs(const std::string& file) {
  const auto holds = [&file](const std::string& mark) {
    return storedHead(file).find(mark) != std::string::npos;
  };
  if (endsWith(file, ".yaml") || endsWith(file, ".yml")) return isOurYaml(file);
  if (endsWith(file, ".png")) return holds(std::string("Software") + '\0' + kPngSoftware);
  if (endsWith(file, ".pgm")) {
    const std::string yaml = fs::path(file).replace_extension(".yaml").string();
    return isOurYaml(yaml) && areSameFile(pictureOf(yaml), file);
  }
  for (const char* kind : {".gridmap", ".gridmap.gz", ".rawlog"})
    if (endsWith(file, kind)) return holds(kGzipMark);
  return true;
}

/** The ROS map of somebody else that has a file for its picture; empty for none. */
std::string foreignMapOf(const std::string& file) {
  for (const char* extension : {".yaml", ".yml"}) {
    std::string yaml = fs::path(file).replace_extension(extension).string();
    if (areSameFile(pictureOf(yaml), file) && !isOurYaml(yaml)) return yaml;
  }
  return {};
}

/** What tells a file from all others, whatever its name; none where there is no such file. */
using Identity = std::pair<dev_t, ino_t>;

std::optional<Identity> identityOf(const std::string& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return {};
  return Identity(status.st_dev, status.st_ino);
}

/** From the root, with the links that are there followed. */
fs::path normalised(const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error).lexically_normal();
  const fs::path followed = fs::weakly_canonical(whole, error);
  return error ? whole : followed;
}

/** The result of each map by its name. Throws where two maps have one of the same name. */
std::map<std::string, std::string> mapsByResult(const std::vector<std::string>& mapFiles,
                                                const std::string& folder,
                                                const std::vector<std::string>& extensions) {
  // Two maps of one X meet in any result; X.areas.png may be the labels of X or a picture of
  // X.areas.
  std::map<std::string, std::string> mapOfResult;
  for (const std::string& file : mapFiles)
    for (const std::string& extension : extensions) {
      const std::string result = outputFile(folder, file, extension);
      const auto [known, isNew] = mapOfResult.emplace(result, file);
      if (isNew) continue;
      std::string text = known->second;
      text.append(" and ").append(file).append(" would both be written as ").append(result);
      throw UsageError(text + ": rename one, or extract them into different folders");
    }
  return mapOfResult;
}

}  // namespace

ResultFolder::ResultFolder(const std::string& folder, std::vector<std::string> inputs)
    : folder_(folder), inputs_(std::move(inputs)) {
  makeWritableFolder(folder);
}

std::string ResultFolder::add(const std::string& name, const std::string& bytes) {
  std::string file = (std::filesystem::path(folder_) / name).string();
  for (const std::string& input : inputs_)
    if (areSameFile(file, input))
      throw UsageError(file + ": would replace what is read: choose another folder with --output");
  if (!added_.insert(file).second)
    throw UsageError(file + ": would be written twice: ask for files of one name one by one");
  staged_.add(file, bytes);
  return file;
}

bool areSameFile(const std::string& one, const std::string& other) {
  const auto identity = identityOf(one);
  return identity && identity == identityOf(other);
}

bool wouldBeSameFile(const std::string& one, const std::string& other) {
  return areSameFile(one, other) || normalised(one) == normalised(other);
}

std::string outputFile(const std::string& folder, const std::string& mapFile,
                       const std::string& extension) {
  return (fs::path(folder) / (mapStem(mapFile) + "." + extension)).string();
}

std::string repairedName(const std::string& file) {
  const std::string name = fileName(file), stem = mapStem(file);
  return stem + ".repaired" + name.substr(std::min(stem.size(), name.size()));
}

void checkOutputNames(const std::vector<std::string>& mapFiles, const std::string& folder,
                      const std::vector<std::string>& extensions) {
  std::set<Identity> inputs;
  for (const std::string& file : mapFiles)
    for (const std::string& input : {file, pictureOf(file)})
      if (const auto identity = identityOf(input)) inputs.insert(*identity);
  for (const auto& [result, file] : mapsByResult(mapFiles, folder, extensions)) {
    const auto identity = identityOf(result);
    if (identity && inputs.count(*identity) > 0)
      throw UsageError(result + ": would replace a map that is read: choose another folder with " +
                       "--output, or other formats with --format");
    if (const std::string map = foreignMapOf(result); !map.empty())
      throw UsageError(result + ": would replace a part of the map " + map + ", which roomgraph " +
                       "has not written: choose another folder with --output");
    if (identity && !isOurs(result))
      throw UsageError(result + ": would replace a file that roomgraph has not written: choose " +
                       "another folder with --output");
  }
}

}  // namespace roomgraph
