#pragma once
#include <functional>
#include <string>
#include <vector>

#include "roomgraph/base/Notes.h"

namespace roomgraph {

/** Whole lines to stdout, each made printable; names within them should be so already, as they may
 *  hold line ends. */
void print(const std::string& lines);

/** A line for each file that was written, below what was done. */
std::string fileLines(const std::vector<std::string>& files);

/** Throws DataError where not all that was printed has arrived, as on a full disk. */
void checkPrinted();

/** "roomgraph: text" and a line end; one printable line. */
std::string errorLine(const std::string& text);

/** Such a line on stderr. */
void printError(const std::string& text);

/** What the user is told of an exception. */
struct Failure {
  std::string line;  ///< with its line end
  int exitCode = 0;
};

/** The exception that is being handled, as one line. `file` is put in front of messages that do not
 *  name the file themselves. */
Failure currentFailure(const std::string& file);

/** Does the job for each file in turn. One that fails costs a line on stderr, and the others are
 *  done all the same. Gives the exit code: the largest of the failures', or kDone. */
int doEach(const std::vector<std::string>& files,
           const std::function<void(const std::string& file)>& job);

/** A note on a map. */
struct MapNote {
  std::string file;
  Note note;
};

/** For stderr: one line per note when verbose, else the warnings, and at most one line more per
 *  map, for the first of its notes of a kind that was not told yet, and how many more there are. */
std::string noteLines(const std::vector<MapNote>& notes, bool isVerbose);
/** The warnings among them alone: what is told with --quiet, too. */
std::string warningLines(const std::vector<MapNote>& notes);
/** For commands that tell no other notes. */
void printWarnings(const std::string& file, const Notes& notes);

}  // namespace roomgraph
