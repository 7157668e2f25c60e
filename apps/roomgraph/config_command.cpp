#include "config_command.h"

#include <cstdio>
#include <memory>

#include "Command.h"
#include "option_arguments.h"

namespace roomgraph {

std::function<int()> configCommand(CLI::App& app) {
  const auto arguments = std::make_shared<OptionArguments>();
  declareConfig(*arguments, app);
  return [arguments] {
    ExtractOptions options = toOptions(*arguments);
    std::fputs(toIni(describe(options)).c_str(), stdout);
    return int(kDone);
  };
}

}  // namespace roomgraph
