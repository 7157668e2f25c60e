#include "usage_fault.h"

#include <regex>

#include "nearest_word.h"

namespace roomgraph {
namespace {

std::string noSuch(const char* kind, const std::string& typed,
                   const std::vector<std::string>& words) {
  const std::string meant = nearestWord(typed, words);
  return std::string("there is no ") + kind + " '" + typed + "'" +
         (meant.empty() ? "" : ": did you mean '" + meant + "'?");
}

std::vector<std::string> optionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/** CLI11 writes the ends of a range with six decimals. */
std::string plainText(const CLI::ParseError& error) {
  const std::string text = std::regex_replace(error.what(), std::regex("([0-9])\\.0+\\b"), "$1");
  return std::regex_replace(text, std::regex("(\\.[0-9]*[1-9])0+\\b"), "$1");
}

}  // namespace

std::string usageFault(const CLI::App& app, const std::vector<std::string>& arguments,
                       const CLI::ParseError& error) {
  if (arguments.empty() || arguments[0].rfind('-', 0) == 0) return plainText(error);
  const CLI::App* command = nullptr;
  std::vector<std::string> names;
  for (const CLI::App* known : app.get_subcommands({})) {
    names.push_back(known->get_name());
    if (names.back() == arguments[0]) command = known;
  }
  if (!command) return noSuch("command", arguments[0], names);
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string name = arguments[i].substr(0, arguments[i].find('='));
    if (name.rfind("--", 0) == 0 && name.size() > 2 && !command->get_option_no_throw(name))
      return noSuch("option", name, optionsOf(*command));
  }
  return plainText(error);
}

}  // namespace roomgraph
