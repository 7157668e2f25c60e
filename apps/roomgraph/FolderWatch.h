#pragma once
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace roomgraph {

/** What is written into a folder gives its maps away when they are whole: once their file is closed
 *  or moved into the folder, and nothing has been written to it for kSettle since. Linux only. */
class FolderWatch {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kSettle{2};

  /** Watches from now on; what is there already comes, too.
   *  @throws DataError where it is no folder that can be watched. */
  explicit FolderWatch(const std::string& folder);
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;
  ~FolderWatch();

  /** Waits for the next map: its name with the folder. What has changed comes before what was there
   *  at the start, which comes by name. @throws DataError where the folder is gone. */
  std::string next();

 private:
  void listAll();
  void readEvents();
  void handle(unsigned what, const std::string& name);
  /** The map that a file is part of: itself, or the yaml beside a picture; empty for none. */
  std::string mapOf(const std::string& name) const;
  /** The yaml that names a picture of another name; empty for none. O(files of the folder). */
  std::string mapWithPicture(const std::string& name) const;
  std::optional<std::string> takeWhole();
  /** How long to wait for events [ms]; -1 for as long as it takes. */
  int patience() const;
  std::string path(const std::string& name) const;

  std::string folder_;
  int inotify_ = -1;
  std::map<std::string, Clock::time_point> changed_;  ///< when each will have settled
  std::set<std::string> listed_;                      ///< found, and not changed since
};

}  // namespace roomgraph
