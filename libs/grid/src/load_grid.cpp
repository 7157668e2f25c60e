#include "roomgraph/grid/load_grid.h"

#include <new>

#include "roomgraph/files/checked_file.h"
#include "roomgraph/grid/map_formats.h"
#include "roomgraph/grid/mrpt_object.h"

namespace roomgraph {
namespace {

/** MRPT's own classes, as against a word that begins a text. */
bool isRegisteredName(const std::string& className) {
  return className.size() > 1 && className[0] == 'C' && className[1] >= 'A' && className[1] <= 'Z';
}

[[noreturn]] void refuseUnknown(CheckedFile& file) {
  if (file.head().size == 0) refuse(file.name(), "is empty", "copy or save the map again");
  const std::string remedy = "give an " + mapFormatNames();
  const auto object = peekObjectHeader(file.head());
  if (object && isRegisteredName(object->className))
    refuse(file.name(), "holds an MRPT object of class " + object->className, remedy);
  refuse(file.name(), "is no map of a known kind", remedy);
}

GreyMap readByContent(CheckedFile& file, const LoadGridOptions& options) {
  for (const MapFormat& format : mapFormats()) {
    if (!format.looksLike(file)) continue;
    GreyMap map = format.read(file, options);
    map.source.kind = format.kind;
    return map;
  }
  refuseUnknown(file);
}

}  // namespace

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

GreyMap loadGrid(const std::string& name, const LoadGridOptions& options) {
  try {
    CheckedFile file(name);
    GreyMap map = readByContent(file, options);
    map.source.file = name;
    if (map.source.sha256.empty()) map.source.sha256 = file.sha256();
    return map;
  } catch (const DataError&) {
    throw;
  } catch (const std::bad_alloc&) {
    refuse(name, "there is not enough memory for it", "give a smaller map");
  } catch (const std::exception&) {
    // MRPT's texts run over many lines and name its source files.
    refuse(name, "it cannot be read as a map", "copy or save the map again");
  }
}

}  // namespace roomgraph
