#include "roomgraph/scans/mrpt_object.h"

#include <mrpt/poses/CPose3DPDFParticles.h>
#include <mrpt/poses/CPose3DQuat.h>
#include <mrpt/poses/CPosePDFParticles.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "roomgraph/base/checked_file.h"

namespace roomgraph {
namespace {

using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

CPose3D poseOf(const mrpt::math::CMatrixDouble44& m, const ByteReader& reader) {
  bool isRotation = true;
  for (int r = 0; r < 3; ++r) {
    double norm = 0;
    for (int c = 0; c < 3; ++c) norm += m(r, c) * m(r, c);
    // Written so that NaN is refused, too.
    isRotation = isRotation && std::abs(norm - 1) < 0.01 && std::isfinite(m(r, 3));
  }
  if (!isRotation) refuse(reader.file(), "it is damaged: a pose in it is not valid", kSaveMapAgain);
  return CPose3D(m);
}

mrpt::math::CMatrixDouble44 readPoseMatrix(ByteReader& reader, int version) {
  mrpt::math::CMatrixDouble44 m = mrpt::math::CMatrixDouble44::Identity();
  if (version <= 1) {
    const StoredMatrix stored = readMatrix(reader);
    if (stored.rows != 4 || stored.columns != 4)
      refuse(reader.file(), "it is damaged: a pose in it is not valid", kSaveMapAgain);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) m(r, c) = stored.numbers.at(4 * std::size_t(r) + std::size_t(c));
    return m;
  }
  for (int r = 0; r < 3; ++r) m(r, 3) = reader.get<double>();
  if (version >= 3) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) m(r, c) = reader.get<double>();
    return m;
  }
  mrpt::math::CQuaternionDouble q;
  for (int i = 0; i < 4; ++i) q[i] = reader.get<double>();
  mrpt::math::CMatrixDouble33 rotation;
  q.rotationMatrixNoResize(rotation);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) m(r, c) = rotation(r, c);
  return m;
}

CPose3D checkPose(const CPose2D& pose, const ByteReader& reader) {
  if (!std::isfinite(pose.x()) || !std::isfinite(pose.y()) || !(std::abs(pose.phi()) < 1e3))
    refuse(reader.file(), "it is damaged: a pose in it is not valid", kSaveMapAgain);
  return CPose3D(CPose2D(pose.x(), pose.y(), pose.phi()));
}

template <class T>
CPose2D readCoordinates(ByteReader& reader) {
  CPose2D pose;
  pose.x(double(reader.get<T>()));
  pose.y(double(reader.get<T>()));
  pose.phi(double(reader.get<T>()));
  return pose;
}

std::uint32_t readParticleCount(ByteReader& reader) {
  const auto count = reader.get<std::uint32_t>();
  constexpr std::uint64_t smallestParticle = 8 + 3 * 4;
  if (count == 0 || count > reader.left() / smallestParticle)
    refuse(reader.file(), "it is damaged: a pose in it has an absurd number of particles",
           kSaveMapAgain);
  return count;
}

/** The mean of poses with weights; `readPose` reads one of them as version 0 has it. */
template <class Particles, class Pose>
Pose readParticles(ByteReader& reader, int version, Pose (*readPose)(ByteReader&)) {
  Particles pdf(0);
  for (std::uint32_t n = readParticleCount(reader); n > 0; --n) {
    const double logWeight = reader.get<double>();
    decltype(Pose().asTPose()) pose;
    if (version == 0)
      pose = readPose(reader).asTPose();
    else
      for (std::size_t i = 0; i < pose.size(); ++i) pose[i] = reader.get<double>();
    pdf.m_particles.emplace_back(pose, logWeight);
  }
  Pose mean;
  pdf.getMean(mean);
  return mean;
}

CPose3D readParticles3D(ByteReader& reader, int version) {
  const auto mean = readParticles<mrpt::poses::CPose3DPDFParticles>(reader, version, readPose3D);
  return poseOf(mean.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>(), reader);
}

CPose3D readParticles2D(ByteReader& reader, int version) {
  return checkPose(readParticles<mrpt::poses::CPosePDFParticles>(reader, version, readPose2D),
                   reader);
}

CPose3D readGaussian3D(ByteReader& reader, int) {
  CPose3D mean = readPose3D(reader);
  reader.skip(21 * sizeof(double));  // the upper triangle of 6 x 6
  return mean;
}

CPose3D readGaussian2D(ByteReader& reader, int version) {
  CPose3D mean = checkPose(readPose2D(reader), reader);
  if (version == 0)
    readMatrix(reader);
  else
    reader.skip(6 * (version == 1 ? sizeof(float) : sizeof(double)));
  return mean;
}

CPose3D readInformation2D(ByteReader& reader, int) {
  CPose3D mean = checkPose(readCoordinates<double>(reader), reader);
  reader.skip(6 * sizeof(double));
  return mean;
}

/** A distribution of poses, by the newest version of its layout that is known. */
struct PoseKind {
  const char* className;
  int newest;
  CPose3D (*readMean)(ByteReader& reader, int version);
};

constexpr PoseKind kPoseKinds[] = {
    {"CPose3DPDFGaussian", 1, readGaussian3D},   {"CPose3DPDFGaussianInf", 0, readGaussian3D},
    {"CPosePDFGaussian", 2, readGaussian2D},     {"CPosePDFGaussianInf", 0, readInformation2D},
    {"CPose3DPDFParticles", 1, readParticles3D}, {"CPosePDFParticles", 1, readParticles2D}};

}  // namespace

mrpt::Clock::time_point readTime(ByteReader& reader) {
  return mrpt::Clock::time_point(mrpt::Clock::duration(reader.get<std::int64_t>()));
}

CPose3D readPose3D(ByteReader& reader) {
  const ObjectHeader header = readObjectHeader(reader);
  if (header.className != "CPose3D")
    refuse(reader.file(), "it is damaged: a pose is missing in it", kSaveMapAgain);
  checkVersion(reader, header, 3);
  const auto matrix = readPoseMatrix(reader, header.version);
  readObjectEnd(reader, header);
  return poseOf(matrix, reader);
}

CPose2D readPose2D(ByteReader& reader) {
  const ObjectHeader header = readObjectHeader(reader);
  if (header.className != "CPose2D")
    refuse(reader.file(), "it is damaged: a pose is missing in it", kSaveMapAgain);
  checkVersion(reader, header, 1);
  CPose2D pose =
      header.version == 0 ? readCoordinates<float>(reader) : readCoordinates<double>(reader);
  readObjectEnd(reader, header);
  return pose;
}

CPose3D readPoseMean(ByteReader& reader) {
  const ObjectHeader header = readObjectHeader(reader);
  const auto kind =
      std::find_if(std::begin(kPoseKinds), std::end(kPoseKinds),
                   [&](const PoseKind& known) { return header.className == known.className; });
  if (kind == std::end(kPoseKinds))
    refuse(reader.file(), "keeps a pose as " + header.className,
           "save the map with Gaussian or particle poses");
  checkVersion(reader, header, kind->newest);
  CPose3D mean = kind->readMean(reader, header.version);
  readObjectEnd(reader, header);
  return mean;
}

StoredMatrix readMatrix(ByteReader& reader) {
  const ObjectHeader header = readObjectHeader(reader);
  if (header.className.compare(0, 7, "CMatrix") != 0)
    refuse(reader.file(), "it is damaged: a matrix is missing in it", kSaveMapAgain);
  checkVersion(reader, header, 0);
  StoredMatrix matrix;
  matrix.numbers.areDouble = header.className.back() == 'D';
  matrix.rows = reader.get<std::uint32_t>();
  matrix.columns = reader.get<std::uint32_t>();
  if (matrix.rows > 100 || matrix.columns > 100)
    refuse(reader.file(), "it is damaged: a matrix in it has an absurd size", kSaveMapAgain);
  const std::size_t size = matrix.numbers.areDouble ? sizeof(double) : sizeof(float);
  matrix.numbers.first = reader.take(std::uint64_t(matrix.rows) * matrix.columns * size);
  readObjectEnd(reader, header);
  return matrix;
}

}  // namespace roomgraph
