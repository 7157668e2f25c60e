#include "roomgraph/scans/place_scans.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include "external_file.h"
#include "velodyne_points.h"

namespace roomgraph {
namespace {

/** What a simplemap holds, counted. */
struct Contents {
  std::size_t observations = 0, scans = 0, horizontal = 0, clouds = 0, missing = 0;
  std::string missingFile;  ///< the first one
  Voxels voxels;            ///< of all clouds, by height above the robot
};

bool isHorizontal(const RangeScan& scan) {
  using Options = mrpt::maps::COccupancyGridMap2D::TInsertionOptions;
  return scan.sensor.isHorizontal(double(Options().horizontalTolerance));
}

mrpt::obs::CObservation2DRangeScan mrptScan(const RangeScan& from) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.sensorPose = from.sensor;
  scan.sensorLabel = from.label;
  scan.timestamp = from.time;
  scan.aperture = from.aperture;
  scan.maxRange = from.maxRange;
  scan.rightToLeft = from.rightToLeft;
  scan.resizeScan(from.ranges.size());
  for (std::size_t i = 0; i < from.ranges.size(); ++i) {
    scan.setScanRange(i, from.ranges[i]);
    scan.setScanRangeValidity(i, from.isValid[i] != 0);
  }
  return scan;
}

/** Calls `use` with the cloud and its points, even where these still are packets. */
template <class Use>
void withPoints(const PointCloud& cloud, const Use& use) {
  if (!cloud.packets) return use(cloud);
  PointCloud unpacked = cloud;
  unpacked.points = velodynePoints(*cloud.packets);
  use(unpacked);
}

void addCloud(const PointCloud& cloud, const mrpt::poses::CPose3D& robot, Contents& contents) {
  ++contents.clouds;
  if (!cloud.missingFile.empty() && contents.missing++ == 0)
    contents.missingFile = cloud.missingFile;
  const mrpt::poses::CPose3D sensor = robot + cloud.sensor;
  for (const auto& point : cloud.points) {
    const auto p = sensor.composePoint(mrpt::math::TPoint3D(point));
    contents.voxels.add(p.x, p.y, p.z - robot.z());
  }
}

Contents contentsOf(const ByteReader& in) {
  Contents contents;
  readEntries(in, [&](const SimplemapEntry& entry) {
    contents.observations += entry.observations.size();
    contents.scans += entry.scans.size();
    for (const auto& scan : entry.scans) contents.horizontal += isHorizontal(scan);
    for (const PointCloud& packed : entry.clouds)
      withPoints(packed, [&](const PointCloud& cloud) { addCloud(cloud, entry.robot, contents); });
  });
  return contents;
}

std::string missingText(const Contents& contents) {
  return std::to_string(contents.missing) + " of its " + std::to_string(contents.clouds) +
         " point clouds are in files that are missing, " + contents.missingFile +
         (contents.missing > 1 ? " and others" : "");
}

[[noreturn]] void refuseEmpty(const std::string& file, const Contents& contents) {
  if (contents.missing > 0)
    refuse(file, missingText(contents), "put them into the folder " + externalFolder(file));
  refuse(file, "holds no horizontal 2D range scan and no point cloud to build a grid from",
         "give a simplemap with laser scans, or a gridmap");
}

void addNote(ScanSource& source, const char* code, const std::string& text) {
  source.notes.push_back({code, text, std::nullopt});
}

}  // namespace

ScanSource findScans(const ByteReader& in, const LoadGridOptions& options) {
  const Contents contents = contentsOf(in);
  ScanSource source;
  const bool usesScans = contents.horizontal > 0 && options.sliceHigh <= 0;
  if (!usesScans && contents.voxels.empty()) refuseEmpty(in.file(), contents);
  if (!usesScans) {
    source.slice = findSlice(contents.voxels, options);
    addNote(source, "slice",
            "its point clouds are cut: " + sliceText(*source.slice) + " (see --slice)");
    if (contents.missing > 0) addNote(source, "missing_clouds", missingText(contents));
  }
  const std::size_t used = usesScans ? contents.scans : contents.clouds;
  if (contents.observations > used)
    addNote(source, "other_observations",
            std::to_string(contents.observations - used) + " observations that are no " +
                (usesScans ? "2D range scans" : "point clouds") + " are not used");
  return source;
}

void placeScans(const ByteReader& in, const ScanSource& source, const ScanVisitor& visit) {
  readEntries(in, [&](const SimplemapEntry& entry) {
    if (source.slice) {
      for (const PointCloud& packed : entry.clouds)
        withPoints(packed, [&](const PointCloud& cloud) {
          if (!cloud.points.empty()) visit(entry, sliceScan(cloud, entry.robot, *source.slice));
        });
      return;
    }
    for (const RangeScan& read : entry.scans) {
      if (!isHorizontal(read)) continue;
      const mrpt::obs::CObservation2DRangeScan scan = mrptScan(read);
      visit(entry, {entry.robot, scan, rangesId(scan)});
    }
  });
}

}  // namespace roomgraph
