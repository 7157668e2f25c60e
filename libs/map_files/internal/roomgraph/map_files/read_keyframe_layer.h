#pragma once
#include <mrpt/math/TPoint3D.h>

#include <vector>

#include "roomgraph/base/byte_reader.h"

namespace roomgraph {

/** Reads the body of a layer of MOLA's KeyframePointCloudMap: the clouds of all key frames, in the
 *  frame of the map. Each may be followed by what is not known here. Needs MRPT's poses. */
std::vector<mrpt::math::TPoint3Df> readKeyframeLayer(ByteReader& in);

}  // namespace roomgraph
