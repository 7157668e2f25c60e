#include "read_layer_points.h"

#include "roomgraph/map_files/read_keyframe_layer.h"
#include "roomgraph/scans/mrpt_object.h"
#include "roomgraph/scans/read_points.h"

namespace roomgraph {
namespace {

using mrpt::math::TPoint3Df;

constexpr char kKeyframes[] = "KeyframePointCloudMap", kIncremental[] = "IncrementalPointCloud";

}  // namespace

bool hasLayerPoints(const std::string& className) {
  return isPointsMapClass(className) || className == kKeyframes || className == kIncremental;
}

std::vector<TPoint3Df> readLayerPoints(ByteReader& in) {
  const std::string className = readObjectHeader(in).className;
  if (className == kKeyframes) return readKeyframeLayer(in);
  if (className == kIncremental) readObjectHeader(in);  // it is kept as one of MRPT's point maps
  return readPoints(in);
}

}  // namespace roomgraph
