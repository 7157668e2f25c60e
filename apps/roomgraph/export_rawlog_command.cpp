#include <memory>

#include "ResultFolder.h"
#include "commands.h"
#include "more_files.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/write_file.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct RawlogArguments {
  std::vector<std::string> runs;
  KeyFrameStretch stretch;
  OptionArguments options;
  std::string folder = ".";
};

int run(const RawlogArguments& arguments) {
  if (arguments.stretch.to && *arguments.stretch.to < arguments.stretch.from)
    throw UsageError("export-rawlog: --to is before --from: exchange them");
  const ExtractOptions options = toOptions(arguments.options);
  filesReadBy(arguments.runs, arguments.options)
      .writesOfEach(arguments.runs, arguments.folder, {"rawlog"});
  const ResultFolder folder(arguments.folder);
  return doEach(arguments.runs, [&](const std::string& file) {
    const std::string name = outputFile(arguments.folder, file, "rawlog");
    writeFileAtomically(name, scanLog(file, options.loadGrid, arguments.stretch));
    print(printable(name) + "\n");
  });
}

}  // namespace

std::function<int()> exportRawlogCommand(CLI::App& app) {
  const auto arguments = std::make_shared<RawlogArguments>();
  addArgument(app, "RUN", arguments->runs, "Simplemaps with scans.");
  addOption(app, "-o,--output DIR", arguments->folder, "Folder for the logs; created if missing.")
      ->capture_default_str();
  addOption(app, "--from K", arguments->stretch.from, "The first key frame, from 0.")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  addOption(app, "--to K", arguments->stretch.to,
            "The last key frame. Without it, the last one of the run.")
      ->check(CLI::NonNegativeNumber);
  declareOptions(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
