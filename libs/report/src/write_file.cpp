#include "roomgraph/report/write_file.h"

#include "roomgraph/report/StagedFiles.h"

namespace roomgraph {

void writeFileAtomically(const std::string& path, const std::string& bytes) {
  StagedFiles files;
  files.add(path, bytes);
  files.commit();
}

}  // namespace roomgraph
