#include "export_rawlog_command.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "Command.h"
#include "error_line.h"
#include "option_arguments.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/files/StagedFiles.h"
#include "roomgraph/files/write_file.h"
#include "roomgraph/mrpt_plugin/rawlog_file.h"
#include "roomgraph/scans/load_scans.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct RawlogArguments {
  std::vector<std::string> runs;
  std::size_t from = 0;
  std::optional<std::size_t> to;
  OptionArguments options;
  std::string folder = ".";
};

/** The scans that were asked for. */
std::vector<RobotScan> stretchOf(const std::string& file, const RawlogArguments& arguments,
                                 const ExtractOptions& options) {
  std::vector<RobotScan> scans = loadScans(file, options.loadGrid);
  if (scans.empty()) throw DataError(file + ": has no key frames: give a simplemap with scans");
  const std::size_t last = scans.back().keyFrame, to = arguments.to.value_or(last);
  if (std::max(arguments.from, to) > last)
    throw DataError(file + ": its last key frame is " + std::to_string(last) +
                    ": choose --from and --to up to that");
  scans.erase(std::remove_if(scans.begin(), scans.end(),
                             [&](const RobotScan& scan) {
                               return scan.keyFrame < arguments.from || scan.keyFrame > to;
                             }),
              scans.end());
  return scans;
}

int run(const RawlogArguments& arguments) {
  if (arguments.to && *arguments.to < arguments.from)
    throw UsageError("export-rawlog: --to is before --from: exchange them");
  const ExtractOptions options = toOptions(arguments.options);
  checkOutputNames(arguments.runs, arguments.folder, {"rawlog"});
  makeWritableFolder(arguments.folder);
  return doEach(arguments.runs, [&](const std::string& file) {
    const std::string name = outputFile(arguments.folder, file, "rawlog");
    StagedFiles staged;
    staged.add(name, rawlogBytes(stretchOf(file, arguments, options)));
    staged.commit();
    print(printable(name) + "\n");
  });
}

}  // namespace

std::function<int()> exportRawlogCommand(CLI::App& app) {
  const auto arguments = std::make_shared<RawlogArguments>();
  app.add_option("RUN", arguments->runs, "Simplemaps with scans.")->type_name("")->required();
  app.add_option("-o,--output", arguments->folder, "Folder for the logs; made if it is not there.")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--from", arguments->from, "The first key frame, from 0.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("K")
      ->capture_default_str();
  app.add_option("--to", arguments->to, "The last key frame; that of the run where it is left out.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("K");
  declareConfig(arguments->options, app);
  declareReading(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
