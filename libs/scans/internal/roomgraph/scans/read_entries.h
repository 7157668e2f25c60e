#pragma once
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>

#include <functional>
#include <optional>
#include <vector>

#include "roomgraph/scans/RangeScan.h"
#include "roomgraph/scans/read_cloud.h"

namespace roomgraph {

/** An observation, whether it is used or stepped over. */
struct ObservationKind {
  std::string className;
  int version = 0;
  std::string label;  ///< of the sensor; empty where the class is not known here
};

/** What a simplemap keeps of one place. */
struct SimplemapEntry {
  mrpt::poses::CPose3D robot;
  std::size_t number = 0;  ///< from 0, in the order of the file
  std::vector<RangeScan> scans;
  std::vector<PointCloud> clouds;
  std::optional<mrpt::poses::CPose2D> odometry;  ///< the last one, in the robot's odometry frame
  std::vector<ObservationKind> observations;     ///< of all classes
};

using EntryVisitor = std::function<void(const SimplemapEntry& entry)>;

/** Compares the number of entries that the first bytes claim with the size of the whole. */
void checkSimplemapHead(ByteReader head, std::uint64_t size);

/** Takes a whole simplemap apart and calls `visit` for every entry in it, in order. Observations of
 *  other classes are stepped over. Throws DataError where anything contradicts the format or a
 *  number is absurd. */
void readEntries(ByteReader in, const EntryVisitor& visit);

}  // namespace roomgraph
