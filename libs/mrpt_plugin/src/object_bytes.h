#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/mrpt_plugin/CMapComparison.h"
#include "roomgraph/mrpt_plugin/CRoomGraph.h"

namespace roomgraph {

/** An object as MRPT streams it, gzipped. No time stamp: the same object gives the same bytes. */
std::string gzippedObject(const mrpt::serialization::CSerializable& object);

/** The object as MRPT streams it. */
std::string objectBytes(const mrpt::serialization::CSerializable& object);

/** A class of this library. In a stream, an object is the size of its bytes and these bytes. */
struct ObjectKind {
  const char *className, *name;  ///< without its namespace; for people
  const char* remedy;            ///< for a file that holds something else
  std::uint8_t newest = 0;       ///< version of the layout that is known
};

void putBody(mrpt::serialization::CArchive& out, const std::string& bytes);

/** Calls `read` with the bytes of an object whose layout has this version. What the stream claims
 *  to hold is read piece by piece: a false claim costs no memory.
 *  @throws DataError with one line. */
void readBody(mrpt::serialization::CArchive& in, std::uint8_t version, const ObjectKind& kind,
              const std::function<void(ByteView)>& read);

/** Calls `read` with the bytes of the one object in a file, gzipped or not.
 *  @throws DataError with one line where the file holds another object, or more than that. */
void readObjectFile(const std::string& path, const ObjectKind& kind,
                    const std::function<void(ByteView)>& read);

constexpr ObjectKind kRoomGraphObject{"CRoomGraph", "room graph", "give a .roomgraph file", 1};

/** Throws UsageError where the map has more or fewer cells than its frame calls for. */
void checkMapSize(const MappedGraph& graph);

/** The graph as graphJson, then the cells of its map, which must be as many as its frame calls
 *  for. */
std::string graphBytes(const MappedGraph& graph);

/** Reads graphBytes() back. Throws DataError with one line, beginning with `name`, unless the
 *  JSON is whole, the cells fit the frame and no byte is left over. */
void readGraphBytes(ByteView bytes, const std::string& name, MappedGraph& graph);

constexpr ObjectKind kMapComparisonObject{"CMapComparison", "comparison of maps",
                                          "give a comparison.roomgraph", 0};

/** Everything that a MappedComparison holds: the comparison as JSON, then the walls of each run. */
std::string comparisonBytes(const MappedComparison& comparison);

/** Reads comparisonBytes() back. Throws DataError with one line, beginning with `name`, unless each
 *  count fits the bytes, each coordinate is finite and no byte is left over. */
void readComparisonBytes(ByteView bytes, const std::string& name, MappedComparison& comparison);

}  // namespace roomgraph
