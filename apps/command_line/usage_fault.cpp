#include "usage_fault.h"

#include <cstdlib>
#include <regex>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"

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

/** How many files a command takes before one of its own commands. */
std::size_t filesOf(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->get_positional(); })
      .size();
}

/** CLI11 writes the ends of a range with six decimals, and newer versions as [0 - 1]; it takes
 *  what is no number for one out of range. */
std::string plainText(const CLI::ParseError& error) {
  std::smatch parts;
  const std::string what = error.what();
  if (std::regex_match(what, parts, std::regex("(.*)Value (.*) not in range .*"))) {
    const std::string value = parts[2];
    char* end = nullptr;
    std::strtod(value.c_str(), &end);
    if (value.empty() || *end) return parts[1].str() + "'" + value + "' is not a number";
  }
  if (std::regex_match(what, parts, std::regex("Could not convert: (.*) = (.*)")))
    return parts[1].str() + ": '" + parts[2].str() + "' is not a number";
  std::string text = std::regex_replace(what, std::regex("\\[(.*) - (.*)\\]"), "$1 to $2");
  text = std::regex_replace(text, std::regex("([0-9])\\.0+\\b"), "$1");
  return std::regex_replace(text, std::regex("(\\.[0-9]*[1-9])0+\\b"), "$1");
}

}  // namespace

std::string usageFault(const CLI::App& app, const std::vector<std::string>& arguments,
                       const CLI::ParseError& error) {
  const CLI::App* command = &app;
  std::size_t toSkip = 0;  // files that stand between a command and those in it
  for (const std::string& argument : arguments) {
    if (argument.rfind('-', 0) == 0) {
      const std::string name = argument.substr(0, argument.find('='));
      const bool isLong = name.rfind("--", 0) == 0 && name.size() > 2;
      if (isLong && !command->get_option_no_throw(name))
        return noSuch("option", name, optionsOf(*command));
      continue;
    }
    const auto commands = command->get_subcommands({});
    if (commands.empty() || toSkip > 0) {
      toSkip = toSkip > 0 ? toSkip - 1 : 0;
      continue;
    }
    const auto found =
        findIf(commands, [&](const CLI::App* known) { return known->get_name() == argument; });
    if (!found) return noSuch("command", argument, mapped(commands, &CLI::App::get_name));
    command = *found, toSkip = filesOf(*command);
  }
  return plainText(error);
}

}  // namespace roomgraph
