#include "roomgraph/mrpt_plugin/mrpt_files.h"

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "object_bytes.h"
#include "roomgraph/base/compressed.h"
#include "roomgraph/scans/mrpt_scan.h"

namespace roomgraph {
namespace {

mrpt::obs::CActionCollection actionOf(const mrpt::poses::CPose2D& way,
                                      mrpt::Clock::time_point time) {
  mrpt::obs::CActionRobotMovement2D movement;
  movement.timestamp = time;
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmGaussian;
  movement.computeFromOdometry(way, model);
  mrpt::obs::CActionCollection actions;
  actions.insert(movement);
  return actions;
}

using mrpt::maps::COccupancyGridMap2D;

/** The step of MRPT's whose probability is nearest, and on the right side of 0.5. */
std::array<COccupancyGridMap2D::cellType, 256> cellsOf(State state) {
  std::array<COccupancyGridMap2D::cellType, 256> cells{};
  if (state == State::unknown) return cells;
  constexpr float surely = 0.6f;  // beyond the thresholds of a grid map, 0.45 and 0.55
  for (std::size_t grey = 0; grey < 256; ++grey) {
    const float free = float(grey) / 255;
    cells[grey] = COccupancyGridMap2D::p2l(state == State::free ? std::max(free, surely)
                                                                : std::min(free, 1 - surely));
  }
  return cells;
}

/** Writes the frame's corners into the object: MRPT itself would move them to multiples of the
 *  resolution. They follow the class's name, its version, the bits per cell and the size. */
void placeAt(const GridFrame& frame, std::string& object) {
  const std::size_t index = 1 + std::size_t(object[0] & 0x7f) + 1 + 1 + 4 + 4;
  const double width = frame.width * frame.resolution, height = frame.height * frame.resolution;
  const std::array<float, 4> corners{float(frame.origin.x), float(frame.origin.x + width),
                                     float(frame.origin.y), float(frame.origin.y + height)};
  std::memcpy(object.data() + index, corners.data(), sizeof corners);
}

}  // namespace

std::string rawlogBytes(const std::vector<PlacedScan>& scans) {
  std::string bytes;
  mrpt::poses::CPose2D before;
  for (const PlacedScan& one : scans) {
    const mrpt::poses::CPose2D pose(one.from);
    bytes += objectBytes(actionOf(pose - before, one.scan.time));
    mrpt::obs::CSensoryFrame frame;
    frame.insert(mrpt::obs::CObservation2DRangeScan::Create(mrptScan(one.scan)));
    bytes += objectBytes(frame);
    before = pose;
  }
  return gzipped(bytes, kGzipMark);
}

std::vector<PlacedScan> moved(std::vector<PlacedScan> scans, const Transform2D& motion) {
  const mrpt::poses::CPose3D change(motion.x, motion.y, 0, motion.phi, 0, 0);
  for (PlacedScan& one : scans) one.from = change + one.from;
  return scans;
}

std::string gridmapBytes(const GreyMap& map, const Grid& grid) {
  const GridFrame& frame = map.frame;
  COccupancyGridMap2D object;
  object.setSize(0, float(frame.width * frame.resolution), 0,
                 float(frame.height * frame.resolution), float(frame.resolution));
  if (int(object.getSizeX()) != frame.width || int(object.getSizeY()) != frame.height)
    throw std::logic_error("MRPT's grid has another size than was asked for");
  const std::array tables{cellsOf(State::unknown), cellsOf(State::free), cellsOf(State::occupied)};
  for (int y = 0; y < frame.height; ++y) {
    auto* row = object.getRow(y);
    for (int x = 0; x < frame.width; ++x)
      row[x] = tables[std::size_t(grid.at({x, y}))][map.grey[frame.index({x, y})]];
  }
  std::string bytes = objectBytes(object);
  placeAt(frame, bytes);
  return gzipped(bytes, kGzipMark);
}

}  // namespace roomgraph
