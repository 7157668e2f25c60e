#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

void describe(LoadGridOptions& options, FieldTable& table) {
  const char* section = "load_grid";
  table.number(section, "resolution", options.resolution, "m", 0.001, 10,
               "Side of a cell, for bare pictures and for grids built from a simplemap.");
  table.number(section, "max_distance_insertion", options.maxDistanceInsertion, "m", 0.1, 1000,
               "Ranges of a simplemap's scans beyond this are cut off.");
  table.number(section, "max_occupancy_update_certainty", options.maxOccupancyUpdateCertainty, "",
               0.51, 0.99,
               "How sure one beam of a simplemap's scans makes a cell, as a probability.");
  table.flag(section, "consider_invalid_ranges_as_free_space",
             options.considerInvalidRangesAsFreeSpace,
             "Whether beams of a simplemap's scans without return clear the cells they pass.");
  table.flag(section, "widening_beams_with_distance", options.wideningBeamsWithDistance,
             "Whether beams of a simplemap's scans widen with distance.");
  table.number(section, "slice_low", options.sliceLow, "m", 0, 100,
               "Lower end of the band that point clouds are cut to, above the floor.");
  table.number(section, "slice_high", options.sliceHigh, "m", 0, 100,
               "Upper end of that band; 0 for the band with the longest straight walls.");
}

}  // namespace roomgraph
