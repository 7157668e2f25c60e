#include "read_velodyne.h"

#include "point_bytes.h"
#include "roomgraph/scans/read_observation.h"
#include "velodyne_points.h"

namespace roomgraph {
namespace {

struct Floats {
  const std::uint8_t* bytes = nullptr;
  std::uint32_t count = 0;
};

Floats readFloats(ByteReader& in) {
  const auto count = in.get<std::uint32_t>();
  return {in.take(std::uint64_t(count) * sizeof(float)), count};
}

}  // namespace

void readVelodyne(ByteReader& in, PointCloud& cloud) {
  cloud.time = readTime(in);
  cloud.label = readText(in);
  VelodynePackets packets;
  packets.minRange = in.get<double>();
  packets.maxRange = in.get<double>();
  cloud.sensor = readPose3D(in);
  const auto part = [&in](std::uint64_t size) {
    const std::uint64_t bytes = in.get<std::uint32_t>() * size;
    return ByteView{in.take(bytes), std::size_t(bytes)};
  };
  packets.packets = part(VelodynePackets::kPacketSize);
  packets.lasers = part(VelodynePackets::kLaserSize);
  const Floats x = readFloats(in), y = readFloats(in), z = readFloats(in);
  if (x.count != y.count || x.count != z.count)
    refuse(in.file(), "it is damaged: a point cloud in it has fewer y or z than x",
           "copy or save the map again");
  if (x.count > 0)
    cloud.points = [=] { return pointsOf(x.bytes, y.bytes, z.bytes, x.count); };
  else
    cloud.points = [=] { return velodynePoints(packets); };
}

}  // namespace roomgraph
