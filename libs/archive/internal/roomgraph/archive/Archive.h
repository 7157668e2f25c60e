#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/archive/SiteHistory.h"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

class Database;

/** A comparison that an archive is to keep. */
struct Addition {
  std::string site;
  std::vector<HistoryRun> runs;  ///< of the compared ones, those that may be new
  Comparison comparison;
  /** How many runs the site had when the comparison began; nothing to keep it whatever was added
   *  since. */
  std::optional<std::size_t> knownRuns{};
};

/** What became of it. */
struct Added {
  std::size_t runs = 0;     ///< that were not known before
  std::string roomsFailed;  ///< why its rooms could not be told from those that are known; or empty
  bool isOutdated = false;  ///< nothing was kept: the site has other runs by now, see `knownRuns`
};

/** One file that keeps, of every run of one or several sites, where it comes from, its figures and
 *  what it has of each room. It changes in transactions: a call that is killed has added a run
 *  wholly or not at all. Several programs may use one at a time. All but the constructor, record(),
 *  nameRoom(), removeRun() and renameRobot() change nothing. Errors are DataErrors of one line. */
class Archive {
 public:
  enum class Access { existing, orNew };

  /** Brings an archive of an earlier version up to date. With Access::orNew it is made where there
   *  is none. */
  Archive(const std::string& file, Access access);
  ~Archive();

  std::vector<std::string> sites() const;
  /** All runs of a site, by time, then by content, without rooms; of their figures only kMapError
   *  and kBreaks: what is enough to choose those to compare with. O(runs). */
  std::vector<HistoryRun> runs(const std::string& site) const;
  bool knows(const std::string& site, const std::string& sha256) const;
  /** Empty for a site that is not there. O(all that is kept of it). */
  SiteHistory history(const std::string& site) const;

  /** Keeps the runs that are not known yet, each once for all, and the figures of those that had
   *  none to be trusted before. Its rooms get the ids and names that the site knows, and new ones
   *  are remembered once two runs have them. Where three or more runs agree with each other, and
   *  are more than the site has, they become the site. With nothing new it changes nothing. O(runs
   *  of the comparison * rooms), however many runs there are already. */
  Added record(const Addition& addition);

  /** Gives a room of a site another name, which it keeps; its id stays.
   *  @throws DataError where there is no such room. */
  void nameRoom(const std::string& site, const std::string& id, const std::string& name);

  /** Takes a run out, with its figures; those of other runs stay. `run` is its file as listed, the
   *  name of that file, or at least eight digits of its SHA-256.
   *  @throws DataError where there is no such run, or where several could be meant. */
  void removeRun(const std::string& site, const std::string& run);

  /** Gives the runs of a robot another name. @throws DataError where there is no such robot. */
  void renameRobot(const std::string& site, const std::string& robot, const std::string& name);

 private:
  std::unique_ptr<Database> database_;
};

}  // namespace roomgraph
