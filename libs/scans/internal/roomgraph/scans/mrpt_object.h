#pragma once
#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>

#include "roomgraph/scans/object_header.h"

namespace roomgraph {

/** Reads a time of MRPT's: 100 ns from 1601 on; 0, which is INVALID_TIMESTAMP, stands for none. */
mrpt::Clock::time_point readTime(ByteReader& reader);

/** Reads a mrpt::poses::CPose3D object. Every number is finite, the rotation is a rotation. */
mrpt::poses::CPose3D readPose3D(ByteReader& reader);
/** Reads a mrpt::poses::CPose2D object, of any numbers. */
mrpt::poses::CPose2D readPose2D(ByteReader& reader);
/** Reads an object of one of MRPT's Gaussian or particle pose classes, in 2D or 3D, and returns
 *  its mean. Throws DataError for another class. */
mrpt::poses::CPose3D readPoseMean(ByteReader& reader);
/** Numbers one after the other, where they are stored; those of a matrix by its rows. */
struct StoredNumbers {
  const std::uint8_t* first = nullptr;
  bool areDouble = true;

  double at(std::size_t index) const {
    return areDouble ? valueAt<double>(first, index) : double(valueAt<float>(first, index));
  }
};
struct StoredMatrix {
  std::uint32_t rows = 0, columns = 0;
  StoredNumbers numbers;
};

/** Reads a CMatrixF or CMatrixD object. */
StoredMatrix readMatrix(ByteReader& reader);

}  // namespace roomgraph
