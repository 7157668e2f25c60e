#pragma once
#include <set>
#include <string>
#include <vector>

#include "roomgraph/base/StagedFiles.h"

namespace roomgraph {

/** Where a map's results go: folder/X.extension, see mapStem. */
std::string outputFile(const std::string& folder, const std::string& mapFile,
                       const std::string& extension);

/** The name of a mended run: "run01.repaired.simplemap.gz" of "run01.simplemap.gz". */
std::string repairedName(const std::string& file);

/** Whether two names are of one file, which must exist. */
bool areSameFile(const std::string& one, const std::string& other);

/** Whether two names are of one file once both are written; none need be there yet. */
bool wouldBeSameFile(const std::string& one, const std::string& other);

/** Throws UsageError where two maps have a result of the same name, or where a result would replace
 *  one of the maps, the picture that a ROS map names, or a yaml, picture, grid map or log that this
 *  program has not written. */
void checkOutputNames(const std::vector<std::string>& mapFiles, const std::string& folder,
                      const std::vector<std::string>& extensions);

/** A folder of results, which appear together; none of them takes the place of what was read. */
class ResultFolder {
 public:
  /** Makes the folder where it is not there. */
  ResultFolder(const std::string& folder, std::vector<std::string> inputs);

  /** Returns the name with the folder. @throws UsageError where a file of this name is an input, or
   *  was added before. */
  std::string add(const std::string& name, const std::string& bytes);
  /** A file elsewhere that is brought up to date with them. */
  void addBeside(const std::string& file, const std::string& bytes) { staged_.add(file, bytes); }
  void commit() { staged_.commit(); }

 private:
  std::string folder_;
  std::vector<std::string> inputs_;
  std::set<std::string> added_;
  StagedFiles staged_;
};

}  // namespace roomgraph
