#include <cstdio>

#include "Command.h"
#include "HelpFormatter.h"
#include "archive_command.h"
#include "collect_command.h"
#include "compare_command.h"
#include "config_command.h"
#include "convert_command.h"
#include "error_line.h"
#include "export_rawlog_command.h"
#include "extract_command.h"
#include "info_command.h"
#include "interruption.h"
#include "plan_command.h"
#include "report_command.h"
#include "roomgraph/base/version.h"
#include "score_rooms_command.h"
#include "stability_command.h"
#include "task_command.h"
#include "terminal.h"
#include "usage_fault.h"

namespace roomgraph {
namespace {

constexpr Command kCommands[] = {
    {"extract", "Read maps and write the topology graph of each, with its rooms.", extractCommand},
    {"compare",
     "Say which of several maps of one site is the best, and how far each is from the others.",
     compareCommand},
    {"report", "Write the results of a comparison anew, and ask a gate again.", reportCommand},
    {"archive", "Keep the runs of a site night by night, and say whether its maps get worse.",
     archiveCommand},
    {"plan", "Write the tasks that bring an archive of many sites up to date.", planCommand},
    {"task", "Do a task of a plan, unless it is done already.", taskCommand},
    {"collect", "Put what came out of the tasks of a plan into the archive.", collectCommand},
    {"stability",
     "Measure how well the graphs of maps withstand noise on the walls, as in the paper.",
     stabilityCommand},
    {"score-rooms", "Measure how well the rooms of a label picture agree with the true ones.",
     scoreRoomsCommand},
    {"convert", "Write maps as a ROS map, an MRPT grid map or a picture.", convertCommand},
    {"export-rawlog", "Write the scans of a simplemap as a log for MRPT's RawLogViewer.",
     exportRawlogCommand},
    {"info", "Say what is in map files, graph files (X.json) and MRPT files (X.roomgraph).",
     infoCommand},
    {"config", "Print all options as a commented ini file, for use with --config.", configCommand},
};

int run(int count, char** arguments) {
  CLI::App app("Room-aware topology graphs of 2D grid maps.", "roomgraph");
  app.set_version_flag("--version", version());
  app.formatter(std::make_shared<HelpFormatter>());
  app.require_subcommand(1);
  int exitCode = kDone;
  for (const Command& command : kCommands) {
    CLI::App* sub = app.add_subcommand(command.name, command.sentence);
    sub->final_callback([&exitCode, work = command.declare(*sub)] { exitCode = work(); });
  }
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    const std::string fault = usageFault(app, {arguments + 1, arguments + count}, error);
    std::fputs(errorLine(fault + " (see 'roomgraph --help')").c_str(), stderr);
    return kBadUsage;
  }
  return exitCode;
}

}  // namespace
}  // namespace roomgraph

int main(int count, char** arguments) {
  try {
    roomgraph::finishResultsBeforeEnding();
    const int exitCode = roomgraph::run(count, arguments);
    roomgraph::checkPrinted();
    return exitCode;
  } catch (...) {
    const roomgraph::Failure failure = roomgraph::currentFailure("");
    std::fputs(failure.line.c_str(), stderr);
    return failure.exitCode;
  }
}
