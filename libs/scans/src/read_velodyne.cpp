#include "read_velodyne.h"

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>

#include "point_bytes.h"
#include "roomgraph/scans/read_observation.h"

namespace roomgraph {
namespace {

using mrpt::math::TPoint3Df;

struct Floats {
  const std::uint8_t* bytes = nullptr;
  std::uint32_t count = 0;
};

Floats readFloats(ByteReader& in) {
  const auto count = in.get<std::uint32_t>();
  return {in.take(std::uint64_t(count) * sizeof(float)), count};
}

/** Points that the packets of a laser scanner mean; MRPT knows its geometry. */
std::vector<TPoint3Df> pointsOfPackets(const ByteReader& packets, const ByteReader& lasers,
                                       mrpt::obs::CObservationVelodyneScan& scan) {
  using Packet = mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket;
  using Laser = mrpt::obs::VelodyneCalibration::PerLaserCalib;
  scan.scan_packets.resize(packets.left() / sizeof(Packet));
  if (!scan.scan_packets.empty())
    std::memcpy(scan.scan_packets.data(), packets.peek(), packets.left());
  scan.calibration.laser_corrections.resize(lasers.left() / sizeof(Laser));
  if (!scan.calibration.laser_corrections.empty())
    std::memcpy(scan.calibration.laser_corrections.data(), lasers.peek(), lasers.left());
  const std::size_t count = scan.calibration.laser_corrections.size();
  if (scan.scan_packets.empty() || (count != 16 && count != 32 && count != 64)) return {};
  for (const Packet& packet : scan.scan_packets)
    for (const auto& block : packet.blocks)
      if (block.header() != mrpt::obs::CObservationVelodyneScan::UPPER_BANK &&
          (count < 64 || block.header() != mrpt::obs::CObservationVelodyneScan::LOWER_BANK))
        return {};  // MRPT would print a line for each of them
  scan.generatePointCloud();
  std::vector<TPoint3Df> points;
  for (std::size_t i = 0; i < scan.point_cloud.x.size(); ++i)
    points.emplace_back(scan.point_cloud.x[i], scan.point_cloud.y[i], scan.point_cloud.z[i]);
  points.erase(
      std::remove_if(points.begin(), points.end(), [](const TPoint3Df& p) { return !isFinite(p); }),
      points.end());
  return points;
}

}  // namespace

void readVelodyne(ByteReader& in, PointCloud& cloud) {
  constexpr std::size_t packetSize =
      sizeof(mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket);
  constexpr std::size_t laserSize = sizeof(mrpt::obs::VelodyneCalibration::PerLaserCalib);
  cloud.time = readTime(in);
  cloud.label = readText(in);
  mrpt::obs::CObservationVelodyneScan scan;
  scan.timestamp = mrpt::Clock::now();  // any: points are placed from the packets alone
  scan.minRange = in.get<double>();
  scan.maxRange = in.get<double>();
  cloud.sensor = readPose3D(in);
  const auto part = [&in](std::uint64_t size) {
    const std::uint64_t bytes = in.get<std::uint32_t>() * size;
    return ByteReader({in.take(bytes), std::size_t(bytes)}, in.file());
  };
  const ByteReader packets = part(packetSize), lasers = part(laserSize);
  const Floats x = readFloats(in), y = readFloats(in), z = readFloats(in);
  if (x.count != y.count || x.count != z.count)
    refuse(in.file(), "it is damaged: a point cloud in it has fewer y or z than x",
           "copy or save the map again");
  cloud.points = x.count > 0 ? pointsOf(x.bytes, y.bytes, z.bytes, x.count)
                             : pointsOfPackets(packets, lasers, scan);
}

}  // namespace roomgraph
