#include "roomgraph/scans/place_scans.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "external_file.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/scans/find_slice.h"
#include "roomgraph/scans/read_cloud.h"

namespace roomgraph {
namespace {

/** What a simplemap holds, counted. */
struct Contents {
  std::size_t observations = 0, scans = 0, horizontal = 0, nearlyLevel = 0, clouds = 0, missing = 0;
  double tilt = 0;                           ///< the largest of the nearly level scans [rad]
  std::map<std::string, std::size_t> kinds;  ///< observations by class
  std::string missingFile;                   ///< the first one
  std::string otherFolder;                   ///< of another map's name that clouds are in
};

/** The clouds of a recording, decoded. */
struct Decoded {
  bool arePlanar = true;                         ///< all are what level 2D scanners see
  Voxels voxels;                                 ///< of all, by height above the robot
  std::vector<std::optional<CloudPoints>> kept;  ///< those that there was room for, by index
};

// Beyond this, beams that look down meet the floor within a room.
constexpr double kMostTilt = 3.01 * M_PI / 180;  // 3 degrees, and rounding

/** Between the sensor's plane and the robot's [rad]; a sensor that hangs upside down has none. */
double tiltOf(const RangeScan& scan) {
  return std::acos(std::min(1.0, std::abs(scan.sensor.getRotationMatrix()(2, 2))));
}

bool isHorizontal(const RangeScan& scan) {
  static const mrpt::maps::COccupancyGridMap2D::TInsertionOptions options;
  return scan.sensor.isHorizontal(double(options.horizontalTolerance));
}

/** The pose without its tilt. */
mrpt::poses::CPose3D level(const mrpt::poses::CPose3D& sensor) {
  const bool isUpsideDown = sensor.getRotationMatrix()(2, 2) < 0;
  return {sensor.x(), sensor.y(), sensor.z(), sensor.yaw(), 0, isUpsideDown ? M_PI : 0};
}

/** Whether a level scanner with one plane may have seen the points as the robot rocked a little. */
bool isPlanar(const CloudPoints& points, const mrpt::poses::CPose3D& sensor) {
  constexpr float thickest = 0.05f;      // [m]
  constexpr double mostUpright = 0.985;  // 10 degrees off
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  return low == points.end() || (high->z - low->z <= thickest &&
                                 std::abs(sensor.getRotationMatrix()(2, 2)) >= mostUpright);
}

void addPoints(const CloudPoints& points, const mrpt::poses::CPose3D& sensor, double ground,
               Decoded& decoded) {
  decoded.arePlanar = decoded.arePlanar && isPlanar(points, sensor);
  for (const auto& point : points) {
    const auto p = sensor.composePoint(mrpt::math::TPoint3D(point));
    decoded.voxels.add(p.x, p.y, p.z - ground);
  }
}

Decoded decode(const Recording& recording, std::uint64_t mostKept) {
  Decoded decoded;
  std::uint64_t bytes = 0;
  for (const Recording::Frame& frame : recording.frames)
    for (const PointCloud& cloud : frame.clouds) {
      CloudPoints points = cloud.points();
      addPoints(points, frame.robot + cloud.sensor, frame.robot.z(), decoded);
      bytes += points.size() * sizeof points[0];
      decoded.kept.emplace_back();
      if (bytes <= mostKept) decoded.kept.back() = std::move(points);
    }
  return decoded;
}

void addScan(const RangeScan& scan, Contents& contents) {
  ++contents.scans;
  contents.horizontal += isHorizontal(scan);
  const double tilt = tiltOf(scan);
  if (tilt > kMostTilt) return;
  ++contents.nearlyLevel;
  contents.tilt = std::max(contents.tilt, tilt);
}

Contents contentsOf(const Recording& recording) {
  Contents contents;
  for (const auto& [sensor, count] : recording.sensors) {
    contents.kinds[sensor.className] += count;
    if (sensor.className != "CObservationComment") contents.observations += count;  // no sensor
  }
  for (const Recording::Frame& frame : recording.frames) {
    for (const RangeScan& scan : frame.scans) addScan(scan, contents);
    contents.clouds += frame.clouds.size();
    for (const PointCloud& cloud : frame.clouds) {
      if (!cloud.missingFile.empty() && contents.missing++ == 0)
        contents.missingFile = cloud.missingFile;
      if (!cloud.otherFolder.empty()) contents.otherFolder = cloud.otherFolder;
    }
  }
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

void addNote(PlacedScans& placed, const char* code, const std::string& text) {
  placed.notes.push_back({code, text});
}

PlacedScan& addPlaced(PlacedScans& placed, const Recording& recording, std::size_t keyFrame,
                      PlacedScan scan) {
  scan.keyFrame = keyFrame;
  scan.robot = recording.frames[keyFrame].robot;
  return placed.scans.emplace_back(std::move(scan));
}

/** Takes the scans that lie level, or nearly. */
void addScans(Recording& recording, bool takesTilted, PlacedScans& placed) {
  for (std::size_t k = 0; k < recording.frames.size(); ++k)
    for (RangeScan& scan : recording.frames[k].scans) {
      const bool isLevel = isHorizontal(scan);
      if (takesTilted ? tiltOf(scan) > kMostTilt : !isLevel) continue;
      PlacedScan& added = addPlaced(placed, recording, k, {});
      added.from = added.robot;
      added.scan = std::move(scan);
      if (!isLevel) added.scan.sensor = level(added.scan.sensor);
      added.id = rangesId(added.scan);
    }
}

void addSlices(const Recording& recording, Decoded decoded, const Slice& slice,
               PlacedScans& placed) {
  placed.areSlices = true;
  auto kept = decoded.kept.begin();
  for (std::size_t k = 0; k < recording.frames.size(); ++k) {
    const mrpt::poses::CPose3D& robot = recording.frames[k].robot;
    for (const PointCloud& cloud : recording.frames[k].clouds) {
      auto one = std::exchange(*kept++, std::nullopt);
      const CloudPoints points = one ? std::move(*one) : cloud.points();
      if (points.empty()) continue;
      PlacedScan& added = addPlaced(placed, recording, k,
                                    sliceScan(points, robot + cloud.sensor, robot.z(), slice));
      added.scan.time = cloud.time;
    }
  }
}

void cutClouds(const Recording& recording, Decoded decoded, const Contents& contents,
               const LoadGridOptions& options, PlacedScans& placed) {
  const Slice slice = decoded.arePlanar ? wholePlane() : findSlice(decoded.voxels, options);
  refuseEmptySlice(slice, recording.file);
  addNote(placed, "slice", "its point clouds are cut: " + sliceText(slice) + " (see --slice)");
  if (contents.missing > 0) addNote(placed, "missing_clouds", missingText(contents));
  if (!contents.otherFolder.empty())
    placed.notes.push_back({"other_folder",
                            "its point clouds are taken from " + contents.otherFolder +
                                ", the only folder of clouds without a map beside it",
                            {},
                            true});
  addSlices(recording, std::move(decoded), slice, placed);
}

}  // namespace

PlacedScans placeScans(Recording recording, const LoadGridOptions& options,
                       std::uint64_t mostKept) {
  const Contents contents = contentsOf(recording);
  PlacedScans placed;
  placed.file = recording.file;
  bool usesScans = contents.horizontal > 0 && options.sliceHigh <= 0;
  Decoded decoded;
  if (!usesScans) decoded = decode(recording, mostKept);
  const bool hasPoints = !decoded.voxels.empty();
  const bool takesTilted = contents.horizontal == 0 && contents.nearlyLevel > 0 && !hasPoints;
  usesScans = usesScans || takesTilted;
  if (!usesScans && !hasPoints) refuseEmpty(recording.file, contents);
  if (takesTilted)
    addNote(placed, "tilted_scans",
            formatted("its 2D range scans are tilted, by up to %.1f degrees: taken for level",
                      contents.tilt * 180 / M_PI));
  if (usesScans)
    addScans(recording, takesTilted, placed);
  else
    cutClouds(recording, std::move(decoded), contents, options, placed);
  const std::size_t used = usesScans ? contents.scans : contents.clouds;
  if (contents.observations > used)
    addNote(placed, "other_observations",
            std::to_string(contents.observations - used) + " observations that are no " +
                (usesScans ? "2D range scans" : "point clouds") + " are not used");
  return placed;
}

}  // namespace roomgraph
