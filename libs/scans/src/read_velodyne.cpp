#include "read_velodyne.h"

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstring>

#include "point_bytes.h"

namespace roomgraph {
namespace {

struct Floats {
  const std::uint8_t* bytes = nullptr;
  std::uint32_t count = 0;
};

Floats readFloats(ByteReader& reader) {
  const auto count = reader.get<std::uint32_t>();
  return {reader.take(std::uint64_t(count) * sizeof(float)), count};
}

/** The packets of a laser scanner as it sends them, in the bytes of the file that they are from. */
struct VelodynePackets {
  static constexpr std::size_t kPacketSize = 1206, kLaserSize = 72;  ///< of one [bytes]

  ByteView packets, lasers;           ///< what was sent, and how each laser is mounted
  double minRange = 0, maxRange = 0;  ///< [m]
};

using mrpt::obs::CObservationVelodyneScan;

static_assert(sizeof(CObservationVelodyneScan::TVelodyneRawPacket) == VelodynePackets::kPacketSize);
static_assert(sizeof(mrpt::obs::VelodyneCalibration::PerLaserCalib) == VelodynePackets::kLaserSize);

template <class T>
void copyInto(std::vector<T>& list, ByteView bytes) {
  list.resize(bytes.size / sizeof(T));
  if (!list.empty()) std::memcpy(list.data(), bytes.data, list.size() * sizeof(T));
}

/** MRPT would print a line for each packet that it does not know. */
bool areKnown(const CObservationVelodyneScan& scan) {
  const std::size_t lasers = scan.calibration.laser_corrections.size();
  if (scan.scan_packets.empty() || (lasers != 16 && lasers != 32 && lasers != 64)) return false;
  for (const auto& packet : scan.scan_packets)
    for (const auto& block : packet.blocks)
      if (block.header() != CObservationVelodyneScan::UPPER_BANK &&
          (lasers < 64 || block.header() != CObservationVelodyneScan::LOWER_BANK))
        return false;
  return true;
}

/** The points that the packets of a laser scanner mean [m, sensor frame]; MRPT knows its geometry.
 *  None where a packet or the number of lasers is not one that MRPT knows. */
CloudPoints velodynePoints(const VelodynePackets& from) {
  CObservationVelodyneScan scan;
  scan.timestamp = mrpt::Clock::now();  // any: points are placed from the packets alone
  scan.minRange = from.minRange, scan.maxRange = from.maxRange;
  copyInto(scan.scan_packets, from.packets);
  copyInto(scan.calibration.laser_corrections, from.lasers);
  if (!areKnown(scan)) return {};
  scan.generatePointCloud();
  const auto bytesOf = [](const std::vector<float>& values) {
    return reinterpret_cast<const std::uint8_t*>(values.data());
  };
  const auto& cloud = scan.point_cloud;
  return pointsOf(bytesOf(cloud.x), bytesOf(cloud.y), bytesOf(cloud.z), cloud.x.size());
}

}  // namespace

void readVelodyne(ByteReader& reader, PointCloud& cloud) {
  cloud.time = readTime(reader);
  cloud.label = reader.getText();
  VelodynePackets packets;
  packets.minRange = reader.get<double>();
  packets.maxRange = reader.get<double>();
  cloud.sensor = readPose3D(reader);
  const auto part = [&reader](std::uint64_t size) {
    const std::uint64_t bytes = reader.get<std::uint32_t>() * size;
    return ByteView{reader.take(bytes), std::size_t(bytes)};
  };
  packets.packets = part(VelodynePackets::kPacketSize);
  packets.lasers = part(VelodynePackets::kLaserSize);
  const Floats x = readFloats(reader), y = readFloats(reader), z = readFloats(reader);
  if (x.count != y.count || x.count != z.count)
    refuse(reader.file(), "it is damaged: a point cloud in it has fewer y or z than x",
           "copy or save the map again");
  if (x.count > 0)
    cloud.points = [=] { return pointsOf(x.bytes, y.bytes, z.bytes, x.count); };
  else
    cloud.points = [=] { return velodynePoints(packets); };
}

}  // namespace roomgraph
