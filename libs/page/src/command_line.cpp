#include "command_line.h"

#include <algorithm>
#include <map>

#include "roomgraph/base/file_name.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {
namespace {

/** In quotes where a shell would take it apart. */
std::string quoted(const std::string& word) {
  const auto isPlain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string("-_./=+:,%@").find(c) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), isPlain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/** As an argument; nothing for an option that has its default. */
std::string argumentOf(const UsedOption& option) {
  static const std::map<std::string, std::string> flags = {{"aligned", " --aligned"},
                                                           {"estimate_scale", " --estimate-scale"}};
  if (option.section != "compare")
    return " --set " + quoted(option.section + "." + option.name + "=" + option.value);
  if (option.name == "reference") return " --reference " + quoted(fileName(option.value));
  const auto flag = flags.find(option.name);
  return flag == flags.end() ? "" : flag->second;
}

}  // namespace

std::string commandLine(const Comparison& comparison) {
  std::vector<std::string> files;
  for (const ComparedRun& run : comparison.runs)
    if (run.name != comparison.reference) files.push_back(fileName(run.file));
  for (const LeftOutRun& run : comparison.leftOut) files.push_back(fileName(run.file));
  std::sort(files.begin(), files.end());
  std::string text = "roomgraph compare";
  for (const std::string& file : files) text += " " + quoted(file);
  std::map<std::string, std::string> defaults;
  for (const UsedOption& option : usedOptions({}))
    defaults[option.section + "." + option.name] = option.value;
  for (const UsedOption& option : comparison.options) {
    const auto usual = defaults.find(option.section + "." + option.name);
    if (usual == defaults.end() || usual->second != option.value) text += argumentOf(option);
  }
  return text;
}

}  // namespace roomgraph
