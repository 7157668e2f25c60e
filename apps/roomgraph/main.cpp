#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <thread>

#include "HelpFormatter.h"
#include "commands.h"
#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/version.h"
#include "terminal.h"
#include "usage_fault.h"

namespace roomgraph {
namespace {

constexpr Command kCommands[] = {
    {"extract", "Turn maps into topology graphs with rooms.", extractCommand},
    {"route",
     "Find the shortest way between two places of a map, and through which doors it leads.",
     routeCommand},
    {"where", "Tell in which room or corridor a place of a map is.", whereCommand},
    {"compare", "Rank several maps of one site, and tell how far off each of them is.",
     compareCommand},
    {"check",
     "Estimate from the scans of each run by itself how far it contradicts itself, and where it "
     "breaks.",
     checkCommand},
    {"repair", "Correct the key frames of runs by what all runs of a site agree on.",
     repairCommand},
    {"merge", "Make one map of a site from several runs.", mergeCommand},
    {"carry", "Carry places from one map of a site to another.", carryCommand},
    {"report", "Rewrite the results of a comparison from its JSON, and apply a gate to them.",
     reportCommand},
    {"archive", "Keep the runs of a site night by night, and tell whether its maps get worse.",
     archiveCommand},
    {"watch", "Add each map that is written into a folder to an archive, and tell how good it is.",
     watchCommand},
    {"plan", "Write the tasks that bring an archive of many sites up to date.", planCommand},
    {"task", "Do a task of a plan, unless it has been done.", taskCommand},
    {"collect", "Put the results of the tasks of a plan into the archive.", collectCommand},
    {"stability",
     "Measure how much noise on the walls changes the graphs of maps, as in the paper.",
     stabilityCommand},
    {"score-rooms", "Measure how well the rooms of a label picture agree with the true rooms.",
     scoreRoomsCommand},
    {"convert", "Convert maps to ROS maps, MRPT grid maps or pictures.", convertCommand},
    {"export-rawlog", "Write the scans of a simplemap as a log for MRPT's RawLogViewer.",
     exportRawlogCommand},
    {"info", "Show what is in a map, a graph, a comparison or an MRPT object (.json, .roomgraph).",
     infoCommand},
    {"config", "Print all options as a commented ini file, for use with --config.", configCommand},
};

/** What shows the help of the command that was parsed last. */
std::string helpOf(const CLI::App& app) {
  std::string call = app.get_name();
  for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    call += " " + at->get_name();
  }
  return call + " --help";
}

/** The words of the call; 'help compare' as of git is 'compare --help'. */
std::vector<std::string> wordsOf(int count, char** arguments) {
  std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.empty() || words.front() != "help") return words;
  words.erase(words.begin());
  const auto isCalled = [&](const Command& command) { return command.name == words.front(); };
  if (words.empty() || anyOf(kCommands, isCalled)) words.emplace_back("--help");
  return words;
}

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
  const std::vector<std::string> words = wordsOf(count, arguments);
  if (words.empty()) return std::fputs(app.help().c_str(), stderr), kBadUsage;
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    const std::string fault = usageFault(app, words, error);
    printError(fault + " (see '" + helpOf(app) + "')");
    return kBadUsage;
  }
  return exitCode;
}

/** What the caller ignores, as nohup and background jobs do, is to be ignored: a signal that is
 *  blocked would be kept. */
bool isIgnored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/** From now on SIGINT, SIGTERM and SIGHUP end the program, as ever, but after the results that are
 *  just taking their places, and with none left unfinished. To be called before other threads are
 *  started. */
void finishResultsBeforeEnding() {
  sigset_t endings;
  sigemptyset(&endings);
  for (const int ending : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU})
    if (!isIgnored(ending)) sigaddset(&endings, ending);
  // A file that grows too large is then an error as any other.
  std::signal(SIGXFSZ, SIG_IGN);
  pthread_sigmask(SIG_BLOCK, &endings, nullptr);  // in all threads, which inherit it
  std::thread([endings] {
    int ending = 0;
    sigwait(&endings, &ending);
    StagedFiles::abandonAll();
    std::signal(ending, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &endings, nullptr);
    std::raise(ending);
  }).detach();
}

/** Before main only libraries that are being started end the program: with too little memory. */
[[noreturn]] void endWithoutMemory() {
  std::fputs("roomgraph: not enough memory to start: raise the limit (ulimit -v)\n", stderr);
  std::_Exit(kBadData);
}

std::terminate_handler usualEnd = nullptr;

/** Sanitizers are not there yet. */
[[gnu::no_sanitize("address", "thread", "undefined")]] void endAsWeSay() {
  usualEnd = std::set_terminate(endWithoutMemory);
}

/** Called before the libraries start. */
[[gnu::used, gnu::section(".preinit_array")]] void (*const kBeforeAll)() = endAsWeSay;

}  // namespace
}  // namespace roomgraph

int main(int count, char** arguments) {
  std::set_terminate(roomgraph::usualEnd);
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
