#include "roomgraph/archive/named_run.h"

#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"

namespace roomgraph {
namespace {

bool isMeant(const std::string& name, const HistoryRun& run) {
  return name == run.file || name == fileName(run.file) ||
         (name.size() >= 8 && run.sha256.compare(0, name.size(), name) == 0);
}

}  // namespace

const HistoryRun& namedRun(const std::vector<HistoryRun>& runs, const std::string& name,
                           const std::string& archive) {
  const HistoryRun* meant = nullptr;
  for (const HistoryRun& run : runs) {
    if (!isMeant(name, run)) continue;
    if (meant)
      throw DataError(archive + ": has several runs named " + name +
                      ": name one by its whole file or its SHA-256, which 'export' tells");
    meant = &run;
  }
  if (!meant)
    throw DataError(archive + ": has no run " + name + ": 'list' names those that it has");
  return *meant;
}

}  // namespace roomgraph
