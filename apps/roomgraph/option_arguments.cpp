#include "option_arguments.h"

#include <algorithm>
#include <boost/algorithm/string/split.hpp>
#include <cmath>
#include <memory>

#include "commands.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/read_document.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/graph_files/read_graph_json.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/report/comparison_json.h"

namespace roomgraph {
namespace {

/** What the option table says of a key, for the help of its shorthand. */
std::string help(const char* section, const char* key) {
  ExtractOptions options;
  const FieldTable table = describe(options);
  for (const Field& field : table.fields())
    if (field.section == section && field.name == key)
      return field.sentence + " (" + rangeText(field) + "; sets " + section + "." + key + ")";
  throw std::logic_error(std::string("no option ") + section + "." + key);
}

std::string textOf(const std::string& file) {
  try {
    return readFile(file);
  } catch (const DataError& error) {
    throw UsageError(std::string("--config ") + error.what());
  }
}

/** An ini file, or the options that an earlier graph or comparison was made with. */
void readConfig(const std::string& file, FieldTable& table) {
  const std::string text = textOf(file);
  const char first = firstLetter(text);
  if (!first)
    throw UsageError("--config " + file +
                     ": is empty: see 'roomgraph config', or leave the option out");
  const bool isJson = first == '{';
  constexpr std::size_t kLargestIni = 1'000'000;
  if (!isJson && text.size() > kLargestIni)
    throw UsageError("--config " + file + ": is too long for an ini file: see 'roomgraph " +
                     "config'");
  if (isJson && jsonFault(text, "roomgraph/comparison").empty())
    setUsed(parseComparisonJson(text, file), table);
  else
    fromIni(isJson ? optionsIni(parseGraphJson(text, file)) : text, file, table);
}

void applySetting(const std::string& setting, FieldTable& table) {
  const auto equals = setting.find('=');
  const auto dot = setting.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals)
    throw UsageError("--set " + setting +
                     ": use SECTION.KEY=VALUE with a section and key of 'roomgraph config'");
  table.set(setting.substr(0, dot), setting.substr(dot + 1, equals - dot - 1),
            setting.substr(equals + 1));
}

/** `settable` is what --set may set of `known`, the options of the file. */
void apply(const OptionArguments& arguments, ExtractOptions& options, FieldTable known,
           FieldTable settable) {
  const double assumed = options.loadGrid.resolution;
  options.loadGrid.resolution = NAN;  // no text can set that
  if (arguments.configFile) readConfig(*arguments.configFile, known);
  // Outputs name the usual one where none was given.
  if (options.loadGrid.resolution == assumed) options.loadGrid.resolution = NAN;
  for (const std::string& setting : arguments.settings) applySetting(setting, settable);
  if (arguments.resolution) known.set("load_grid", "resolution", *arguments.resolution);
  if (!arguments.slice.empty()) {
    known.set("load_grid", "slice_low", arguments.slice[0]);
    known.set("load_grid", "slice_high", arguments.slice[1]);
    if (!(options.loadGrid.sliceHigh > options.loadGrid.sliceLow))
      throw UsageError("--slice: HIGH must be above LOW");
  }
  options.loadGrid.layer = arguments.layer;
  if (arguments.roomWidth) {
    known.set("find_rooms", "min_width", *arguments.roomWidth);
    known.set("find_rooms", "alpha_px2", "0");
  }
  if (arguments.alphaPx2) known.set("find_rooms", "alpha_px2", *arguments.alphaPx2);
  if (arguments.robotWidth) known.set("room_graph", "robot_width", *arguments.robotWidth);
  options.loadGrid.isResolutionGiven = !std::isnan(options.loadGrid.resolution);
  if (!options.loadGrid.isResolutionGiven) options.loadGrid.resolution = assumed;
}

/** What stands between commas; "a,,b," has four words. */
std::vector<std::string> wordsOf(const std::string& list) {
  std::vector<std::string> words;
  return boost::algorithm::split(words, list, [](char c) { return c == ','; });
}

}  // namespace

void underHeading(const std::string& heading, CLI::App& app, const std::function<void()>& declare) {
  const std::size_t before = app.get_options({}).size();
  declare();
  const std::vector<CLI::Option*> options = app.get_options({});
  for (std::size_t i = before; i < options.size(); ++i)
    if (!options[i]->get_positional()) options[i]->group(heading);
}

void declareConfig(OptionArguments& arguments, CLI::App& app) {
  addOption(app, "--preset NAME", arguments.preset,
            "The options to start from: 'default' (in metres; unknown cells stay unknown) or "
            "'paper' (the paper's numbers, in cells).")
      ->capture_default_str();
  addOption(app, "-c,--config FILE", arguments.configFile,
            "Take the options from an ini file (see 'roomgraph config'), or those that an "
            "earlier X.json or comparison.json was made with.");
  addOption(app, "--set SECTION.KEY=VALUE", arguments.settings,
            "Set one option, after --config; may be repeated.")
      ->allow_extra_args(false);
}

void declareReading(OptionArguments& arguments, CLI::App& app) {
  addOption(app, "--resolution M", arguments.resolution, help("load_grid", "resolution"));
  addOption(app, "--slice LOW HIGH", arguments.slice,
            "Cut point clouds to this band of heights above the floor, instead of to the one "
            "with the longest straight walls; in a simplemap, even where there are 2D scans. "
            "(m; sets load_grid.slice_low and slice_high)")
      ->expected(2);
  addOption(app, "--layer NAME", arguments.layer,
            "The layer of a metric map (.mm) to read. Without it, the first grid is read, or "
            "the points if there is no grid.");
}

void declareOptions(OptionArguments& arguments, CLI::App& app) {
  declareConfig(arguments, app);
  declareReading(arguments, app);
}

void declareRooms(OptionArguments& arguments, CLI::App& app) {
  CLI::Option* width =
      addOption(app, "--room-width M", arguments.roomWidth, help("find_rooms", "min_width"));
  addOption(app, "--alpha-px2 A", arguments.alphaPx2, help("find_rooms", "alpha_px2"))
      ->excludes(width);
  addOption(app, "--robot-width M", arguments.robotWidth, help("room_graph", "robot_width"));
}

void declareFailOn(const std::vector<std::pair<std::string, bool*>>& flags,
                   const std::string& sentence, CLI::App& app) {
  const auto lists = std::make_shared<std::vector<std::string>>();  // as long as the option
  // CLI11's own lists pass over what is empty.
  const auto setFlags = [flags, lists](const std::string& list) -> std::string {
    const auto known = mapped(flags, [](const auto& flag) { return flag.first; });
    for (const std::string& word : wordsOf(list)) {
      const auto found = std::find(known.begin(), known.end(), word);
      if (found == known.end())
        return "'" + word + "' is not one of " + listed(known) + ", separated by commas";
      *flags[found - known.begin()].second = true;
    }
    return {};
  };
  addOption(app, "--fail-on LIST", *lists, sentence)
      ->allow_extra_args(false)
      ->check(CLI::Validator(setFlags, ""));
}

void declareOutput(std::string& folder, const std::string& results, CLI::App& app) {
  folder = "roomgraph-" + app.get_name();
  addOption(app, "-o,--output DIR", folder,
            "Folder for the results: " + results + "; created if missing.")
      ->capture_default_str();
}

void declareThreads(unsigned& threads, const std::string& what, CLI::App& app) {
  addOption(app, "--threads N", threads,
            "How many " + what + " to work on at once; 0 for one per core.")
      ->capture_default_str();
}

void declareQuiet(bool& isQuiet, CLI::App& app) {
  app.add_flag("-q,--quiet", isQuiet, "Print only errors and warnings.");
}

void declareRunning(RunningArguments& arguments, const std::string& things, const std::string& more,
                    CLI::App& app) {
  app.add_flag("--timings", arguments.showsTimings,
               "Print a table of the steps and their times to stderr.");
  declareThreads(arguments.threads, things, app);
  CLI::Option* quiet = app.add_flag("-q,--quiet", arguments.isQuiet,
                                    "Print only errors, warnings and the table of --timings.");
  app.add_flag("-v,--verbose", arguments.isVerbose, "Also print " + more + ".")->excludes(quiet);
}

std::string noteLines(const std::vector<MapNote>& notes, const RunningArguments& arguments) {
  return arguments.isQuiet ? warningLines(notes) : noteLines(notes, arguments.isVerbose);
}

bool UnusedOptions::take(const Note& note) {
  if (note.code != kUnusedOption) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  ++maps_[note.text];
  return true;
}

std::function<void(const std::string&, const Note&)> UnusedOptions::takeOrWarn() {
  return [this](const std::string& file, const Note& note) {
    if (!take(note)) printWarnings(file, {note});
  };
}

void UnusedOptions::tell(std::size_t maps) const {
  for (const auto& [text, count] : maps_)
    if (count == maps) printError("note: " + text);
}

ExtractOptions toOptions(const OptionArguments& arguments) {
  CompareMapsOptions options;
  options.extract = preset(arguments.preset);
  apply(arguments, options.extract, describe(options), describe(options.extract));
  return options.extract;
}

CompareMapsOptions toCompareOptions(const OptionArguments& arguments) {
  CompareMapsOptions options;
  options.extract = preset(arguments.preset);
  apply(arguments, options.extract, describe(options), describe(options));
  options.onNote = [](const std::string& file, const Note& note) { printWarnings(file, {note}); };
  return options;
}

CallFiles filesReadBy(const std::vector<std::string>& maps, const OptionArguments& arguments) {
  CallFiles files;
  files.reads(maps);
  files.consults(arguments.configFile.value_or(""));
  return files;
}

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
