#include "run_names.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "output_names.h"

namespace roomgraph {
namespace {

std::string withFolder(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().filename().string();
  return folder.empty() ? outputStem(file) : folder + "/" + outputStem(file);
}

bool isUnique(const std::vector<std::string>& names, const std::string& name) {
  return std::count(names.begin(), names.end(), name) == 1;
}

}  // namespace

std::vector<std::string> runNames(const std::vector<std::string>& files) {
  std::vector<std::string> different = files;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  std::vector<std::string> stems, longer;
  for (const std::string& file : different) {
    stems.push_back(outputStem(file));
    longer.push_back(withFolder(file));
  }
  std::vector<std::string> names;
  std::map<std::string, int> times;
  for (const std::string& file : files) {
    std::string name = outputStem(file);
    if (!isUnique(stems, name)) name = withFolder(file);
    if (!isUnique(stems, outputStem(file)) && !isUnique(longer, name)) name = file;
    const int time = ++times[file];
    names.push_back(time == 1 ? name : name + "#" + std::to_string(time));
  }
  return names;
}

}  // namespace roomgraph
