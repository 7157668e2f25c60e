#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "output_names.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/repair/carry_places.h"
#include "roomgraph/repair/places_csv.h"
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

std::string lineOf(const std::string& file, const std::vector<CarriedPlace>& carried) {
  std::array<std::size_t, 4> counts{};
  for (const CarriedPlace& place : carried) ++counts[std::size_t(place.state)];
  std::vector<std::string> parts;
  for (const CarryState state :
       {CarryState::carried, CarryState::unsure, CarryState::gone, CarryState::unseen})
    parts.push_back(std::to_string(counts[std::size_t(state)]) + " " + nameOf(state));
  return printable(file + ": " + counted(carried.size(), "place: ", "places: ") + listed(parts)) +
         "\n";
}

bool isAllCarried(const std::vector<CarriedPlace>& carried) {
  return std::all_of(carried.begin(), carried.end(),
                     [](const CarriedPlace& place) { return place.state == CarryState::carried; });
}

int run(const CarryArguments& arguments) {
  SiteArguments site = arguments.site;
  site.files = {arguments.from, arguments.to};
  for (const std::string& file : arguments.via) site.files.push_back(file);
  makeWritableFolder(site.folder);
  std::vector<std::string> texts;
  std::vector<std::vector<Place>> places;
  for (const std::string& thing : arguments.things) {
    texts.push_back(readFile(thing));
    places.push_back(placesOfCsv(texts.back(), thing));
  }
  const auto runs = solveRuns(site);
  const std::size_t from = placeOf(arguments.from, *runs), to = placeOf(arguments.to, *runs);
  const RealPoses real = rejoinPieces(runs->solved);
  StagedFiles staged;
  std::string lines;
  bool areCarried = true;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto carried = carryPlaces(places[i], runs->solved, real, from, to);
    const std::string name =
        (fs::path(site.folder) / fs::path(arguments.things[i]).filename()).string();
    if (areSameFile(name, arguments.things[i]))
      throw UsageError(name +
                       ": would replace what is carried: choose another folder with --output");
    staged.add(name, carriedCsv(texts[i], arguments.things[i], carried));
    lines += lineOf(name, carried);
    areCarried = areCarried && isAllCarried(carried);
  }
  staged.commit();
  if (!site.running.isQuiet) print(lines);
  return areCarried ? kDone : kBadData;
}

}  // namespace

std::function<int()> carryCommand(CLI::App& app) {
  const auto arguments = std::make_shared<CarryArguments>();
  addArgument(app, "THING", arguments->things,
              "What was marked on the old map: tables of places (.csv with the columns name, x, "
              "y and yaw).");
  addOption(app, "--from OLD", arguments->from, "The map that they were marked on.")->required();
  addOption(app, "--to NEW", arguments->to, "The map that they are to be carried to.")->required();
  addOption(app, "--via RUN", arguments->via,
            "More runs of the site, which tell how both maps bend.");
  declareSite(arguments->site, "each THING under its own name", app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
