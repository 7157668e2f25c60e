#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "roomgraph/base/sentence_text.h"

namespace roomgraph {

/** What the program ends with; kGateFailed where a gate such as --fail-below fails, or there is an
 *  alarm. */
enum ExitCode { kDone = 0, kBadData = 1, kBadUsage = 2, kGateFailed = 3 };

/** Declares the arguments of a subcommand and returns what to do once they are parsed. That returns
 *  an exit code, and throws UsageError or DataError. */
using Declare = std::function<int()>(CLI::App& app);

struct Command {
  const char *name, *sentence;
  Declare* declare;
};

/** Declares an option by its names and what its value is called in the help, "-o,--output DIR", or
 *  an argument that may be left out by its name alone. */
template <class Value>
CLI::Option* addOption(CLI::App& app, const std::string& names, Value& value,
                       const std::string& sentence) {
  const std::size_t end = names.find(' ');
  CLI::Option* option = app.add_option(names.substr(0, end), value, sentence)
                            ->type_name(end == std::string::npos ? "" : names.substr(end + 1));
  if (option->get_positional()) return option;
  option->check(CLI::Validator(
      [&app](const std::string& text) {
        return text.rfind('-', 0) == 0 && app.get_option_no_throw(text)
                   ? "needs a value, and '" + text + "' is an option"
                   : std::string();
      },
      ""));
  if (names.rfind("-o,", 0) == 0)
    option->check(CLI::Validator(
        [](const std::string& name) {
          return name.empty() ? "is empty: name one, or leave the option out" : "";
        },
        ""));
  return option;
}

/** Declares an argument that must be there. */
template <class Value>
CLI::Option* addArgument(CLI::App& app, const char* name, Value& value,
                         const std::string& sentence) {
  return addOption(app, name, value, sentence)->required();
}

/** The check of a number from `least` to `most`. CLI::Range takes nan for one. */
inline CLI::Validator isWithin(double least, double most) {
  return CLI::Validator(
      [least, most](const std::string& text) {
        double value = 0;
        const bool isNumber = CLI::detail::lexical_cast(text, value);
        return isNumber && value >= least && value <= most
                   ? std::string()
                   : formatted("Value %s not in range %.7g to %.7g", text.c_str(), least, most);
      },
      "");
}

// What declares each of them.
Declare extractCommand, routeCommand, whereCommand, compareCommand, checkCommand, repairCommand,
    mergeCommand, carryCommand, reportCommand, archiveCommand, watchCommand, planCommand,
    taskCommand, collectCommand, stabilityCommand, scoreRoomsCommand, convertCommand,
    exportRawlogCommand, infoCommand, configCommand;

}  // namespace roomgraph
