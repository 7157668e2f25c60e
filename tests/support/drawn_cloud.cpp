#include "drawn_cloud.h"

#include <mrpt/poses/CPose3DPDFGaussian.h>

#include "map_files.h"
#include "newer_simplemap.h"

namespace roomgraph::test {

Points roomPoints() {
  Points points;
  constexpr float floor = -0.4f, step = 0.04f;
  for (float a = -2; a <= 2; a += step) {
    for (float b = -2; b <= 2; b += step) points.emplace_back(a, b, floor);
    for (float z = floor; z < floor + 2.5f; z += 0.07f)
      for (const float wall : {-2.f, 2.f}) {
        points.emplace_back(a, wall, z);
        points.emplace_back(wall, a, z);
      }
  }
  for (float x = 1.5f; x < 2; x += step)  // a table 0.7 m high
    for (float y = -1; y < 1; y += step)
      for (float z = floor; z < floor + 0.7f; z += 0.1f) points.emplace_back(x, y, z);
  return points;
}

Points seenFrom(const mrpt::poses::CPose3D& sensor, const Points& points) {
  Points seen;
  for (const auto& p : points) {
    const auto local = sensor.inverseComposePoint(mrpt::math::TPoint3D(p));
    seen.emplace_back(float(local.x), float(local.y), float(local.z));
  }
  return seen;
}

std::string pointBytes(const Points& points) {
  std::string x, y, z;
  for (const auto& p : points) x += raw(p.x), y += raw(p.y), z += raw(p.z);
  return raw(std::uint32_t(points.size())) + x + y + z;
}

std::string pointsMapBytes(const std::string& className, int version, const Points& points,
                           const std::string& rest) {
  return std::string(1, char(0x80 | className.size())) + className + char(version) +
         pointBytes(points) + rest + "\x88";
}

std::string cloudBytes(const mrpt::poses::CPose3D& sensor, const std::string& stored) {
  const std::string name = "mrpt::obs::CObservationPointCloud", label = "lidar";
  return std::string(1, char(0x80 | name.size())) + name + '\0' + raw(std::uint32_t(label.size())) +
         label + raw<std::int64_t>(132'000'000'000'000'000) + streamed(sensor) + stored + "\x88";
}

std::string oneObservation(const std::string& observation) {
  return simplemapBytes(2, {streamed(mrpt::poses::CPose3DPDFGaussian()) +
                            frameBytes({observation}) + twistBytes(true)});
}

}  // namespace roomgraph::test
