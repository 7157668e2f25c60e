#include "read_layer_points.h"

#include <algorithm>
#include <optional>

#include "roomgraph/base/remedies.h"
#include "roomgraph/scans/mrpt_object.h"
#include "roomgraph/scans/read_points.h"

namespace roomgraph {
namespace {

using mrpt::math::TPoint3Df;

constexpr char kKeyframes[] = "KeyframePointCloudMap", kIncremental[] = "IncrementalPointCloud";
constexpr std::uint64_t kBeforePose = 8 + 8;  // number and time of a key frame

/** Steps to the next pose that is announced within so many bytes. Returns how far that was. */
std::optional<std::uint64_t> seekPose(ByteReader& reader, std::uint64_t most) {
  constexpr std::size_t header = 32;
  for (std::uint64_t step = 0; step <= most && reader.left() > 0; ++step, reader.skip(1)) {
    const auto object = peekObjectHeader({reader.peek(), std::min(reader.left(), header)});
    if (object && !object->isOldFormat && object->className == "CPose3D") return step;
  }
  return std::nullopt;
}

/** The number of key frames, which stands behind options whose layout is not known here. Without
 *  any, what is taken for the first may be a pose behind the layer. */
std::uint32_t readKeyframeCount(ByteReader& reader) {
  ByteReader ahead = reader;
  const auto distance = seekPose(ahead, 4096);
  if (!distance || *distance < kBeforePose + 4) return 0;
  reader.skip(*distance - kBeforePose - 4);
  const auto count = reader.get<std::uint32_t>();
  return count > reader.left() / 100 ? 0 : count;
}

void addPoints(ByteReader& reader, const mrpt::poses::CPose3D& pose, CloudPoints& points) {
  if (!isPointsMapClass(readObjectHeader(reader).className))
    refuse(reader.file(), "it is damaged: a key frame in it has no points", kSaveMapAgain);
  for (const TPoint3Df& local : readPoints(reader)) {
    const auto p = pose.composePoint(mrpt::math::TPoint3D(local));
    points.emplace_back(float(p.x), float(p.y), float(p.z));
  }
}

/** Reads the body of a layer of MOLA's KeyframePointCloudMap: the clouds of all key frames. Each
 *  may be followed by what is not known here. */
CloudPoints readKeyframeLayer(ByteReader& reader) {
  CloudPoints points;
  for (std::uint32_t n = readKeyframeCount(reader); n > 0; --n) {
    if (!seekPose(reader, reader.left()))
      refuse(reader.file(), "it is cut short or damaged", kSaveMapAgain);
    const auto pose = readPose3D(reader);
    if (reader.getFlag()) addPoints(reader, pose, points);
  }
  return points;
}

}  // namespace

bool hasLayerPoints(const std::string& className) {
  return isPointsMapClass(className) || className == kKeyframes || className == kIncremental;
}

CloudPoints readLayerPoints(ByteReader& reader) {
  const std::string className = readObjectHeader(reader).className;
  if (className == kKeyframes) return readKeyframeLayer(reader);
  if (className == kIncremental)
    readObjectHeader(reader);  // it is kept as one of MRPT's point maps
  return readPoints(reader);
}

}  // namespace roomgraph
