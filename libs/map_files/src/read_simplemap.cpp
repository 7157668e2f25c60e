#include "read_simplemap.h"

#include "roomgraph/map_files/grid_of_scans.h"
#include "roomgraph/scans/object_header.h"

namespace roomgraph {

bool isSimplemap(CheckedFile& file) { return announcesSimplemap(file.head()); }

GreyMap readSimplemap(CheckedFile& file, const LoadGridOptions& options) {
  return gridOfScans(file, options);
}

}  // namespace roomgraph
