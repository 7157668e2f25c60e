#include "roomgraph/compare/run_names.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/utf8_text.h"
#include "roomgraph/map_files/map_formats.h"

namespace roomgraph {
namespace {

std::string withFolder(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().filename().string();
  return folder.empty() ? mapStem(file) : folder + "/" + mapStem(file);
}

bool isUnique(const std::vector<std::string>& names, const std::string& name) {
  return std::count(names.begin(), names.end(), name) == 1;
}

/** The name, or with the first of "#2", "#3" and so on that is not taken; it is then. */
std::string firstFree(const std::string& name, std::set<std::string>& taken) {
  std::string result = name;
  for (int time = 2; !taken.insert(result).second; ++time)
    result = name + "#" + std::to_string(time);
  return result;
}

}  // namespace

std::vector<std::string> runNames(const std::vector<std::string>& files) {
  std::vector<std::string> different = files;
  sortUnique(different);
  // The shortest that tells all files apart: with their extensions, or with their folders.
  std::vector<std::vector<std::string>> choices(3);
  for (const std::string& file : different) {
    choices[0].push_back(mapStem(file));
    choices[1].push_back(fileName(file));
    choices[2].push_back(withFolder(file));
  }
  std::set<std::string> taken;
  std::map<std::string, std::string> nameOf;
  for (std::size_t i = 0; i < different.size(); ++i) {
    std::string name = different[i];
    for (std::size_t k = choices.size(); k-- > 0;)
      if (isUnique(choices[k], choices[k][i])) name = choices[k][i];
    nameOf[different[i]] = firstFree(utf8Text(name), taken);
  }
  std::vector<std::string> names;
  std::set<std::string> given;
  for (const std::string& file : files) {
    const std::string& name = nameOf[file];
    names.push_back(given.insert(file).second ? name : firstFree(name, taken));
  }
  return names;
}

std::string nameOfRun(const std::string& given, const std::vector<std::string>& names,
                      const std::string& option) {
  for (const std::string& name : {given, utf8Text(mapStem(given))})
    if (contains(names, name)) return name;
  throw UsageError(option + ": there is no run " + given + ": name one of " + listed(names, 10));
}

}  // namespace roomgraph
