#include "read_depth_scan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "point_bytes.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/scans/read_points.h"

namespace roomgraph {
namespace {

using mrpt::math::TPoint3Df;

/** A pinhole camera that sees depths. */
struct DepthCamera {
  double fx = 0, fy = 0, cx = 0, cy = 0;
};

constexpr int kOldestCamera = 4, kNewestCamera = 6;  // versions of TCamera whose end is known

/** Reads what follows the header of a TCamera. */
DepthCamera readCamera(ByteReader& reader) {
  DepthCamera camera;
  reader.skip(9 * sizeof(double));  // focal length in metres, distortion
  for (double* value : {&camera.fx, &camera.fy, &camera.cx, &camera.cy})
    *value = reader.get<double>();
  return camera;
}

void skipCameraEnd(ByteReader& reader, const ObjectHeader& header) {
  reader.skip(2 * sizeof(std::uint32_t));  // rows and columns
  if (header.version >= 5) reader.getText();
  if (header.version >= 6) reader.skip(1);  // the model of its distortion
  readObjectEnd(reader, header);
}

/** The header of the camera, behind pictures whose layout is not known here. */
std::optional<ObjectHeader> findCamera(ByteReader& reader) {
  for (; reader.left() > 0; reader.skip(1)) {
    const auto header =
        peekObjectHeader({reader.peek(), std::min<std::size_t>(reader.left(), 128)});
    if (header && !header->isOldFormat && header->className == "TCamera")
      return readObjectHeader(reader);
  }
  return std::nullopt;
}

/** Reads what follows the camera of the depths, and returns whether these are distances along the
 *  camera's axis, and not from the camera. */
bool readRest(ByteReader& reader, const ObjectHeader& camera, PointCloud& cloud) {
  const auto isKnown = [](const ObjectHeader& header) {
    return header.version >= kOldestCamera && header.version <= kNewestCamera;
  };
  if (!isKnown(camera)) return true;
  skipCameraEnd(reader, camera);
  const ObjectHeader second = readObjectHeader(reader);
  if (second.className != "TCamera" || !isKnown(second)) return true;
  readCamera(reader);
  skipCameraEnd(reader, second);
  readPose3D(reader);
  reader.skip(sizeof(float));  // standard deviation
  cloud.time = readTime(reader);
  cloud.label = reader.getText();
  for (int i = 0; i < 2; ++i) reader.skip(1), reader.getText();  // files beside the map
  return reader.getFlag();
}

struct DepthImage {
  std::uint32_t rows = 0, columns = 0;
  const std::uint8_t* depths = nullptr;
  double unit = 0;
};

void readDepthImage(ByteReader& reader, DepthImage& image) {
  image.rows = reader.get<std::uint32_t>();
  image.columns = reader.get<std::uint32_t>();
  if (image.rows > 20'000 || image.columns > 20'000)
    refuse(reader.file(), "it is damaged: a depth image in it has an absurd size", kSaveMapAgain);
  image.depths = reader.take(std::uint64_t(image.rows) * image.columns * 2);
}

/** MRPT's cameras look along x, with y to the left and z up. */
CloudPoints pointsOf(const DepthImage& image, const DepthCamera& camera, bool isDepth) {
  CloudPoints points;
  for (std::size_t i = 0; i < std::size_t(image.rows) * image.columns; ++i) {
    const auto stored = valueAt<std::uint16_t>(image.depths, i);
    if (stored == 0) continue;
    const std::size_t column = i % image.columns, row = i / image.columns;
    const double right = (double(column) - camera.cx) / camera.fx;
    const double down = (double(row) - camera.cy) / camera.fy;
    const double range = stored * image.unit;
    const double depth = isDepth ? range : range / std::hypot(1, right, down);
    const TPoint3Df p{float(depth), float(-depth * right), float(-depth * down)};
    if (isFinite(p)) points.push_back(p);
  }
  return points;
}

}  // namespace

void readDepthScan(ByteReader& reader, const ObjectHeader& header, PointCloud& cloud) {
  reader.skip(4);  // longest range
  cloud.sensor = readPose3D(reader);
  const bool hasPoints = header.version == 0 || reader.getFlag();
  const std::uint64_t count = hasPoints ? ByteReader(reader).get<std::uint32_t>() : 0;
  if (hasPoints) cloud.points = skipPoints(reader);
  // The rest is laid out in another way before MRPT 2.1, where depths are a matrix of metres.
  if (header.version < 9) return;
  reader.skip(count * 2 * sizeof(std::uint16_t));  // the pixels of the points
  DepthImage image;
  const bool hasImage = reader.getFlag();
  image.unit = double(reader.get<float>());
  if (hasImage) readDepthImage(reader, image);
  const auto found = findCamera(reader);
  if (!found || found->version < kOldestCamera) return;
  const DepthCamera camera = readCamera(reader);
  const bool isDepth = readRest(reader, *found, cloud);
  if (!hasPoints && camera.fx > 0 && camera.fy > 0)
    cloud.points = [=] { return pointsOf(image, camera, isDepth); };
}

}  // namespace roomgraph
