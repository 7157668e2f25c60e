#include <memory>

#include "commands.h"
#include "option_arguments.h"
#include "terminal.h"

namespace roomgraph {

std::function<int()> configCommand(CLI::App& app) {
  const auto arguments = std::make_shared<OptionArguments>();
  declareConfig(*arguments, app);
  return [arguments] {
    CompareMapsOptions options = toCompareOptions(*arguments);
    print(toIni(describe(options)));
    return int(kDone);
  };
}

}  // namespace roomgraph
