#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/serialization/CSerializable.h>

#include <string>

namespace roomgraph::test {

/** The full name of a file of other projects beside the source tree; empty where it is not
 *  there. */
std::string sharedFile(const std::string& name);

bool isFile(const std::string& name);

std::string gzipped(const std::string& bytes);
/** One Zstandard frame, with checksum and size, or, as MRPT writes it, without. */
std::string zstd(const std::string& bytes, bool isSealed);
/** What MRPT writes for the object. */
std::string streamed(const mrpt::serialization::CSerializable& object);
/** A grey or grey-alpha (2 channels), RGB or RGBA png, 8 bits per channel, rows from the top. */
std::string png(int width, int height, int channels, const std::string& pixels);
/** A grey (1 channel) or RGB jpeg of good quality, rows from the top. */
std::string jpeg(int width, int height, int channels, const std::string& pixels);
/** The value as it stands in MRPT's streams. */
template <class T>
std::string raw(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/** 5 x 4 cells of 0.1 m with its lower left corner at (-0.2, 0.3), each cell different. */
mrpt::maps::COccupancyGridMap2D smallGrid();
/** Three poses in a square room of 4 m, each with a scan of 40 beams. */
mrpt::maps::CSimpleMap smallSimplemap();

}  // namespace roomgraph::test
