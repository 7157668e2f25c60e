#include "terminal.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <set>
#include <sstream>

#include "commands.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/failure_text.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

std::string lineOf(const MapNote& one) { return one.file + ": note: " + one.note.text; }

std::string allLines(const std::vector<MapNote>& notes) {
  std::string lines;
  for (const MapNote& one : notes) {
    std::string text = lineOf(one);
    if (one.note.where)
      text += formatted(" (at %.2f, %.2f)", (*one.note.where)[0], (*one.note.where)[1]);
    lines += errorLine(text);
  }
  return lines;
}

}  // namespace

std::string noteLines(const std::vector<MapNote>& notes, bool isVerbose) {
  if (isVerbose) return allLines(notes);
  std::set<std::string> files, codes;  // that were told
  std::vector<std::string> told;
  std::size_t more = 0;
  for (const MapNote& one : notes) {
    if (one.note.isWarning) continue;
    if (codes.insert(one.note.code).second && files.insert(one.file).second)
      told.push_back(lineOf(one));
    else
      ++more;
  }
  if (more > 0)
    told.back() += " (and " + counted(more, "more note", "more notes") + ": see --verbose)";
  std::string lines = warningLines(notes);
  for (const std::string& text : told) lines += errorLine(text);
  return lines;
}

std::string warningLines(const std::vector<MapNote>& notes) {
  std::string lines;
  for (const MapNote& one : notes)
    if (one.note.isWarning) lines += errorLine(lineOf(one));
  return lines;
}

void printWarnings(const std::string& file, const Notes& notes) {
  for (const Note& note : notes)
    if (note.isWarning) printError(lineOf({file, note}));
}

void print(const std::string& lines) {
  std::istringstream in(lines);
  std::string whole;
  for (std::string line; std::getline(in, line);) whole += printable(line) + "\n";
  std::fputs(whole.c_str(), stdout);
  std::fflush(stdout);
}

std::string fileLines(const std::vector<std::string>& files) {
  std::string lines;
  for (const std::string& file : files) lines += "  " + printable(file) + "\n";
  return lines;
}

void checkPrinted() {
  std::cout.flush();  // CLI11's help
  const bool isWhole = std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (!isWhole)
    refuse("standard output", "not all of the text could be written to it",
           "give it a place that is open and has room");
}

std::string errorLine(const std::string& text) {
  constexpr std::size_t kMost = 10000;  // bytes; a name has at most 4096
  return "roomgraph: " + printable(text.substr(0, kMost)) + "\n";
}

void printError(const std::string& text) { std::fputs(errorLine(text).c_str(), stderr); }

Failure currentFailure(const std::string& file) {
  const std::string line = errorLine(failureText(file));
  try {
    throw;
  } catch (const UsageError&) {
    return {line, kBadUsage};
  } catch (const std::exception&) {
    return {line, kBadData};
  }
}

int doEach(const std::vector<std::string>& files,
           const std::function<void(const std::string& file)>& job) {
  int exitCode = kDone;
  for (const std::string& file : files) {
    try {
      job(file);
    } catch (...) {
      const Failure failure = currentFailure(file);
      std::fputs(failure.line.c_str(), stderr);
      exitCode = std::max(exitCode, failure.exitCode);
    }
  }
  return exitCode;
}

}  // namespace roomgraph
