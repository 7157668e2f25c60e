#pragma once
#include <functional>
#include <optional>

#include "roomgraph/base/Notes.h"
#include "roomgraph/scans/read_entries.h"
#include "roomgraph/scans/slice_scan.h"

namespace roomgraph {

/** How the horizontal scans of a simplemap are to be had. */
struct ScanSource {
  std::optional<Slice> slice;  ///< of its point clouds; none where it has horizontal scans
  bool takesTilted = false;    ///< its 2D scans are nearly horizontal at best
  Notes notes;                 ///< what is not used, and what was chosen
};

/** Looks through the simplemap: its horizontal 2D scans are used, or, where it has none or
 *  options ask for a slice, its point clouds; where there are neither, 2D scans tilted by up to 3
 *  degrees, as if they were level ("tilted_scans"). Throws DataError where there is none of these,
 *  or all clouds are kept in files that are missing. */
ScanSource findScans(const ByteReader& in, const LoadGridOptions& options);

/** A scan of the source, with the entry that it is from. */
using ScanVisitor = std::function<void(const SimplemapEntry& entry, const PlacedScan& placed)>;

/** Calls `visit` for each of the scans, in the order of the file. */
void placeScans(const ByteReader& in, const ScanSource& source, const ScanVisitor& visit);

}  // namespace roomgraph
