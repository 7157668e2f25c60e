#include "simulate_scans.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <cmath>

#include "Random.h"
#include "make_mrpt_grid.h"

namespace roomgraph {
namespace {

using mrpt::obs::CObservation2DRangeScan;

constexpr double kFirstSecond = 1.6e9;  // of the time stamps: a fixed one keeps the bytes equal

void blur(CObservation2DRangeScan& scan, double noiseStd, Random& random) {
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    if (!scan.getScanRangeValidity(i)) continue;
    const double range = scan.getScanRange(i) + noiseStd * random.normal();
    scan.setScanRange(i, float(std::round(range * 256) / 256));
  }
}

}  // namespace

mrpt::maps::CSimpleMap simulateScans(const GreyMap& map, const std::vector<WalkPose>& poses,
                                     const SimulateScansOptions& options) {
  std::vector<Transform2D> believed;
  for (const WalkPose& pose : poses) believed.push_back({pose.place.x, pose.place.y, pose.heading});
  return simulateScans(map, poses, believed, options);
}

mrpt::maps::CSimpleMap simulateScans(const GreyMap& map, const std::vector<WalkPose>& poses,
                                     const std::vector<Transform2D>& believed,
                                     const SimulateScansOptions& options) {
  const auto grid = makeMrptGrid(map);
  Random random(options.seed);
  mrpt::maps::CSimpleMap frames;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const mrpt::poses::CPose2D pose(poses[i].place.x, poses[i].place.y, poses[i].heading);
    auto scan = CObservation2DRangeScan::Create();
    scan->aperture = float(1.5 * M_PI);
    scan->maxRange = float(options.maxRange);
    scan->sensorLabel = "LASER";
    scan->timestamp = mrpt::Clock::fromDouble(kFirstSecond + double(i));
    grid.laserScanSimulator(*scan, pose, 0.5f, std::size_t(options.beams));
    blur(*scan, options.noiseStd, random);
    mrpt::obs::CSensoryFrame frame;
    frame.insert(scan);
    const mrpt::poses::CPose2D at(believed[i].x, believed[i].y, believed[i].phi);
    const mrpt::poses::CPose3DPDFGaussian where{mrpt::poses::CPose3D(at)};
    frames.insert(where, frame);
  }
  return frames;
}

}  // namespace roomgraph
