#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPose3DPDFGaussianInf.h>
#include <mrpt/poses/CPose3DPDFParticles.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussianInf.h>
#include <mrpt/poses/CPosePDFParticles.h>
#include <mrpt/serialization/CArchive.h>

#include "map_files.h"
#include "newer_simplemap.h"
#include "recording_in.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/scans/rewrite_simplemap.h"

namespace roomgraph {
namespace {

using test::recordingIn;

using mrpt::poses::CPose3D;

const Transform2D kMotion{1.5, -2, 0.7};
const CPose3D kPose(3, 4, 0.5, 0.3, 0.1, -0.2);
constexpr PlanarCovariance kSure{0.04, 0.09, 0.01, 0.005, 0.001, -0.002};

ByteView viewOf(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

/** The object of the only pose of a map after its move. */
std::string movedObject(const std::string& object, const PoseMove& move) {
  const std::string bytes = test::simplemapBytes(1, {object + test::frameBytes({})});
  const Recording recording = recordingIn(bytes);
  const std::string moved = movePoses(viewOf(bytes), recording, {move});
  EXPECT_EQ(moved.size(), bytes.size());
  return moved.substr(recording.frames[0].begin, object.size());
}

template <class Pdf>
Pdf movedPdf(const Pdf& pdf, const PoseMove& move) {
  const std::string bytes = movedObject(test::streamed(pdf), move);
  mrpt::io::CMemoryStream stream;
  stream.Write(bytes.data(), bytes.size());
  stream.Seek(0);
  Pdf read;
  mrpt::serialization::archiveFrom(stream) >> read;
  return read;
}

void expectMoved(const CPose3D& pose, const CPose3D& was) {
  const CPose3D expected = CPose3D(kMotion.x, kMotion.y, 0, kMotion.phi, 0, 0) + was;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(pose.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>()(r, c),
                  expected.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>()(r, c), 1e-6);
}

template <class Matrix>
void expectBlock(const Matrix& m, int yaw) {
  EXPECT_NEAR(m(0, 0), kSure.xx, 1e-9);
  EXPECT_NEAR(m(1, 1), kSure.yy, 1e-9);
  EXPECT_NEAR(m(yaw, yaw), kSure.pp, 1e-9);
  EXPECT_NEAR(m(0, 1), kSure.xy, 1e-9);
  EXPECT_NEAR(m(0, yaw), kSure.xp, 1e-9);
  EXPECT_NEAR(m(yaw, 1), kSure.yp, 1e-9);
}

/** Whether the information of x, y and yaw is the inverse of the covariance. MRPT 2.5 reads only
 *  what is above the diagonal back. */
template <class Matrix>
void expectInverse(const Matrix& information, int yaw) {
  const int at[] = {0, 1, yaw};
  const double covariance[3][3] = {{kSure.xx, kSure.xy, kSure.xp},
                                   {kSure.xy, kSure.yy, kSure.yp},
                                   {kSure.xp, kSure.yp, kSure.pp}};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      double product = 0;
      for (int j = 0; j < 3; ++j)
        product += information(at[std::min(i, j)], at[std::max(i, j)]) * covariance[j][k];
      EXPECT_NEAR(product, i == k, 1e-9);
    }
}

TEST(MovePoses, gaussiansInSpaceAreMovedAndGetTheirCovariance) {
  mrpt::poses::CPose3DPDFGaussian pdf(kPose);
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) pdf.cov(i, k) = i == k ? 0.5 + i : 0.1;
  const auto moved = movedPdf(pdf, {kMotion, kSure});
  expectMoved(moved.mean, kPose);
  expectBlock(moved.cov, 3);
  EXPECT_EQ(moved.cov(2, 2), 2.5);
  EXPECT_EQ(moved.cov(2, 4), 0.1);
  EXPECT_EQ(moved.cov(0, 2), 0);
  EXPECT_EQ(moved.cov(3, 5), 0);
}

TEST(MovePoses, informationIsTheInverse) {
  mrpt::poses::CPose3DPDFGaussianInf inSpace(kPose);
  inSpace.cov_inv.setIdentity();
  mrpt::poses::CPosePDFGaussianInf inPlane(mrpt::poses::CPose2D(3, 4, 0.3));
  inPlane.cov_inv.setIdentity();
  const auto space = movedPdf(inSpace, {kMotion, kSure});
  const auto plane = movedPdf(inPlane, {kMotion, kSure});
  expectMoved(space.mean, kPose);
  expectMoved(CPose3D(plane.mean), CPose3D(3, 4, 0, 0.3, 0, 0));
  expectInverse(space.cov_inv, 3);
  expectInverse(plane.cov_inv, 2);
}

TEST(MovePoses, posesInThePlane) {
  mrpt::poses::CPosePDFGaussian pdf(mrpt::poses::CPose2D(3, 4, 0.3));
  const auto moved = movedPdf(pdf, {kMotion, kSure});
  expectMoved(CPose3D(moved.mean), CPose3D(3, 4, 0, 0.3, 0, 0));
  expectBlock(moved.cov, 2);
}

TEST(MovePoses, eachParticle) {
  mrpt::poses::CPose3DPDFParticles inSpace(2);
  inSpace.m_particles[0].d = kPose.asTPose();
  inSpace.m_particles[1].d = CPose3D(1, 1, 0, -3, 0, 0).asTPose();
  mrpt::poses::CPosePDFParticles inPlane(1);
  inPlane.m_particles[0].d = {3, 4, 0.3};
  const auto space = movedPdf(inSpace, {kMotion, kSure});
  expectMoved(CPose3D(space.m_particles[0].d), kPose);
  expectMoved(CPose3D(space.m_particles[1].d), CPose3D(1, 1, 0, -3, 0, 0));
  const auto plane = movedPdf(inPlane, {kMotion, kSure});
  expectMoved(CPose3D(plane.m_particles[0].d), CPose3D(3, 4, 0, 0.3, 0, 0));
}

/** A Gaussian around a pose whose layout is an older one. */
std::string olderGaussian(int version) {
  std::string pose = std::string(1, char(0x80 | 7)) + "CPose3D" + char(version);
  const auto m = kPose.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>();
  if (version == 2) {
    mrpt::math::CQuaternionDouble q;
    kPose.getAsQuaternion(q);
    for (const double value : {kPose.x(), kPose.y(), kPose.z(), q.r(), q.x(), q.y(), q.z()})
      pose += test::raw(value);
  } else {
    pose += std::string(1, char(0x80 | 8)) + (version == 0 ? "CMatrixF" : "CMatrixD") + '\0' +
            test::raw(std::uint32_t(4)) + test::raw(std::uint32_t(4));
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c)
        pose += version == 0 ? test::raw(float(m(r, c))) : test::raw(double(m(r, c)));
    pose += '\x88';
  }
  pose += '\x88';
  std::string pdf = std::string(1, char(0x80 | 18)) + "CPose3DPDFGaussian" + '\1' + pose;
  for (int i = 0; i < 21; ++i) pdf += test::raw(i < 6 ? 1.0 : 0.0);
  return pdf + '\x88';
}

TEST(MovePoses, olderLayoutsOfAPose) {
  for (const int version : {0, 1, 2}) {
    const std::string moved = movedObject(olderGaussian(version), {kMotion, {}});
    const auto recording = recordingIn(test::simplemapBytes(1, {moved + test::frameBytes({})}));
    expectMoved(recording.frames[0].robot, kPose);
  }
}

TEST(MovePoses, nothingElseChanges) {
  for (const int version : {0, 1, 2}) {
    const std::string bytes =
        test::asNewer(test::smallSimplemap(), {version, version == 2, 8, true, true});
    const Recording recording = recordingIn(bytes);
    ASSERT_EQ(recording.frames.size(), 6u);
    EXPECT_EQ(recording.version, version);
    std::vector<PoseMove> moves(6);
    EXPECT_EQ(movePoses(viewOf(bytes), recording, moves), bytes);
    moves[2] = {kMotion, kSure};
    const std::string moved = movePoses(viewOf(bytes), recording, moves);
    const std::size_t begin = recording.frames[2].begin;
    const std::size_t frame = bytes.find("CSensoryFrame", begin);
    EXPECT_EQ(moved.substr(0, begin), bytes.substr(0, begin));
    EXPECT_NE(moved.substr(begin, frame - begin), bytes.substr(begin, frame - begin));
    EXPECT_EQ(moved.substr(frame), bytes.substr(frame));
    EXPECT_EQ(recording.frames.back().end + 1, bytes.size());
  }
}

TEST(MovePoses, anotherFileIsRefused) {
  const std::string bytes = test::streamed(test::smallSimplemap());
  const Recording recording = recordingIn(bytes);
  EXPECT_THROW(movePoses(viewOf(bytes), recording, {}), DataError);
  EXPECT_THROW(movePoses(viewOf(bytes.substr(0, 900)), recording, std::vector<PoseMove>(3)),
               DataError);
  EXPECT_THROW(recordingIn(bytes.substr(0, 900)), DataError);
  EXPECT_THROW(recordingIn("no simplemap"), DataError);
}

}  // namespace
}  // namespace roomgraph
