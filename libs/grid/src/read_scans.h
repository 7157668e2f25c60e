#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <functional>

#include "roomgraph/grid/byte_reader.h"

namespace roomgraph {

using ScanVisitor = std::function<void(const mrpt::poses::CPose3D& robot,
                                       const mrpt::obs::CObservation2DRangeScan& scan)>;

struct SimplemapCounts {
  std::size_t entries = 0, scans = 0, others = 0;
};

/** Whether an object of this class is a CSimpleMap under one of its names. */
bool isSimplemapClass(const std::string& className);

/** Compares the number of entries that the first bytes claim with the size of the whole. */
void checkSimplemapHead(ByteReader head, std::uint64_t size);

/** Takes a whole simplemap apart and calls `visit` for every 2D range scan in it, in order. Ranges
 *  that are no length (NaN, negative) arrive as invalid ones. Throws DataError where anything
 *  contradicts the format or a number is absurd. */
SimplemapCounts readScans(ByteReader in, const ScanVisitor& visit);

}  // namespace roomgraph
