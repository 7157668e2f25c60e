#include <gtest/gtest.h>

#include <random>

#include "places.h"
#include "roomgraph/measures/match_elements.h"

namespace roomgraph {
namespace {

std::vector<std::pair<std::size_t, std::size_t>> numbers(const std::vector<MatchedVertices>& all) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const MatchedVertices& m : all) pairs.push_back({m.base.index(), m.other.index()});
  return pairs;
}

TEST(MatchVertices, usesEachVertexOnce) {
  const auto matched = matchVertices(places({{0, 0}, {1, 0}}), places({{0.4, 0}}), 1);
  ASSERT_EQ(matched.size(), 1u);
  EXPECT_EQ(matched[0].base, VertexId(0));
  EXPECT_DOUBLE_EQ(matched[0].distance, 0.4);
}

TEST(MatchVertices, takesTheNearestPairsFirst) {
  const auto base = places({{0, 0}, {1, 0}, {9, 9}});
  const auto other = places({{0.9, 0}, {-0.5, 0}, {20, 0}});
  const std::vector<std::pair<std::size_t, std::size_t>> expected{{1, 0}, {0, 1}};
  EXPECT_EQ(numbers(matchVertices(base, other, 1)), expected);
}

TEST(MatchVertices, goesNoFartherThanTold) {
  const auto base = places({{0, 0}}), other = places({{3, 4}});
  EXPECT_EQ(matchVertices(base, other, 5).size(), 1u);
  EXPECT_TRUE(matchVertices(base, other, 4.999).empty());
}

TEST(MatchVertices, equalDistancesGoByTheBaseVertexNumber) {
  const auto matched = matchVertices(places({{1, 0}, {-1, 0}}), places({{0, 0}}), 2);
  ASSERT_EQ(matched.size(), 1u);
  EXPECT_EQ(matched[0].base, VertexId(0));
}

TEST(MatchVertices, isTheSameFromBothSidesAndStable) {
  std::mt19937 random(3);
  const auto scattered = [&](int count) {
    std::vector<Vertex> vertices;
    for (int i = 0; i < count; ++i)
      vertices.push_back({{double(random() % 100000) * 1e-4, double(random() % 100000) * 1e-4},
                          0,
                          VertexKind::junction,
                          RoomId::none()});
    return TopologyGraph(vertices, {});
  };
  const TopologyGraph a = scattered(80), b = scattered(120);
  const auto there = matchVertices(a, b, 1);
  auto back = numbers(matchVertices(b, a, 1));
  for (auto& pair : back) std::swap(pair.first, pair.second);
  EXPECT_EQ(numbers(there), back);
  std::vector<double> apartA(80, 1e9), apartB(120, 1e9);
  for (const MatchedVertices& m : there)
    apartA[m.base.index()] = apartB[m.other.index()] = m.distance;
  for (std::size_t i = 0; i < 80; ++i)
    for (std::size_t j = 0; j < 120; ++j) {
      const double apart = distance(a.vertices()[i].place, b.vertices()[j].place);
      EXPECT_TRUE(apart > 1 || apart >= std::min(apartA[i], apartB[j])) << i << " " << j;
    }
}

TEST(VertexAgreement, readsPercentilesBetweenThePairs) {
  std::vector<MatchedVertices> pairs(11);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].distance = double(i * i);
  const VertexAgreement agreement = vertexAgreement(pairs, 22, 44);
  EXPECT_DOUBLE_EQ(agreement.median.value(), 25);
  EXPECT_DOUBLE_EQ(agreement.percentile90.value(), 81);
  EXPECT_DOUBLE_EQ(agreement.unmatchedBase.value(), 0.5);
  EXPECT_DOUBLE_EQ(agreement.unmatchedOther.value(), 0.75);
  pairs.resize(2);
  EXPECT_DOUBLE_EQ(vertexAgreement(pairs, 2, 2).median.value(), 0.5);
}

TEST(VertexAgreement, hasNoNumbersWhereThereIsNothing) {
  const VertexAgreement agreement = vertexAgreement({}, 3, 0);
  EXPECT_FALSE(agreement.median);
  EXPECT_FALSE(agreement.percentile90);
  EXPECT_DOUBLE_EQ(agreement.unmatchedBase.value(), 1);
  EXPECT_FALSE(agreement.unmatchedOther);
}

TEST(NearestVertices, isTheMeanDistanceOfTheBaseVertices) {
  const auto base = places({{0, 0}, {10, 0}});
  EXPECT_DOUBLE_EQ(nearestVertices(base, places({{3, 4}, {10, 1}})).value(), 3);
  EXPECT_DOUBLE_EQ(nearestVertices(base, base).value(), 0);
}

TEST(NearestVertices, isOneSidedAndLetsOneVertexServeMany) {
  const auto few = places({{0, 0}}), many = places({{0, 0}, {2, 0}, {4, 0}});
  EXPECT_DOUBLE_EQ(nearestVertices(few, many).value(), 0);
  EXPECT_DOUBLE_EQ(nearestVertices(many, few).value(), 2);
}

TEST(NearestVertices, hasNoMeaningForAnEmptyGraph) {
  EXPECT_FALSE(nearestVertices(places({}), places({{0, 0}})));
  EXPECT_FALSE(nearestVertices(places({{0, 0}}), places({})));
}

}  // namespace
}  // namespace roomgraph
