#pragma once
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>

#include <optional>
#include <string>

#include "roomgraph/files/byte_reader.h"

namespace roomgraph {

/** How MRPT's streams announce an object. */
struct ObjectHeader {
  std::string className;  ///< without its namespace
  int version = 0;
  /** Objects from before MRPT 0.5.5 have no mark at their end. */
  bool isOldFormat = false;
};

/** Whether a value that may be missing begins at `bytes`: MRPT writes "std::optional" before it. */
bool startsWithOptional(ByteView bytes);

/** The header at `bytes`, if it looks like one. Moves nothing. */
std::optional<ObjectHeader> peekObjectHeader(ByteView bytes);
/** Reads the header. Throws DataError where there is none. */
ObjectHeader readObjectHeader(ByteReader& in);
/** The mark at an object's end. */
constexpr std::uint8_t kObjectEnd = 0x88;
void readObjectEnd(ByteReader& in, const ObjectHeader& header);
/** Throws DataError unless the version is one of 0 to `newest`. */
void checkVersion(const ByteReader& in, const ObjectHeader& header, int newest);

/** Reads a mrpt::poses::CPose3D object. Every number is finite, the rotation is a rotation. */
mrpt::poses::CPose3D readPose3D(ByteReader& in);
/** Reads a mrpt::poses::CPose2D object, of any numbers. */
mrpt::poses::CPose2D readPose2D(ByteReader& in);
/** Reads an object of one of MRPT's Gaussian or particle pose classes, in 2D or 3D, and returns
 *  its mean. Throws DataError for another class. */
mrpt::poses::CPose3D readPoseMean(ByteReader& in);
/** Steps over a CMatrixF or CMatrixD object. */
void skipMatrix(ByteReader& in);

}  // namespace roomgraph
