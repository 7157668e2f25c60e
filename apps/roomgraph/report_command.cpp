#include "report_command.h"

#include <memory>

#include "Command.h"
#include "comparison_results.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/files/write_file.h"
#include "roomgraph/report/comparison_json.h"

namespace roomgraph {
namespace {

struct ReportArguments {
  std::string comparison;
  std::vector<std::string> maps;
  GateArguments gate;
  std::string folder;
  bool isQuiet = false;
};

/** The folder that was asked for, or that of the comparison. */
std::filesystem::path folderOf(const ReportArguments& arguments) {
  if (!arguments.folder.empty()) return arguments.folder;
  const auto folder = std::filesystem::path(arguments.comparison).parent_path();
  return folder.empty() ? "." : folder;
}

int run(const ReportArguments& arguments) {
  const GateOptions gate = gateOf(arguments.gate);
  const ResultFiles files(folderOf(arguments));
  for (const std::string& map : arguments.maps)
    for (const std::string& result : files.all())
      if (areSameFile(map, result))
        throw UsageError(result + ": would replace a map: choose another folder with --output");
  Comparison comparison = readComparison(arguments.comparison);
  const std::vector<Run> runs = readMapsOf(comparison, arguments.maps);
  const bool isStruck = addGate(comparison, gate);
  makeWritableFolder(folderOf(arguments).string());
  StagedFiles staged;
  addResults(comparison, runs, files, staged);
  staged.commit();
  if (!arguments.isQuiet) printResults(comparison, files, {});
  if (isStruck) printComplaints(comparison);
  return isStruck ? kStruck : kDone;
}

}  // namespace

std::function<int()> reportCommand(CLI::App& app) {
  const auto arguments = std::make_shared<ReportArguments>();
  app.add_option("COMPARISON", arguments->comparison, "The comparison.json of an earlier call.")
      ->type_name("")
      ->required();
  app.add_option("MAP", arguments->maps,
                 "The maps that were compared, or some of them: those are drawn. They are told by "
                 "their content.")
      ->type_name("");
  app.add_option("-o,--output", arguments->folder,
                 "Folder for the results, which are those of 'roomgraph compare'; that of the "
                 "comparison where it is left out.")
      ->type_name("DIR");
  declareGate(arguments->gate, app);
  app.add_flag("-q,--quiet", arguments->isQuiet, "Print nothing but errors.");
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
