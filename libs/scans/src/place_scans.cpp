#include "roomgraph/scans/place_scans.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include "external_file.h"

namespace roomgraph {
namespace {

/** What a simplemap holds, counted. */
struct Contents {
  std::size_t observations = 0, scans = 0, horizontal = 0, clouds = 0, missing = 0;
  std::string missingFile;  ///< the first one
  Voxels voxels;            ///< of all clouds, by height above the robot
};

bool isHorizontal(const mrpt::obs::CObservation2DRangeScan& scan) {
  using Options = mrpt::maps::COccupancyGridMap2D::TInsertionOptions;
  return scan.isPlanarScan(double(Options().horizontalTolerance));
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
    for (const PointCloud& cloud : entry.clouds) addCloud(cloud, entry.robot, contents);
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
      for (const PointCloud& cloud : entry.clouds)
        if (!cloud.points.empty()) visit(entry, sliceScan(cloud, entry.robot, *source.slice));
      return;
    }
    for (const auto& scan : entry.scans)
      if (isHorizontal(scan)) visit(entry, {entry.robot, scan, rangesId(scan)});
  });
}

}  // namespace roomgraph
