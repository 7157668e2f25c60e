#pragma once
#include <mutex>
#include <string>

#include "roomgraph/relate/KeptPairs.h"

namespace roomgraph {

/** A folder with a file for each pair of maps that was ever compared with it. Any file in it may be
 *  deleted at any time; several programs may use it at once. */
class PairFolder {
 public:
  /** Makes the folder if it is not there; without a name, nothing is kept.
   *  @throws DataError where that fails. */
  explicit PairFolder(std::string folder);

  /** To be used as long as this object lives. */
  KeptPairs kept();
  /** Why a pair could not be kept, which changes no result; empty where all could. */
  std::string failure() const { return failure_; }

 private:
  std::string fileOf(const std::string& name) const;
  void write(const std::string& name, const std::string& bytes);

  std::string folder_;
  std::mutex mutex_;
  std::string failure_;
};

}  // namespace roomgraph
