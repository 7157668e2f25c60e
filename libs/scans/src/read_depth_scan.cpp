#include "read_depth_scan.h"

#include <algorithm>

#include "point_bytes.h"
#include "roomgraph/files/remedies.h"
#include "roomgraph/scans/read_points.h"

namespace roomgraph {
namespace {

using mrpt::math::TPoint3Df;

/** A pinhole camera that sees depths. */
struct DepthCamera {
  double fx = 0, fy = 0, cx = 0, cy = 0;
};

/** Finds the camera of a depth image, behind pictures whose layout is not known here. */
bool readCamera(ByteReader& in, DepthCamera& camera) {
  for (; in.left() > 0; in.skip(1)) {
    const auto header = peekObjectHeader({in.peek(), std::min<std::size_t>(in.left(), 128)});
    if (!header || header->isOldFormat || header->className != "TCamera") continue;
    if (readObjectHeader(in).version < 4) return false;  // from before MRPT 2.1
    break;
  }
  if (in.left() == 0) return false;
  in.skip(9 * sizeof(double));  // focal length in metres, distortion
  for (double* value : {&camera.fx, &camera.fy, &camera.cx, &camera.cy}) *value = in.get<double>();
  return camera.fx > 0 && camera.fy > 0;
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
std::vector<TPoint3Df> pointsOf(const DepthImage& image, const DepthCamera& camera) {
  std::vector<TPoint3Df> points;
  for (std::size_t i = 0; i < std::size_t(image.rows) * image.columns; ++i) {
    std::uint16_t stored;
    std::memcpy(&stored, image.depths + 2 * i, 2);
    if (stored == 0) continue;
    const double depth = stored * image.unit;
    const std::size_t column = i % image.columns, row = i / image.columns;
    const double right = (double(column) - camera.cx) / camera.fx;
    const double down = (double(row) - camera.cy) / camera.fy;
    const TPoint3Df p{float(depth), float(-depth * right), float(-depth * down)};
    if (isFinite(p)) points.push_back(p);
  }
  return points;
}

}  // namespace

void readDepthScan(ByteReader& in, const ObjectHeader& header, PointCloud& cloud) {
  in.skip(4);  // longest range
  cloud.sensor = readPose3D(in);
  if (header.version == 0 || in.getFlag()) {
    cloud.points = readPoints(in);
    return;
  }
  if (!in.getFlag()) return;
  DepthImage image;
  image.unit = header.version >= 9 ? double(in.get<float>()) : 1e-3;
  if (header.version < 9) return;  // a matrix of metres, from before MRPT 2.1
  readDepthImage(in, image);
  DepthCamera camera;
  if (readCamera(in, camera)) cloud.points = pointsOf(image, camera);
}

}  // namespace roomgraph
