#include "roomgraph/scans/load_run_info.h"

#include "roomgraph/scans/object_header.h"
#include "roomgraph/scans/read_run_info.h"

namespace roomgraph {

std::optional<RunInfo> loadRunInfo(const std::string& name) {
  CheckedFile file(name);
  if (!announcesSimplemap(file.head())) return std::nullopt;
  return readRunInfo(file);
}

}  // namespace roomgraph
