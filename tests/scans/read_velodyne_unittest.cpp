#include <gtest/gtest.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstring>

#include "clouds.h"
#include "roomgraph/grid/binarize.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

using test::oneObservation;

class ReadVelodyne : public test::Clouds {};

TEST_F(ReadVelodyne, pointsOfVelodyneScansGiveTheRoom) {
  mrpt::obs::CObservationVelodyneScan scan;
  scan.sensorPose = sensor_;
  for (const auto& p : points_) {
    scan.point_cloud.x.push_back(p.x);
    scan.point_cloud.y.push_back(p.y);
    scan.point_cloud.z.push_back(p.z);
    scan.point_cloud.intensity.push_back(1);
  }
  expectRoom(load(oneObservation(test::streamed(scan))));
}

TEST_F(ReadVelodyne, packetsOfVelodyneScansArePlacedByMrpt) {
  mrpt::obs::CObservationVelodyneScan scan;
  scan.timestamp = mrpt::Clock::now();
  scan.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
  for (int packet = 0; packet < 75; ++packet) {
    mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket raw{};
    for (int block = 0; block < 12; ++block) {
      auto* bytes = reinterpret_cast<std::uint8_t*>(&raw.blocks[block]);
      const std::uint16_t azimuth = std::uint16_t((packet * 12 + block) * 40);
      bytes[0] = 0xff, bytes[1] = 0xee;
      std::memcpy(bytes + 2, &azimuth, 2);
      for (int k = 0; k < 32; ++k) {
        const std::uint16_t distance = 1500;  // 3 m in units of 2 mm
        std::memcpy(bytes + 4 + 3 * k, &distance, 2);
      }
    }
    scan.scan_packets.push_back(raw);
  }
  const auto walls = test::occupiedPlaces(binarize(load(oneObservation(test::streamed(scan))), {}));
  for (const Point p : walls) {
    EXPECT_GT(norm(p), 2.8);
    EXPECT_LT(norm(p), 3.1);
  }
  EXPECT_GT(walls.size(), 200u) << "rings at 3 m and 1 to 15 degrees up or down";
}

}  // namespace
}  // namespace roomgraph
