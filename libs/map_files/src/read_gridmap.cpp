#include <array>
#include <cmath>

#include "readers.h"
// It does not include what it uses, and stands behind what does.
#include <mrpt/maps/CLogOddsGridMapLUT.h>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/scans/object_header.h"

namespace roomgraph {
namespace {

struct GridHeader {
  ObjectHeader object;
  std::uint8_t bitsPerCell = 8;
  std::uint32_t width = 0, height = 0;
  float xMin = 0, xMax = 0, yMin = 0, yMax = 0, resolution = 0;

  std::uint64_t cellBytes() const { return std::uint64_t(width) * height * (bitsPerCell / 8); }
};

/** MRPT's own table of probabilities; that of COccupancyGridMap2D would need its library. */
mrpt::maps::CLogOddsGridMapLUT<std::int8_t>& logOddsTable() {
  static mrpt::maps::CLogOddsGridMapLUT<std::int8_t> table;
  return table;
}

/** MRPT trusts the bounds and ignores the sizes; they must agree but for rounding. */
bool agrees(std::uint32_t cells, float low, float high, float resolution) {
  if (!(std::abs(low) <= 1e7f) || !(std::abs(high) <= 1e7f)) return false;
  const double rounding = 1.2e-7 * (std::abs(double(low)) + std::abs(double(high))) / resolution;
  return std::abs((double(high) - low) / resolution - cells) <= 1 + rounding;
}

void check(const GridHeader& header, const std::string& file) {
  if (!(header.resolution >= 1e-4f && header.resolution <= 1e3f))
    refuse(file, "its resolution is not between 0.1 mm and 1 km", "save the map again");
  if (header.width == 0 || header.height == 0) refuse(file, "has no cells", "save the map again");
  if (header.bitsPerCell != 8 && header.bitsPerCell != 16)
    refuse(file, "it is damaged: its cells have neither 8 nor 16 bits", kSaveMapAgain);
  if (std::uint64_t(header.width) * header.height > kMostCells)
    refuse(file,
           "claims " + std::to_string(header.width) + " x " + std::to_string(header.height) +
               " cells, more than 400 million",
           "crop it or save it with a coarser resolution");
  if (!agrees(header.width, header.xMin, header.xMax, header.resolution) ||
      !agrees(header.height, header.yMin, header.yMax, header.resolution))
    refuse(file, "it is damaged: its size contradicts its bounds", kSaveMapAgain);
}

GridHeader readHeader(ByteReader& reader) {
  GridHeader header;
  header.object = readObjectHeader(reader);
  checkVersion(reader, header.object, 7);  // which has the layout of 6, in 8 bits only
  if (header.object.version >= 2) header.bitsPerCell = reader.get<std::uint8_t>();
  header.width = reader.get<std::uint32_t>();
  header.height = reader.get<std::uint32_t>();
  for (float* value : {&header.xMin, &header.xMax, &header.yMin, &header.yMax, &header.resolution})
    *value = reader.get<float>();
  check(header, reader.file());
  return header;
}

/** Steps over the options behind the cells, each field with the size that MRPT writes. */
void skipOptions(ByteReader& reader, int version) {
  if (version >= 1) {
    reader.skip(4 + 1 + 4 + 4 + 1 + 2 + 4);  // insertion: altitude to horizontal tolerance
    reader.skip(4 + 4 * 4 + 4 + 4 + 1);      // likelihood: the method and the likelihood field
    reader.skip(4 + 4 + 4);                  // mean information
    reader.skip(1 + 4 + 4);                  // ray tracing
    reader.skip(4 + 4);                      // consensus
    reader.skip(std::uint64_t(reader.get<std::uint32_t>()) * 4);  // its weights
    reader.skip(1);                                               // likelihood cache
    if (version >= 6) {
      const ObjectHeader params = readObjectHeader(reader);
      checkVersion(reader, params, 0);
      reader.skip(3);
      readObjectEnd(reader, params);
    } else {
      reader.skip(1);
    }
  }
  if (version >= 4) reader.skip(4 + 4);  // feature detection
  if (version >= 5) reader.skip(1);      // widening beams
}

/** Grey level by stored byte. Before version 3 the cells were probabilities, not log-odds. */
std::array<std::uint8_t, 256> greyTable(int version) {
  std::array<std::uint8_t, 256> table;
  for (int byte = 0; byte < 256; ++byte) {
    const auto probability = float(byte * (1.0 / 0xFF));
    const int cell = version < 3 ? int(logOddsTable().p2l(probability)) : int(std::int8_t(byte));
    table[std::size_t(byte)] = greyOfLogOdds(cell);
  }
  return table;
}

}  // namespace

std::uint8_t greyOfLogOdds(int cell) {
  const float probability = logOddsTable().l2p(static_cast<std::int8_t>(cell));
  return static_cast<std::uint8_t>(std::lround(255 * probability));
}

bool isGridmap(CheckedFile& file) {
  const auto object = peekObjectHeader(file.head());
  return object && object->className == "COccupancyGridMap2D";
}

GreyMap readGridmapObject(ByteReader& reader) {
  const GridHeader header = readHeader(reader);
  const std::uint8_t* cells = reader.take(header.cellBytes());
  skipOptions(reader, header.object.version);
  readObjectEnd(reader, header.object);

  GreyMap map;
  map.frame.width = int(header.width);
  map.frame.height = int(header.height);
  map.frame.resolution = decimal(header.resolution);
  map.frame.origin = {decimal(header.xMin), decimal(header.yMin)};
  map.grey.resize(map.frame.cellCount());
  const auto table = greyTable(header.object.version);
  // Of 16 bits MRPT keeps the upper 8; the stream is little-endian.
  const std::size_t stride = header.bitsPerCell / 8u;
  for (std::size_t i = 0; i < map.grey.size(); ++i)
    map.grey[i] = table[cells[i * stride + stride - 1]];
  map.occupiedAbove = 0.55;
  map.freeBelow = 0.45;
  return map;
}

GreyMap readGridmap(CheckedFile& file, const LoadGridOptions&) {
  // The first bytes tell an absurd map before its cells cost memory.
  ByteReader head(file.head(), file.name());
  const GridHeader header = readHeader(head);
  constexpr std::uint64_t roomForOptions = 1 << 20;
  const std::uint64_t atLeast = head.position() + header.cellBytes();
  if (file.claimedSize() < atLeast)
    refuse(file.name(), "it is cut short or damaged: it holds fewer cells than it says",
           kSaveMapAgain);
  if (file.claimedSize() > atLeast + roomForOptions)
    refuse(file.name(), "it is damaged, or something follows the map in it", kSaveMapAgain);

  ByteReader reader(file.content(), file.name());
  GreyMap map = readGridmapObject(reader);
  if (reader.left() > 0)
    refuse(file.name(), "something follows the map in it", "remove what was appended");
  return map;
}

}  // namespace roomgraph
