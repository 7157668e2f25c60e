#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/compare/gate.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

struct ComparisonFile;

/** The files that are written of a comparison. */
class ResultFiles {
 public:
  /** `formats` is a list for --format. @throws UsageError for a format that is none. */
  explicit ResultFiles(std::filesystem::path folder, const std::string& formats = "all");

  /** Leaves out files that draw maps and are there already. Says which. */
  std::vector<std::string> keepDrawn();

  /** Whether the list names files of trajectories, see addTrajectories; "all" does not. */
  bool hasTrajectories() const { return hasTrajectories_; }
  std::vector<std::string> names() const;
  void add(const Comparison& saved, const std::vector<Run>& runs, StagedFiles& staged) const;

 private:
  std::string nameOf(const ComparisonFile& file) const;

  std::filesystem::path folder_;
  std::vector<const ComparisonFile*> files_;
  bool hasTrajectories_ = false;
};

/** The names of all files of a comparison, for the help. */
std::string listedFiles();

/** --format, for ResultFiles. */
void declareFormats(std::string& formats, CLI::App& app);

/** --fail-below, --fail-above, --fail-worse-by, --fail-on, --junit and --summary. */
struct GateArguments {
  GateOptions limits;          ///< without the candidates
  std::string junit, summary;  ///< files; empty for none
};

void declareGate(GateArguments& arguments, CLI::App& app);

/** The files for CI systems that are asked for. */
void addGateFiles(const Comparison& comparison, const GateArguments& arguments,
                  StagedFiles& staged);

/** Adds the verdict of a gate that asks for anything; whether it fails. */
bool addGate(Comparison& comparison, const GateOptions& gate);

/** Where a file lies, seen from a folder; empty where there is no way from one to the other. */
std::string seenFrom(const std::filesystem::path& folder, const std::filesystem::path& file);

/** All results of a comparison. `runs` are those whose maps are drawn, `more` the names of files
 *  that are written besides. */
void addResults(Comparison comparison, const std::vector<Run>& runs, const ResultFiles& files,
                const std::vector<std::string>& more, StagedFiles& staged);

/** `more` are files besides the usual ones. */
void printResults(const Comparison& comparison, const ResultFiles& files,
                  const std::vector<std::string>& more);
/** What each map holds, on stderr. */
void printMaps(const std::vector<Run>& runs);
/** What a call ends with, which is said unless all is done: kGateFailed where the gate failed a
 *  run, kBadData where nothing was compared, so that no run could be judged but by its site. */
int exitCodeOf(const Comparison& comparison, const GateOptions& gate);
}  // namespace roomgraph
