#include "roomgraph/map_files/grid_of_scans.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "readers.h"
#include "roomgraph/base/Options.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/scans/mrpt_scan.h"

namespace roomgraph {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::poses::CPose3D;

// Beyond this, MRPT's single precision no longer tells neighbouring cells apart.
constexpr double kFarthestPose = 1e5;
// MRPT traces its rays in integers that a longer side would overflow.
constexpr double kLongestSide = 1e6;

/** Where the scans reach, and how many there are to insert. */
struct Extent {
  Box box;
  double longest = 0;

  /** Whether nothing that is as near to a place adds to it. */
  bool holds(Point p, double reach) const {
    return box.contains(p - Point{reach, reach}) && box.contains(p + Point{reach, reach});
  }
};

/** Adds the sensor and the ends of its beams as MRPT draws them: it runs those without return half
 *  as far as the last one with a return. */
void addScan(Extent& extent, const CPose3D& sensor, const RangeScan& scan,
             const LoadGridOptions& options) {
  const Point from{sensor.x(), sensor.y()};
  extent.box.include(from);
  const bool isUpsideDown = sensor.getRotationMatrix()(2, 2) < 0;
  const double turn = scan.rightToLeft != isUpsideDown ? 1 : -1;
  const double start = sensor.yaw() - turn * double(scan.aperture) / 2;
  double last = options.maxDistanceInsertion;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (scan.isValid[i]) last = double(scan.ranges[i]);
    if (!scan.isValid[i] && !options.considerInvalidRangesAsFreeSpace) continue;
    const double reach = std::min(scan.isValid[i] ? last : last / 2, options.maxDistanceInsertion);
    extent.longest = std::max(extent.longest, reach);
    if (extent.holds(from, reach)) continue;
    const double angle =
        start + turn * double(scan.aperture) * double(i) / double(scan.ranges.size());
    extent.box.include(from + reach * Point{std::cos(angle), std::sin(angle)});
  }
}

Extent extentOf(const PlacedScans& scans, const LoadGridOptions& options) {
  Extent extent;
  for (const PlacedScan& placed : scans.scans) {
    const CPose3D sensor = placed.from + placed.scan.sensor;
    if (!(std::abs(sensor.x()) < kFarthestPose && std::abs(sensor.y()) < kFarthestPose))
      refuse(scans.file, "has a scan farther than 100 km from the origin",
             "shift the map to near (0, 0)");
    addScan(extent, sensor, placed.scan, options);
  }
  return extent;
}

/** Makes the grid large enough beforehand. MRPT would grow it scan by scan, copying each time, and
 *  writes outside of it where a scan does not surround its sensor. */
void setSize(COccupancyGridMap2D& grid, const Extent& extent, const std::string& file,
             double resolution) {
  // Rounding bends MRPT's rays by up to a cell in 1024; closer than 15 cells to the border it
  // grows.
  const double margin = (20 + extent.longest / resolution / 512) * resolution;
  const Box box = extent.box.widened(margin);
  const Point cells = (1 / resolution) * box.size();
  if (std::max(cells.x, cells.y) > kLongestSide || cells.x * cells.y > double(kMostCells))
    refuse(file, "its scans reach over more than 400 million cells",
           "use a coarser resolution, or check its poses");
  grid.setSize(float(box.low.x), float(box.high.x), float(box.low.y), float(box.high.y),
               float(resolution));
}

void setInsertion(COccupancyGridMap2D& grid, const LoadGridOptions& options) {
  grid.insertionOptions.maxDistanceInsertion = float(options.maxDistanceInsertion);
  grid.insertionOptions.maxOccupancyUpdateCertainty = float(options.maxOccupancyUpdateCertainty);
  grid.insertionOptions.considerInvalidRangesAsFreeSpace = options.considerInvalidRangesAsFreeSpace;
  grid.insertionOptions.wideningBeamsWithDistance = options.wideningBeamsWithDistance;
}

std::string insertionText(LoadGridOptions options) {
  FieldTable table;
  describe(options, table);
  std::string text;
  for (const Field& field : table.fields())
    text += (text.empty() ? "" : "; ") + field.name + " = " + valueText(field);
  return text;
}

GreyMap toGreyMap(const COccupancyGridMap2D& grid, double resolution) {
  GreyMap map;
  map.frame.width = int(grid.getSizeX());
  map.frame.height = int(grid.getSizeY());
  map.frame.resolution = resolution;
  // MRPT aligns the border to multiples of the resolution, in single precision.
  map.frame.origin = {resolution * std::round(double(grid.getXMin()) / resolution),
                      resolution * std::round(double(grid.getYMin()) / resolution)};
  std::array<std::uint8_t, 256> table;
  for (int cell = -128; cell < 128; ++cell) table[std::uint8_t(cell)] = greyOfLogOdds(cell);
  map.grey.resize(map.frame.cellCount());
  auto out = map.grey.begin();
  for (int y = 0; y < map.frame.height; ++y) {
    const auto* row = grid.getRow(y);
    out = std::transform(row, row + map.frame.width, out,
                         [&](auto cell) { return table[std::uint8_t(cell)]; });
  }
  map.occupiedAbove = 0.55;
  map.freeBelow = 0.45;
  return map;
}

}  // namespace

GreyMap gridOfScans(const PlacedScans& scans, const LoadGridOptions& options) {
  LoadGridOptions insertion = options;
  // A cloud has no points where its rings see above or below the slice: that is not free.
  if (scans.areSlices) insertion.considerInvalidRangesAsFreeSpace = false;
  COccupancyGridMap2D grid;
  setSize(grid, extentOf(scans, insertion), scans.file, options.resolution);
  setInsertion(grid, insertion);
  for (const PlacedScan& placed : scans.scans)
    grid.insertObservation(mrptScan(placed.scan), placed.from);

  GreyMap map = toGreyMap(grid, options.resolution);
  map.source.insertion = insertionText(insertion);
  map.notes = scans.notes;
  return map;
}

}  // namespace roomgraph
