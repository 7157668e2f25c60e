#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "CallFiles.h"
#include "roomgraph/compare/compare_maps.h"
#include "terminal.h"

namespace roomgraph {

/** The arguments that set options of the pipeline, the same in every subcommand. */
struct OptionArguments {
  std::string preset = "default";
  std::optional<std::string> configFile;
  std::vector<std::string> settings;  ///< SECTION.KEY=VALUE
  std::optional<std::string> resolution, roomWidth, alphaPx2, robotWidth;
  std::vector<std::string> slice;  ///< empty, or low and high
  std::string layer;               ///< of a metric map
};

/** Puts the options that `declare` adds under a heading of their own in the help. */
void underHeading(const std::string& heading, CLI::App& app, const std::function<void()>& declare);

/** Declares --preset, --config and --set. Help texts come from the field table. */
void declareConfig(OptionArguments& arguments, CLI::App& app);
/** Declares what maps are read with: --resolution, --slice and --layer. */
void declareReading(OptionArguments& arguments, CLI::App& app);
/** Declares both. */
void declareOptions(OptionArguments& arguments, CLI::App& app);
/** Declares --room-width, --alpha-px2 and --robot-width. */
void declareRooms(OptionArguments& arguments, CLI::App& app);

/** The files that a call reads: its maps, and first its options. */
CallFiles filesReadBy(const std::vector<std::string>& maps, const OptionArguments& arguments);

/** Declares --fail-on, comma-separated lists of words that set these flags; may be repeated. */
void declareFailOn(const std::vector<std::pair<std::string, bool*>>& flags,
                   const std::string& sentence, CLI::App& app);

/** Declares --output, the folder for `results`. A command writes several files for each map, which
 *  would be hard to tell from others: where no folder is named, they go into roomgraph-COMMAND. */
void declareOutput(std::string& folder, const std::string& results, CLI::App& app);

/** How a command that works on maps runs. */
struct RunningArguments {
  unsigned threads = 0;  ///< 0 for one per core
  bool showsTimings = false, isQuiet = false, isVerbose = false;
};

/** Declares --timings, --threads, --quiet and --verbose; `things` are worked on at the same time,
 *  and --verbose prints `more`, too. */
void declareRunning(RunningArguments& arguments, const std::string& things, const std::string& more,
                    CLI::App& app);

/** The notes of maps for stderr, as many as these arguments ask for, see terminal.h. */
std::string noteLines(const std::vector<MapNote>& notes, const RunningArguments& arguments);

/** Declares --threads; `what` are worked on at the same time. */
void declareThreads(unsigned& threads, const std::string& what, CLI::App& app);
/** Declares --quiet. */
void declareQuiet(bool& isQuiet, CLI::App& app);

/** First the preset, then the file, then --set, then the shorthands; later ones win. The file may
 *  also have options of a comparison, --set may not.
 *  Throws UsageError for an unknown name or a value out of range, and DataError for an earlier
 *  result that cannot be read. */
ExtractOptions toOptions(const OptionArguments& arguments);
/** The same for a comparison, whose options --set may set, too. */
CompareMapsOptions toCompareOptions(const OptionArguments& arguments);

/** Options that were given and that no map of a call had a use for. Used by all threads. */
class UnusedOptions {
 public:
  /** Whether the note is on such an option, which then need not be told of the map. */
  bool take(const Note& note);
  /** Takes these, and prints the warnings among all others. */
  std::function<void(const std::string& file, const Note&)> takeOrWarn();
  /** A line on stderr for each option that none of so many maps has used. */
  void tell(std::size_t maps) const;

 private:
  std::mutex mutex_;
  std::map<std::string, std::size_t> maps_;  ///< by the text of the note
};

}  // namespace roomgraph
