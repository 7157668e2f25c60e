#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <set>

#include "commands.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/repair/carry_things.h"
#include "roomgraph/repair/read_marked.h"
#include "site_runs.h"
#include "terminal.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

struct CarryArguments {
  SiteArguments site;
  std::vector<std::string> things, via;
  std::string from, to;
};

/** The place of a map in the site. */
std::size_t placeOf(const std::string& file, const SolvedRuns& runs) {
  const Site& site = runs.solved.site;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    if (site.runs[i]->file == file) return i;
  throw DataError(file +
                  ": does not lie in the other map: nothing can be carried; give runs that " +
                  "lie in both with --via");
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

bool isAllCarried(const std::vector<CarriedThing>& carried) {
  return std::all_of(carried.begin(), carried.end(),
                     [](const CarriedThing& thing) { return thing.state == CarryState::carried; });
}

/** The files that are written, none of them one that is read, or another of them. */
class Results {
 public:
  Results(std::string folder, std::vector<std::string> inputs)
      : folder_(std::move(folder)), inputs_(std::move(inputs)) {}

  /** Returns its name. */
  std::string add(const NamedBytes& file) {
    std::string name = (fs::path(folder_) / file.name).string();
    for (const std::string& input : inputs_)
      if (areSameFile(name, input))
        throw UsageError(name +
                         ": would replace what is read: choose another folder with --output");
    if (!names_.insert(name).second)
      throw UsageError(name + ": is asked for twice: carry files of one name one after the other");
    staged_.add(name, file.bytes);
    return name;
  }
  void commit() { staged_.commit(); }

 private:
  std::string folder_;
  std::vector<std::string> inputs_;
  std::set<std::string> names_;
  StagedFiles staged_;
};

int run(const CarryArguments& arguments) {
  SiteArguments site = arguments.site;
  site.files = {arguments.from, arguments.to};
  for (const std::string& file : arguments.via) site.files.push_back(file);
  makeWritableFolder(site.folder);
  std::vector<MarkedFile> files;
  for (const std::string& thing : arguments.things) files.push_back(readMarked(thing));
  const auto runs = solveRuns(site);
  const std::size_t from = placeOf(arguments.from, *runs), to = placeOf(arguments.to, *runs);
  const RealPoses real = rejoinPieces(runs->solved);
  std::vector<std::string> inputs = site.files;
  inputs.insert(inputs.end(), arguments.things.begin(), arguments.things.end());
  Results results(site.folder, inputs);
  std::string lines;
  bool areCarried = true;
  for (const MarkedFile& file : files) {
    const auto carried = carryThings(file, runs->solved, real, from, to);
    std::vector<std::string> names;
    for (const NamedBytes& one : file.write(carried, runs->solved.site.mapOf(to).frame))
      names.push_back(results.add(one));
    lines += lineOf(names.front(), file.kind, carried);
    areCarried = areCarried && isAllCarried(carried);
  }
  results.commit();
  if (!site.running.isQuiet) print(lines);
  return areCarried ? kDone : kBadData;
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
  declareSite(arguments->site, "each THING under its own name", app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
