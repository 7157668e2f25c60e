#pragma once
#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/PointCloud.h"
#include "roomgraph/scans/mrpt_object.h"

namespace roomgraph {

/** Reads what follows the header of a CObservationVelodyneScan, up to its points: those that it
 *  holds, else those that its packets mean. */
void readVelodyne(ByteReader& reader, PointCloud& cloud);

/** The packets of a laser scanner as it sends them, in the bytes of the file that they are from. */
struct VelodynePackets {
  static constexpr std::size_t kPacketSize = 1206, kLaserSize = 72;  ///< of one [bytes]

  ByteView packets, lasers;           ///< what was sent, and how each laser is mounted
  double minRange = 0, maxRange = 0;  ///< [m]
};

/** The points that the packets of a laser scanner mean [m, sensor frame]; MRPT knows its geometry.
 *  None where a packet or the number of lasers is not one that MRPT knows. */
CloudPoints velodynePoints(const VelodynePackets& from);

}  // namespace roomgraph
