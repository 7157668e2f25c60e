#include "roomgraph/scans/read_cloud.h"

#include <cmath>

#include "external_file.h"
#include "point_bytes.h"
#include "read_depth_scan.h"
#include "read_velodyne.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/scans/read_points.h"

namespace roomgraph {
namespace {

using mrpt::math::TPoint3Df;

/** The object that a CObservationPointCloud holds, or keeps in a file of its own. */
std::function<CloudPoints()> readPointsMap(ByteReader& reader) {
  const ObjectHeader header = readObjectHeader(reader);
  if (header.className == "nullptr") return PointCloud().points;
  if (!isPointsMapClass(header.className))
    refuse(reader.file(), "keeps a point cloud as " + header.className,
           "save it with one of MRPT's classes of points");
  return skipPoints(reader);
}

/** As MRPT numbers them, CObservationPointCloud::ExternalStorageFormat. */
enum Storage : std::uint8_t { kInside = 0, kObject = 1, kKitti = 2, kText = 3 };

CloudPoints readExternalPoints(const std::string& name, std::uint8_t storage) {
  CheckedFile file(name);
  ByteReader bytes(file.content(), name);
  if (storage == kObject) return readPointsMap(bytes)();
  return storage == kKitti ? kittiPoints(bytes) : textPoints(bytes);
}

void readPointCloud(ByteReader& reader, PointCloud& cloud) {
  cloud.label = reader.getText();
  cloud.time = readTime(reader);
  cloud.sensor = readPose3D(reader);
  const auto storage = reader.get<std::uint8_t>();
  if (storage == kInside) {
    cloud.points = readPointsMap(reader);
    return;
  }
  const std::string name = reader.getText();
  if (storage > kText)
    refuse(reader.file(), "keeps point clouds in files of a kind that is not known here",
           "save it with the clouds inside");
  const auto found = findExternalFile(reader.file(), name);
  if (!found) {
    cloud.missingFile = name;
    return;
  }
  cloud.otherFolder = found->otherFolder;
  cloud.points = [file = found->file, storage] { return readExternalPoints(file, storage); };
}

/** The layout of MRPT 2.11 on first tells where the matrices are kept; earlier ones begin with the
 *  size of the ranges. */
bool saysWhereMatricesAre(ByteReader reader, std::uint16_t rows, std::uint16_t columns) {
  const auto storedColumns = reader.get<std::uint16_t>(), storedRows = reader.get<std::uint16_t>();
  return storedColumns != columns || storedRows != rows;
}

/** Ranges of a scanner with one ring, which are in the sensor's plane. */
CloudPoints pointsOfRing(const std::uint8_t* ranges, std::size_t count, double unit, double start,
                         double span) {
  CloudPoints points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto stored = valueAt<std::uint16_t>(ranges, i);
    const double angle = start + span * double(i) / double(count);
    const TPoint3Df p{float(stored * unit * std::cos(angle)),
                      float(stored * unit * std::sin(angle)), 0.f};
    if (stored > 0 && isFinite(p)) points.push_back(p);
  }
  return points;
}

/** Points in rows and columns, in the frame of the robot; those at its origin are none. */
CloudPoints organizedPoints(const std::uint8_t* bytes, std::size_t count) {
  CloudPoints points = pointsInRow(bytes, count, 3);
  eraseIf(points, [](const TPoint3Df& p) { return p.x == 0 && p.y == 0 && p.z == 0; });
  return points;
}

std::function<CloudPoints()> readOrganizedPoints(ByteReader& reader) {
  const auto columns = reader.get<std::uint16_t>(), rows = reader.get<std::uint16_t>();
  const std::size_t count = std::size_t(columns) * rows;
  const std::uint8_t* bytes = reader.take(count * 3 * sizeof(float));
  return [=] { return organizedPoints(bytes, count); };
}

void readRotatingScan(ByteReader& reader, PointCloud& cloud) {
  cloud.time = readTime(reader);
  cloud.label = reader.getText();
  const auto rows = reader.get<std::uint16_t>(), columns = reader.get<std::uint16_t>();
  const auto unit = reader.get<double>(), start = reader.get<double>(), span = reader.get<double>();
  reader.skip(sizeof(double));      // how long it took
  reader.getText();                 // model
  reader.skip(2 * sizeof(double));  // shortest and longest range
  cloud.sensor = readPose3D(reader);
  readTime(reader);
  reader.skip(1);  // whose clock it was
  const bool isNewer = saysWhereMatricesAre(reader, rows, columns);
  if (isNewer && reader.getFlag()) {
    cloud.missingFile = reader.getText();  // a kind of file that no public program writes
    return;
  }
  const auto storedColumns = reader.get<std::uint16_t>(), storedRows = reader.get<std::uint16_t>();
  const std::uint8_t* ranges = reader.take(std::uint64_t(storedColumns) * storedRows * 2);
  if (storedRows == 1)
    cloud.points = [=] { return pointsOfRing(ranges, storedColumns, unit, start, span); };
  if (!isNewer || storedRows == 1) return;
  const auto width = reader.get<std::uint16_t>();
  reader.skip(std::uint64_t(width) * reader.get<std::uint16_t>());  // intensities
  for (auto layers = reader.get<std::uint16_t>(); layers > 0; --layers) {
    reader.getText();
    reader.skip(std::uint64_t(storedColumns) * storedRows * 2);
  }
  cloud.points = readOrganizedPoints(reader);
  cloud.sensor = {};
}

}  // namespace

bool isCloudClass(const std::string& className) {
  return className == "CObservationPointCloud" || className == "CObservation3DRangeScan" ||
         className == "CObservationVelodyneScan" || className == "CObservationRotatingScan";
}

PointCloud readCloud(ByteReader& reader, const ObjectHeader& header) {
  PointCloud cloud;
  if (header.className == "CObservation3DRangeScan") {
    checkVersion(reader, header, 10);
    readDepthScan(reader, header, cloud);
  } else if (header.className == "CObservationVelodyneScan") {
    checkVersion(reader, header, 2);
    readVelodyne(reader, cloud);
  } else if (header.className == "CObservationRotatingScan") {
    checkVersion(reader, header, 0);
    readRotatingScan(reader, cloud);
  } else {
    checkVersion(reader, header, 0);
    readPointCloud(reader, cloud);
  }
  return cloud;
}

}  // namespace roomgraph
