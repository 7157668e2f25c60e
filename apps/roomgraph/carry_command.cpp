#include <array>
#include <memory>

#include "ArchiveArguments.h"
#include "ResultFolder.h"
#include "add_to_archive.h"
#include "commands.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/repair/MarkedFile.h"
#include "roomgraph/repair/carry_things.h"
#include "run_in_order.h"
#include "site_runs.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct CarryArguments {
  SiteArguments site;
  std::vector<std::string> things, via;
  std::string from, to;
  ArchiveArguments archive;  ///< its file and site; without a file, OLD, NEW and RUN are files
};

/** The same with the files of the runs of an archive that OLD, NEW and RUN name; without any RUN,
 *  those of its record. */
CarryArguments withFiles(CarryArguments arguments) {
  const std::string& file = arguments.archive.archive;
  if (file.empty()) return arguments;
  const Archive archive(file, Archive::Access::existing);
  const std::string site = siteToAddTo(arguments.archive, archive);
  if (arguments.via.empty())
    arguments.via = recordFiles(archive, site, arguments.archive.most);
  else
    for (std::string& run : arguments.via) run = fileOfRun(archive, site, run, file);
  for (std::string* run : {&arguments.from, &arguments.to}) {
    *run = fileOfRun(archive, site, *run, file);
    eraseIf(arguments.via, [&](const std::string& via) { return via == *run; });
  }
  return arguments;
}

/** Of two maps alone the user says that they are of one site. Runs that join them are to show it;
 *  where they do not, the two maps are taken alone as well. */
std::unique_ptr<SolvedRuns> solveBoth(const CarryArguments& arguments) {
  SiteArguments site = arguments.site;
  site.takesCopies = true;  // a map may be carried to itself
  site.files = site.needed = {arguments.from, arguments.to};
  if (!arguments.via.empty()) {
    site.files.insert(site.files.end(), arguments.via.begin(), arguments.via.end());
    auto runs = solvedRunsOf(site);
    const Site& found = runs->solved.site;
    if (found.placeOf(arguments.from) && found.placeOf(arguments.to)) return runs;
    site.files.resize(2);
  }
  site.areOneSite = true;
  return solvedRunsOf(site);
}

std::size_t placeOfFile(const Site& site, const std::string& file) {
  if (const auto place = site.placeOf(file)) return *place;
  throw DataError(file +
                  ": does not fit the other map, so nothing can be carried: name runs that " +
                  "overlap both with --via");
}

std::string lineOf(const std::string& file, const char* kind,
                   const std::vector<CarriedThing>& carried) {
  std::array<std::size_t, 4> counts{};
  for (const CarriedThing& thing : carried) ++counts[std::size_t(thing.state)];
  std::vector<std::string> parts;
  for (const CarryState state :
       {CarryState::carried, CarryState::unsure, CarryState::gone, CarryState::unseen})
    parts.push_back(std::to_string(counts[std::size_t(state)]) + " " + nameOf(state));
  return printable(file + ": " +
                   counted(carried.size(), std::string(kind) + ": ", std::string(kind) + "s: ") +
                   listed(parts)) +
         "\n";
}

/** What becomes of the files, for the terminal. */
struct Told {
  std::string lines;  ///< one for each file
  std::vector<std::string>
      failures;  ///< one for each thing that was not carried, of many the first
};

void addFile(const std::string& written, const MarkedFile& file,
             const std::vector<CarriedThing>& carried, Told& told) {
  constexpr std::size_t kMostTold = 10;
  told.lines += lineOf(written, file.kind, carried);
  std::size_t failed = 0;
  for (std::size_t i = 0; i < carried.size(); ++i) {
    const CarriedThing& thing = carried[i];
    if (thing.state == CarryState::carried || ++failed > kMostTold) continue;
    told.failures.push_back(written + ": " + file.kind + " " + file.things[i].name + ": " +
                            nameOf(thing.state) + (thing.reason.empty() ? "" : ": ") +
                            thing.reason);
  }
  if (failed > kMostTold)
    told.failures.push_back(written + ": and " + std::to_string(failed - kMostTold) + " more");
}

/** Throws where a result would take the place of what is not to be replaced. */
void checkFiles(const CarryArguments& arguments, const std::vector<MarkedFile>& marked) {
  CallFiles files = filesReadBy(arguments.things, arguments.site.options);
  files.reads({arguments.from, arguments.to});
  files.reads(arguments.via);
  files.reads(arguments.site.reference);
  files.reads(arguments.archive.archive);
  for (std::size_t i = 0; i < marked.size(); ++i)
    for (const std::string& name : marked[i].files)
      files.writes(inFolder(arguments.site.folder, name), arguments.things[i]);
}

int run(const CarryArguments& given) {
  const CarryArguments arguments = withFiles(given);
  const std::vector<MarkedFile> files = mapped(arguments.things, readMarked);
  checkFiles(arguments, files);
  const ResultFolder folder(arguments.site.folder);
  const auto runs = solveBoth(arguments);
  const std::size_t from = placeOfFile(runs->solved.site, arguments.from),
                    to = placeOfFile(runs->solved.site, arguments.to);
  const RealPoses real = rejoinPieces(runs->solved);
  const RunningArguments& running = arguments.site.running;
  const ForEach forEach = onThreads(running.threads, !running.isQuiet);
  StagedFiles staged;
  Told told;
  for (const MarkedFile& file : files) {
    const auto carried = carryThings(file, runs->solved, real, from, to, forEach);
    for (const NamedBytes& one : file.write(carried, runs->solved.site.mapOf(to).frame))
      staged.add(inFolder(arguments.site.folder, one.name), one.bytes);
    addFile(inFolder(arguments.site.folder, file.files.front()), file, carried, told);
  }
  staged.commit();
  if (!running.isQuiet) print(told.lines);
  for (const std::string& line : told.failures) printError(line);
  return told.failures.empty() ? runs->exitCode() : kBadData;
}

}  // namespace

std::function<int()> carryCommand(CLI::App& app) {
  const auto arguments = std::make_shared<CarryArguments>();
  addArgument(app, "THING", arguments->things,
              "What was marked on the old map: tables of places (.csv with the columns name, x, "
              "y and yaw), GeoJSON and route graphs of nav2, areas as osmAG (.osm), rooms as "
              "'compare --names' keeps them (site.json), keepout and speed masks (.yaml with "
              "picture).");
  addOption(app, "--from OLD", arguments->from, "The map that they were marked on.")->required();
  addOption(app, "--to NEW", arguments->to, "The map that they are to be carried to.")->required();
  addOption(app, "--via RUN", arguments->via,
            "More runs of the site, which tell how both maps bend.");
  addOption(app, "--archive FILE", arguments->archive.archive,
            "OLD, NEW and RUN name runs of this archive, by their files as 'archive list' names "
            "them, with or without the folder, or by eight digits of their SHA-256. Without "
            "--via, those that 'archive add' would compare with.");
  declareSite(arguments->archive, app);
  declareSite(arguments->site, "each THING under its own name", app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
