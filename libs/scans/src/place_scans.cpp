#include "roomgraph/scans/place_scans.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "external_file.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/scans/read_cloud.h"
#include "velodyne_points.h"

namespace roomgraph {
namespace {

/** What a simplemap holds, counted. */
struct Contents {
  std::size_t observations = 0, scans = 0, horizontal = 0, nearlyLevel = 0, clouds = 0, missing = 0;
  double tilt = 0;                           ///< the largest of the nearly level scans [rad]
  std::map<std::string, std::size_t> kinds;  ///< observations by class
  std::string missingFile;                   ///< the first one
  bool arePlanar = true;                     ///< all clouds are what level 2D scanners see
  Voxels voxels;                             ///< of all clouds, by height above the robot
};

// Beyond this, beams that look down meet the floor within a room.
constexpr double kMostTilt = 3.01 * M_PI / 180;  // 3 degrees, and rounding

/** Between the sensor's plane and the robot's [rad]; a sensor that hangs upside down has none. */
double tiltOf(const RangeScan& scan) {
  return std::acos(std::min(1.0, std::abs(scan.sensor.getRotationMatrix()(2, 2))));
}

bool isHorizontal(const RangeScan& scan) {
  using Options = mrpt::maps::COccupancyGridMap2D::TInsertionOptions;
  return scan.sensor.isHorizontal(double(Options().horizontalTolerance));
}

/** The pose without its tilt. */
mrpt::poses::CPose3D level(const mrpt::poses::CPose3D& sensor) {
  const bool isUpsideDown = sensor.getRotationMatrix()(2, 2) < 0;
  return {sensor.x(), sensor.y(), sensor.z(), sensor.yaw(), 0, isUpsideDown ? M_PI : 0};
}

mrpt::obs::CObservation2DRangeScan mrptScan(const RangeScan& from) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.sensorPose = isHorizontal(from) ? from.sensor : level(from.sensor);
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

/** Whether a level scanner with one plane may have seen the points as the robot rocked a little. */
bool isPlanar(const PointCloud& cloud, const mrpt::poses::CPose3D& sensor) {
  constexpr float thickest = 0.05f;      // [m]
  constexpr double mostUpright = 0.985;  // 10 degrees off
  const auto [low, high] =
      std::minmax_element(cloud.points.begin(), cloud.points.end(),
                          [](const auto& a, const auto& b) { return a.z < b.z; });
  return low == cloud.points.end() || (high->z - low->z <= thickest &&
                                       std::abs(sensor.getRotationMatrix()(2, 2)) >= mostUpright);
}

void addCloud(const PointCloud& cloud, const mrpt::poses::CPose3D& robot, Contents& contents) {
  ++contents.clouds;
  if (!cloud.missingFile.empty() && contents.missing++ == 0)
    contents.missingFile = cloud.missingFile;
  const mrpt::poses::CPose3D sensor = robot + cloud.sensor;
  contents.arePlanar = contents.arePlanar && isPlanar(cloud, sensor);
  for (const auto& point : cloud.points) {
    const auto p = sensor.composePoint(mrpt::math::TPoint3D(point));
    contents.voxels.add(p.x, p.y, p.z - robot.z());
  }
}

void addScan(const RangeScan& scan, Contents& contents) {
  ++contents.scans;
  contents.horizontal += isHorizontal(scan);
  const double tilt = tiltOf(scan);
  if (tilt > kMostTilt) return;
  ++contents.nearlyLevel;
  contents.tilt = std::max(contents.tilt, tilt);
}

Contents contentsOf(const ByteReader& in) {
  Contents contents;
  readEntries(in, [&](const SimplemapEntry& entry) {
    contents.observations += entry.observations.size();
    for (const ObservationKind& kind : entry.observations) ++contents.kinds[kind.className];
    for (const RangeScan& scan : entry.scans) addScan(scan, contents);
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

/** ", only 28 CObservationIMU, 3 CObservation2DRangeScan that are tilted". */
std::string kindsText(const Contents& contents) {
  std::string text;
  for (const auto& [name, count] : contents.kinds) {
    text += (text.empty() ? ", only " : ", ") + std::to_string(count) + " " + name;
    if (name == "CObservation2DRangeScan") text += " that are tilted";
    if (isCloudClass(name)) text += " without points that can be read";
  }
  return text;
}

[[noreturn]] void refuseEmpty(const std::string& file, const Contents& contents) {
  if (contents.missing > 0)
    refuse(file, missingText(contents), "put them into the folder " + externalFolder(file));
  if (contents.horizontal > 0)
    refuse(file, "holds no point cloud to cut to a slice, only 2D range scans",
           "leave --slice out");
  refuse(file,
         "holds no horizontal 2D range scan and no point cloud to build a grid from" +
             kindsText(contents),
         "give a simplemap with laser scans, or a gridmap");
}

Slice wholePlane() {
  Slice slice;
  slice.isFlat = true;
  return slice;
}

void addNote(ScanSource& source, const char* code, const std::string& text) {
  source.notes.push_back({code, text, std::nullopt});
}

}  // namespace

ScanSource findScans(const ByteReader& in, const LoadGridOptions& options) {
  const Contents contents = contentsOf(in);
  ScanSource source;
  source.takesTilted =
      contents.horizontal == 0 && contents.nearlyLevel > 0 && contents.voxels.empty();
  const bool usesScans = (contents.horizontal > 0 && options.sliceHigh <= 0) || source.takesTilted;
  if (!usesScans && contents.voxels.empty()) refuseEmpty(in.file(), contents);
  if (source.takesTilted)
    addNote(source, "tilted_scans",
            formatted("its 2D range scans are tilted, by up to %.1f degrees: taken for level",
                      contents.tilt * 180 / M_PI));
  if (!usesScans) {
    source.slice = contents.arePlanar ? wholePlane() : findSlice(contents.voxels, options);
    refuseEmptySlice(*source.slice, in.file());
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
      if (source.takesTilted ? tiltOf(read) > kMostTilt : !isHorizontal(read)) continue;
      const mrpt::obs::CObservation2DRangeScan scan = mrptScan(read);
      visit(entry, {entry.robot, scan, rangesId(scan)});
    }
  });
}

}  // namespace roomgraph
