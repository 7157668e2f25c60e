#include "roomgraph/scans/mrpt_object.h"

#include <gtest/gtest.h>
#include <mrpt/math/CMatrixF.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPose3DPDFGaussianInf.h>
#include <mrpt/poses/CPose3DPDFParticles.h>
#include <mrpt/poses/CPose3DPDFSOG.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussianInf.h>
#include <mrpt/poses/CPosePDFParticles.h>

#include <limits>

#include "map_files.h"
#include "occurrences.h"
#include "refusal.h"

namespace roomgraph {
namespace {

using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;
using test::raw;

/** Reads all of the bytes, and nothing behind them. */
template <class Result>
Result read(const std::string& bytes, Result (*reader)(ByteReader&)) {
  const std::string more = bytes + "behind";
  ByteReader in({reinterpret_cast<const std::uint8_t*>(more.data()), more.size()}, "a.map");
  const Result result = reader(in);
  EXPECT_EQ(in.left(), 6u);
  return result;
}

template <class Result>
std::string refusal(const std::string& bytes, Result (*reader)(ByteReader&)) {
  ByteReader in({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, "a.map");
  return test::refusalOf([&] { reader(in); });
}

/** An object as an MRPT of before wrote it. */
std::string object(const std::string& name, int version, const std::string& content) {
  return char(0x80 + name.size()) + name + char(version) + content + char(kObjectEnd);
}

const CPose3D kTilted(1, -2, 0.5, 0.7, 0.1, -0.2);
const CPose2D kFlat(3, 4, -1.2);

void expectTilted(const CPose3D& pose, double within = 1e-6) {
  EXPECT_NEAR(pose.x(), 1, within);
  EXPECT_NEAR(pose.y(), -2, within);
  EXPECT_NEAR(pose.z(), 0.5, within);
  EXPECT_NEAR(pose.yaw(), 0.7, within);
  EXPECT_NEAR(pose.pitch(), 0.1, within);
  EXPECT_NEAR(pose.roll(), -0.2, within);
}

void expectFlat(const CPose3D& pose) {
  EXPECT_NEAR(pose.x(), 3, 1e-6);
  EXPECT_NEAR(pose.y(), 4, 1e-6);
  EXPECT_NEAR(pose.yaw(), -1.2, 1e-6);
  EXPECT_NEAR(pose.z(), 0, 1e-6);
}

std::string numbers(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) bytes += raw(value);
  return bytes;
}

TEST(MrptObject, posesOfEveryVersionAreRead) {
  expectTilted(read(test::streamed(kTilted), readPose3D));
  const auto m = kTilted.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>();
  std::string matrix = raw(std::uint32_t(4)) + raw(std::uint32_t(4)), rotation;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) matrix += raw(float(m(r, c)));
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) rotation += raw(m(r, c));
  for (const int version : {0, 1})
    expectTilted(read(object("CPose3D", version, object("CMatrixF", 0, matrix)), readPose3D));
  mrpt::math::CQuaternionDouble q;
  kTilted.getAsQuaternion(q);
  const std::string place = numbers({1, -2, 0.5});
  expectTilted(
      read(object("CPose3D", 2, place + numbers({q.r(), q.x(), q.y(), q.z()})), readPose3D));
  expectTilted(read(object("CPose3D", 3, place + rotation), readPose3D));
}

TEST(MrptObject, flatPosesHaveNumbersOfEitherSize) {
  EXPECT_EQ(read(test::streamed(kFlat), readPose2D).phi(), -1.2);
  const std::string floats = raw(3.0f) + raw(4.0f) + raw(-1.2f);
  EXPECT_EQ(read(object("CPose2D", 0, floats), readPose2D).y(), 4);
}

TEST(MrptObject, ofDistributionsTheMeanIsRead) {
  mrpt::poses::CPose3DPDFGaussian gaussian(kTilted);
  expectTilted(read(test::streamed(gaussian), readPoseMean));
  mrpt::poses::CPose3DPDFGaussianInf inverse(kTilted);
  expectTilted(read(test::streamed(inverse), readPoseMean));
  mrpt::poses::CPosePDFGaussian flat(kFlat);
  expectFlat(read(test::streamed(flat), readPoseMean));
  mrpt::poses::CPosePDFGaussianInf flatInverse(kFlat);
  expectFlat(read(test::streamed(flatInverse), readPoseMean));
}

TEST(MrptObject, particlesCountByTheirWeight) {
  mrpt::poses::CPosePDFParticles flat(2);
  flat.m_particles[0].d = mrpt::math::TPose2D(3, 4, -1.2), flat.m_particles[0].log_w = 0;
  flat.m_particles[1].d = mrpt::math::TPose2D(90, 90, 2), flat.m_particles[1].log_w = -60;
  expectFlat(read(test::streamed(flat), readPoseMean));
  mrpt::poses::CPose3DPDFParticles tilted(2);
  tilted.m_particles[0].d = kTilted.asTPose(), tilted.m_particles[0].log_w = 0;
  tilted.m_particles[1].d = mrpt::math::TPose3D(90, 90, 9, 1, 1, 1);
  tilted.m_particles[1].log_w = -60;
  expectTilted(read(test::streamed(tilted), readPoseMean), 1e-5);
}

TEST(MrptObject, anAbsurdNumberOfParticlesIsRefused) {
  for (const std::uint32_t count : {0u, 5u, 0xffffffffu})
    EXPECT_TRUE(test::has(
        refusal(object("CPosePDFParticles", 1, raw(count) + numbers({0, 1, 2, 3})), readPoseMean),
        "absurd number of particles"))
        << count;
}

TEST(MrptObject, otherClassesAreNamed) {
  EXPECT_TRUE(test::has(refusal(test::streamed(mrpt::poses::CPose3DPDFSOG(1)), readPoseMean),
                        "keeps a pose as CPose3DPDFSOG"));
  EXPECT_TRUE(test::has(refusal(test::streamed(kFlat), readPose3D), "a pose is missing"));
  EXPECT_TRUE(test::has(refusal(test::streamed(kTilted), readPose2D), "a pose is missing"));
}

TEST(MrptObject, whatIsNoRotationIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string upright = numbers({1, 0, 0, 0, 1, 0, 0, 0, 1});
  EXPECT_EQ(refusal(object("CPose3D", 3, numbers({0, 0, 0}) + upright), readPose3D), "");
  for (const std::string& bad : {numbers({0, 0, 0}) + numbers({2, 0, 0, 0, 1, 0, 0, 0, 1}),
                                 numbers({0, 0, 0}) + numbers({nan, 0, 0, 0, 1, 0, 0, 0, 1}),
                                 numbers({0, nan, 0}) + upright})
    EXPECT_TRUE(
        test::has(refusal(object("CPose3D", 3, bad), readPose3D), "a pose in it is not valid"));
  EXPECT_TRUE(test::has(
      refusal(test::streamed(mrpt::poses::CPosePDFGaussian(CPose2D(nan, 0, 0))), readPoseMean),
      "a pose in it is not valid"));
}

TEST(MrptObject, aMatrixIsSteppedOverUnlessItsSizeIsAbsurd) {
  const auto matrix = [](std::uint32_t rows, std::uint32_t columns) {
    return object("CMatrixF", 0, raw(rows) + raw(columns) + std::string(rows * columns * 4, 'x'));
  };
  const std::string bytes = matrix(2, 3);
  ByteReader in({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, "a.map");
  readMatrix(in);
  EXPECT_EQ(in.left(), 0u);
  EXPECT_TRUE(test::has(refusal(matrix(101, 1), readMatrix), "absurd size"));
  EXPECT_TRUE(test::has(refusal(test::streamed(kFlat), readMatrix), "a matrix is missing"));
}

TEST(MrptObject, cutAnywhereItIsRefused) {
  const std::string whole = test::streamed(mrpt::poses::CPose3DPDFGaussian(kTilted));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal(whole.substr(0, size), readPoseMean), "") << size;
}

TEST(MrptObject, aTimeCountsFrom1601) {
  const mrpt::Clock::time_point time = mrpt::Clock::fromDouble(1.7e9);
  const std::string bytes = raw(std::int64_t(time.time_since_epoch().count()));
  EXPECT_EQ(read(bytes, readTime), time);
  EXPECT_EQ(read(raw(std::int64_t(0)), readTime), mrpt::Clock::time_point());
}

}  // namespace
}  // namespace roomgraph
