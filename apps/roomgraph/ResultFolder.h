#pragma once
#include <set>
#include <string>
#include <vector>

#include "roomgraph/base/StagedFiles.h"

namespace roomgraph {

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
