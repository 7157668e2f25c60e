#include "roomgraph/scans/mrpt_object.h"

#include <mrpt/poses/CPose3DPDFParticles.h>
#include <mrpt/poses/CPose3DQuat.h>
#include <mrpt/poses/CPosePDFParticles.h>

#include <cmath>

#include "roomgraph/base/remedies.h"

namespace roomgraph {
namespace {

using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

struct Matrix {
  std::uint32_t rows = 0, columns = 0;
  bool isDouble = false;
  const std::uint8_t* data = nullptr;

  double at(std::size_t row, std::size_t column) const {
    const std::size_t index = row * columns + column;
    if (isDouble) return value<double>(index);
    return double(value<float>(index));
  }
  template <class T>
  T value(std::size_t index) const {
    T result;
    std::memcpy(&result, data + index * sizeof(T), sizeof(T));
    return result;
  }
};

Matrix readMatrix(ByteReader& in) {
  const ObjectHeader header = readObjectHeader(in);
  if (header.className.compare(0, 7, "CMatrix") != 0)
    refuse(in.file(), "it is damaged: a matrix is missing in it", kSaveMapAgain);
  checkVersion(in, header, 0);
  Matrix matrix;
  matrix.isDouble = header.className.back() == 'D';
  matrix.rows = in.get<std::uint32_t>();
  matrix.columns = in.get<std::uint32_t>();
  if (matrix.rows > 100 || matrix.columns > 100)
    refuse(in.file(), "it is damaged: a matrix in it has an absurd size", kSaveMapAgain);
  const std::size_t size = matrix.isDouble ? sizeof(double) : sizeof(float);
  matrix.data = in.take(std::uint64_t(matrix.rows) * matrix.columns * size);
  readObjectEnd(in, header);
  return matrix;
}

CPose3D poseOf(const mrpt::math::CMatrixDouble44& m, const ByteReader& in) {
  bool isRotation = true;
  for (int r = 0; r < 3; ++r) {
    double norm = 0;
    for (int c = 0; c < 3; ++c) norm += m(r, c) * m(r, c);
    // Written so that NaN is refused, too.
    isRotation = isRotation && std::abs(norm - 1) < 0.01 && std::isfinite(m(r, 3));
  }
  if (!isRotation) refuse(in.file(), "it is damaged: a pose in it is not valid", kSaveMapAgain);
  return CPose3D(m);
}

mrpt::math::CMatrixDouble44 readPoseMatrix(ByteReader& in, int version) {
  mrpt::math::CMatrixDouble44 m = mrpt::math::CMatrixDouble44::Identity();
  if (version <= 1) {
    const Matrix stored = readMatrix(in);
    if (stored.rows != 4 || stored.columns != 4)
      refuse(in.file(), "it is damaged: a pose in it is not valid", kSaveMapAgain);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) m(r, c) = stored.at(std::size_t(r), std::size_t(c));
    return m;
  }
  for (int r = 0; r < 3; ++r) m(r, 3) = in.get<double>();
  if (version >= 3) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) m(r, c) = in.get<double>();
    return m;
  }
  mrpt::math::CQuaternionDouble q;
  for (int i = 0; i < 4; ++i) q[i] = in.get<double>();
  mrpt::math::CMatrixDouble33 rotation;
  q.rotationMatrixNoResize(rotation);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) m(r, c) = rotation(r, c);
  return m;
}

CPose3D checkPose(const CPose2D& pose, const ByteReader& in) {
  if (!std::isfinite(pose.x()) || !std::isfinite(pose.y()) || !(std::abs(pose.phi()) < 1e3))
    refuse(in.file(), "it is damaged: a pose in it is not valid", kSaveMapAgain);
  return CPose3D(CPose2D(pose.x(), pose.y(), pose.phi()));
}

template <class T>
CPose2D readCoordinates(ByteReader& in) {
  CPose2D pose;
  pose.x(double(in.get<T>()));
  pose.y(double(in.get<T>()));
  pose.phi(double(in.get<T>()));
  return pose;
}

std::uint32_t readParticleCount(ByteReader& in) {
  const auto count = in.get<std::uint32_t>();
  constexpr std::uint64_t smallestParticle = 8 + 3 * 4;
  if (count == 0 || count > in.left() / smallestParticle)
    refuse(in.file(), "it is damaged: a pose in it has an absurd number of particles",
           kSaveMapAgain);
  return count;
}

CPose3D readParticles3D(ByteReader& in, int version) {
  mrpt::poses::CPose3DPDFParticles pdf(0);
  for (std::uint32_t n = readParticleCount(in); n > 0; --n) {
    const double logWeight = in.get<double>();
    mrpt::math::TPose3D pose;
    if (version == 0)
      pose = readPose3D(in).asTPose();
    else
      for (std::size_t i = 0; i < 6; ++i) pose[i] = in.get<double>();
    pdf.m_particles.emplace_back(pose, logWeight);
  }
  CPose3D mean;
  pdf.getMean(mean);
  return poseOf(mean.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>(), in);
}

CPose3D readParticles2D(ByteReader& in, int version) {
  mrpt::poses::CPosePDFParticles pdf(0);
  for (std::uint32_t n = readParticleCount(in); n > 0; --n) {
    const double logWeight = in.get<double>();
    mrpt::math::TPose2D pose;
    if (version == 0)
      pose = readPose2D(in).asTPose();
    else
      for (std::size_t i = 0; i < 3; ++i) pose[i] = in.get<double>();
    pdf.m_particles.emplace_back(pose, logWeight);
  }
  CPose2D mean;
  pdf.getMean(mean);
  return checkPose(mean, in);
}

CPose3D readGaussian3D(ByteReader& in) {
  CPose3D mean = readPose3D(in);
  in.skip(21 * sizeof(double));  // the upper triangle of 6 x 6
  return mean;
}

CPose3D readGaussian2D(ByteReader& in, int version) {
  CPose3D mean = checkPose(readPose2D(in), in);
  if (version == 0)
    skipMatrix(in);
  else
    in.skip(6 * (version == 1 ? sizeof(float) : sizeof(double)));
  return mean;
}

CPose3D readInformation2D(ByteReader& in) {
  CPose3D mean = checkPose(readCoordinates<double>(in), in);
  in.skip(6 * sizeof(double));
  return mean;
}

}  // namespace

mrpt::Clock::time_point readTime(ByteReader& in) {
  return mrpt::Clock::time_point(mrpt::Clock::duration(in.get<std::int64_t>()));
}

CPose3D readPose3D(ByteReader& in) {
  const ObjectHeader header = readObjectHeader(in);
  if (header.className != "CPose3D")
    refuse(in.file(), "it is damaged: a pose is missing in it", kSaveMapAgain);
  checkVersion(in, header, 3);
  const auto matrix = readPoseMatrix(in, header.version);
  readObjectEnd(in, header);
  return poseOf(matrix, in);
}

CPose2D readPose2D(ByteReader& in) {
  const ObjectHeader header = readObjectHeader(in);
  if (header.className != "CPose2D")
    refuse(in.file(), "it is damaged: a pose is missing in it", kSaveMapAgain);
  checkVersion(in, header, 1);
  CPose2D pose = header.version == 0 ? readCoordinates<float>(in) : readCoordinates<double>(in);
  readObjectEnd(in, header);
  return pose;
}

CPose3D readPoseMean(ByteReader& in) {
  const ObjectHeader header = readObjectHeader(in);
  CPose3D mean;
  if (header.className == "CPose3DPDFGaussian") {
    checkVersion(in, header, 1);
    mean = readGaussian3D(in);
  } else if (header.className == "CPose3DPDFGaussianInf") {
    checkVersion(in, header, 0);
    mean = readGaussian3D(in);
  } else if (header.className == "CPosePDFGaussian") {
    checkVersion(in, header, 2);
    mean = readGaussian2D(in, header.version);
  } else if (header.className == "CPosePDFGaussianInf") {
    checkVersion(in, header, 0);
    mean = readInformation2D(in);
  } else if (header.className == "CPose3DPDFParticles") {
    checkVersion(in, header, 1);
    mean = readParticles3D(in, header.version);
  } else if (header.className == "CPosePDFParticles") {
    checkVersion(in, header, 1);
    mean = readParticles2D(in, header.version);
  } else {
    refuse(in.file(), "keeps a pose as " + header.className,
           "save the map with Gaussian or particle poses");
  }
  readObjectEnd(in, header);
  return mean;
}

void skipMatrix(ByteReader& in) { readMatrix(in); }

}  // namespace roomgraph
