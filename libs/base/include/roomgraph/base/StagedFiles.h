#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace roomgraph {

/** Files that take the place of older ones together. add() writes each under another name in its
 *  folder and flushes it to the disk; commit() renames them all, which needs no more room. Whatever
 *  fails or stops before, a full disk or a damaged input, leaves all older files as they were. What
 *  a process that was killed leaves behind, X.roomgraph-part0, goes when X is written again. */
class StagedFiles {
 public:
  /** By how much the name of a file is longer while it is written [bytes]. */
  static constexpr std::size_t kLongestSuffix = 18;

  StagedFiles();  ///< without any file
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;
  /** Removes what was added and is not renamed. */
  ~StagedFiles();

  /** A link is followed, and a file that is there already keeps its permissions. Nothing of this
   *  file is left behind on failure. Returns the name under which it can be read until commit().
   *  @throws DataError with one line (file, problem, remedy). */
  std::string add(const std::string& path, const std::string& bytes);

  /** In the order in which they were added, each in one step. @throws DataError like add(); all are
   *  as they were then, but on file systems that cannot exchange two files. */
  void commit();

  /** For a process that is about to end: waits for commits that have begun, then removes all that
   *  any StagedFiles has added and not renamed. No other call returns after it. */
  static void abandonAll();

 private:
  class Part;
  std::vector<std::unique_ptr<Part>> parts_;
};

}  // namespace roomgraph
