#include "read_depth_scan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "point_bytes.h"
#include "roomgraph/base/remedies.h"
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
DepthCamera readCamera(ByteReader& in) {
  DepthCamera camera;
  in.skip(9 * sizeof(double));  // focal length in metres, distortion
  for (double* value : {&camera.fx, &camera.fy, &camera.cx, &camera.cy}) *value = in.get<double>();
  return camera;
}

void skipCameraEnd(ByteReader& in, const ObjectHeader& header) {
  in.skip(2 * sizeof(std::uint32_t));  // rows and columns
  if (header.version >= 5) readText(in);
  if (header.version >= 6) in.skip(1);  // the model of its distortion
  readObjectEnd(in, header);
}

/** The header of the camera, behind pictures whose layout is not known here. */
std::optional<ObjectHeader> findCamera(ByteReader& in) {
  for (; in.left() > 0; in.skip(1)) {
    const auto header = peekObjectHeader({in.peek(), std::min<std::size_t>(in.left(), 128)});
    if (header && !header->isOldFormat && header->className == "TCamera")
      return readObjectHeader(in);
  }
  return std::nullopt;
}

/** Reads what follows the camera of the depths, and returns whether these are distances along the
 *  camera's axis, and not from the camera. */
bool readRest(ByteReader& in, const ObjectHeader& camera, PointCloud& cloud) {
  const auto isKnown = [](const ObjectHeader& header) {
    return header.version >= kOldestCamera && header.version <= kNewestCamera;
  };
  if (!isKnown(camera)) return true;
  skipCameraEnd(in, camera);
  const ObjectHeader second = readObjectHeader(in);
  if (second.className != "TCamera" || !isKnown(second)) return true;
  readCamera(in);
  skipCameraEnd(in, second);
  readPose3D(in);
  in.skip(sizeof(float));  // standard deviation
  cloud.time = readTime(in);
  cloud.label = readText(in);
  for (int i = 0; i < 2; ++i) in.skip(1), readText(in);  // files beside the map
  return in.getFlag();
}

struct DepthImage {
  std::uint32_t rows = 0, columns = 0;
  const std::uint8_t* depths = nullptr;
  double unit = 0;
};

void readDepthImage(ByteReader& in, DepthImage& image) {
  image.rows = in.get<std::uint32_t>();
  image.columns = in.get<std::uint32_t>();
  if (image.rows > 20'000 || image.columns > 20'000)
    refuse(in.file(), "it is damaged: a depth image in it has an absurd size", kSaveMapAgain);
  image.depths = in.take(std::uint64_t(image.rows) * image.columns * 2);
}

/** MRPT's cameras look along x, with y to the left and z up. */
CloudPoints pointsOf(const DepthImage& image, const DepthCamera& camera, bool isDepth) {
  CloudPoints points;
  for (std::size_t i = 0; i < std::size_t(image.rows) * image.columns; ++i) {
    std::uint16_t stored;
    std::memcpy(&stored, image.depths + 2 * i, 2);
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

void readDepthScan(ByteReader& in, const ObjectHeader& header, PointCloud& cloud) {
  in.skip(4);  // longest range
  cloud.sensor = readPose3D(in);
  const bool hasPoints = header.version == 0 || in.getFlag();
  const std::uint64_t count = hasPoints ? ByteReader(in).get<std::uint32_t>() : 0;
  if (hasPoints) cloud.points = skipPoints(in);
  // The rest is laid out in another way before MRPT 2.1, where depths are a matrix of metres.
  if (header.version < 9) return;
  in.skip(count * 2 * sizeof(std::uint16_t));  // the pixels of the points
  DepthImage image;
  const bool hasImage = in.getFlag();
  image.unit = double(in.get<float>());
  if (hasImage) readDepthImage(in, image);
  const auto found = findCamera(in);
  if (!found || found->version < kOldestCamera) return;
  const DepthCamera camera = readCamera(in);
  const bool isDepth = readRest(in, *found, cloud);
  if (!hasPoints && camera.fx > 0 && camera.fy > 0)
    cloud.points = [=] { return pointsOf(image, camera, isDepth); };
}

}  // namespace roomgraph
