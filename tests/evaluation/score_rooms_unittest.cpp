#include "roomgraph/evaluation/score_rooms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "refusal.h"

namespace roomgraph {
namespace {

/** A picture of one row: a letter per label, '.' for none. */
LabelMap row(const std::string& text) {
  LabelMap map;
  map.width = int(text.size());
  map.height = 1;
  for (const char c : text) map.label.push_back(c == '.' ? 0 : std::uint32_t(c));
  return map;
}

/** Every region counts, however small. */
RoomScore score(const std::string& seg, const std::string& truth) {
  return scoreRooms(row(seg), row(truth), 0);
}

double matthews(double tp, double fp, double fn, double tn) {
  return (tp * tn - fp * fn) / std::sqrt((tp + fp) * (tp + fn) * (tn + fp) * (tn + fn));
}

void expectAll(const RoomScore& s, double value) {
  for (const auto& measure : {s.precisionMicro, s.precisionMacro, s.recallMicro, s.recallMacro,
                              s.iouSeg, s.iouTruth, s.mcc}) {
    ASSERT_TRUE(measure.has_value());
    EXPECT_DOUBLE_EQ(*measure, value);
  }
}

/** Bit for bit: sums are made in an order that the labels have no part in. */
void expectSame(const RoomScore& a, const RoomScore& b) {
  EXPECT_EQ(a.precisionMicro, b.precisionMicro);
  EXPECT_EQ(a.precisionMacro, b.precisionMacro);
  EXPECT_EQ(a.recallMicro, b.recallMicro);
  EXPECT_EQ(a.recallMacro, b.recallMacro);
  EXPECT_EQ(a.iouSeg, b.iouSeg);
  EXPECT_EQ(a.iouTruth, b.iouTruth);
  EXPECT_EQ(a.mcc, b.mcc);
  EXPECT_EQ(a.pairs, b.pairs);
}

LabelMap randomMap(unsigned seed) {
  std::mt19937 random(seed);
  LabelMap map;
  map.width = 40;
  map.height = 30;
  map.label.resize(map.pixelCount());
  for (std::size_t i = 0; i < map.label.size(); ++i)
    map.label[i] = std::uint32_t(random() % 4 == 0 ? random() % 9 : i % 40 / 8);
  return map;
}

TEST(ScoreRooms, equalMapsAreRightInEverything) {
  expectAll(score("aaa.bb.c", "xxx.yy.z"), 1);
  expectAll(score("aaa", "xxx"), 1);
  const RoomScore s = score("aaa.bb.c", "xxx.yy.z");
  EXPECT_EQ(s.pairs, 3u);
  EXPECT_EQ(s.pixelsInBoth, 6u);
}

// s: a 6, b 4; g: x 4, y 5. O[a,x] 4, O[a,y] 2, O[b,y] 3.
TEST(ScoreRooms, precisionIsTheShareOfARegionInOneOfTheTruth) {
  const RoomScore s = score("aaaaaabbbb.", "xxxxyyyyy..");
  EXPECT_DOUBLE_EQ(*s.precisionMicro, (4.0 / 6 + 3.0 / 4) / 2);
  EXPECT_DOUBLE_EQ(*s.precisionMacro, 7.0 / 10);
}

TEST(ScoreRooms, recallIsTheShareOfATrueRegionInOneFound) {
  const RoomScore s = score("aaaaaabbbb.", "xxxxyyyyy..");
  EXPECT_DOUBLE_EQ(*s.recallMicro, (4.0 / 4 + 3.0 / 5) / 2);
  EXPECT_DOUBLE_EQ(*s.recallMacro, 7.0 / 9);
}

TEST(ScoreRooms, intersectionOverUnionIsThatOfTheLargestOverlap) {
  const RoomScore s = score("aaaaaabbbb.", "xxxxyyyyy..");
  EXPECT_DOUBLE_EQ(*s.iouSeg, (4.0 / 6 + 3.0 / 6) / 2);
  EXPECT_DOUBLE_EQ(*s.iouTruth, (4.0 / 6 + 3.0 / 6) / 2);
  // b shares most with x, though its intersection over union with y is greater.
  const RoomScore other = score("aaaaaabb.b", "xxxxxxxx.y");
  EXPECT_DOUBLE_EQ(*other.iouSeg, (6.0 / 8 + 2.0 / 9) / 2);
  EXPECT_DOUBLE_EQ(*other.iouTruth, (6.0 / 8 + 1.0 / 3) / 2);
}

TEST(ScoreRooms, matthewsCoefficientCountsPixelsThatBothLabel) {
  const RoomScore s = score("aaaaaabbbb.", "xxxxyyyyy..");  // 9 in both
  EXPECT_EQ(s.pixelsInBoth, 9u);
  EXPECT_DOUBLE_EQ(*s.mcc, (matthews(4, 2, 0, 3) + matthews(3, 0, 2, 4)) / 2);
}

TEST(ScoreRooms, matthewsCoefficientPairsOneToOne) {
  // Both a and b lie in x, which belongs to the larger of them; b remains without.
  const RoomScore s = score("aaaabbccc", "xxxxxxyyy");
  EXPECT_EQ(s.pairs, 2u);
  EXPECT_DOUBLE_EQ(*s.mcc, (matthews(4, 0, 2, 3) + 1) / 3);
}

TEST(ScoreRooms, regionsWithoutCommonPixelCountAsNothing) {
  const RoomScore s = score("aabb..", "xx..zz");
  EXPECT_DOUBLE_EQ(*s.precisionMicro, 0.5);
  EXPECT_DOUBLE_EQ(*s.precisionMacro, 0.5);
  EXPECT_DOUBLE_EQ(*s.recallMicro, 0.5);
  EXPECT_DOUBLE_EQ(*s.iouSeg, 0.5);
  EXPECT_DOUBLE_EQ(*s.mcc, 1.0 / 3);
}

TEST(ScoreRooms, matthewsCoefficientWithoutAnyNegativeIsZeroUnlessAllAgrees) {
  EXPECT_DOUBLE_EQ(*score("aab", "xxx").mcc, 0);
  EXPECT_DOUBLE_EQ(*score("aaa..", "xxxx.").mcc, 1);
}

TEST(ScoreRooms, partsOfOneLabelAreOneRegion) {
  const RoomScore s = score("a.a.b", "x.x.y");
  EXPECT_EQ(s.seg.count, 2u);
  expectAll(s, 1);
}

TEST(ScoreRooms, exchangedMapsExchangeTheMeasures) {
  const LabelMap a = randomMap(1), b = randomMap(2);
  const RoomScore s = scoreRooms(a, b), t = scoreRooms(b, a);
  EXPECT_NE(s.precisionMicro, s.recallMicro);
  EXPECT_EQ(s.precisionMicro, t.recallMicro);
  EXPECT_EQ(s.precisionMacro, t.recallMacro);
  EXPECT_EQ(s.recallMicro, t.precisionMicro);
  EXPECT_EQ(s.recallMacro, t.precisionMacro);
  EXPECT_EQ(s.iouSeg, t.iouTruth);
  EXPECT_EQ(s.iouTruth, t.iouSeg);
  EXPECT_EQ(s.mcc, t.mcc);
  EXPECT_EQ(s.seg.count, t.truth.count);
  EXPECT_EQ(s.seg.pixels, t.truth.pixels);
}

TEST(ScoreRooms, numbersOfLabelsMeanNothing) {
  const LabelMap a = randomMap(3), b = randomMap(4);
  LabelMap renamed = a;
  for (std::uint32_t& label : renamed.label)
    if (label) label = 0xfffffff0u - label * 12345u;
  expectSame(scoreRooms(a, b), scoreRooms(renamed, b));
  expectSame(scoreRooms(b, a), scoreRooms(b, renamed));
}

// O is 2 for all four pairs, so that only the order of the pixels tells them apart.
TEST(ScoreRooms, tiesDoNotDependOnTheNumbers) {
  expectSame(score("aabbaabb", "xxxxyyyy"), score("bbaabbaa", "yyyyxxxx"));
  EXPECT_EQ(score("aabbaabb", "xxxxyyyy").pairs, 2u);
}

// a shares 2 with each of x and y, and y is the smaller.
TEST(ScoreRooms, tiesGoToTheGreaterIntersectionOverUnion) {
  EXPECT_DOUBLE_EQ(*score("aaaa.....", "xxyy.xxx.").iouSeg, 2.0 / 4);
  EXPECT_DOUBLE_EQ(*score("aaaa.....", "yyxx.yyy.").iouSeg, 2.0 / 4);
}

TEST(ScoreRooms, smallRegionsAreDropped) {
  const std::string room(101, 'a'), speck(100, 'b'), wall(9, '.');
  const LabelMap with = row(room + speck + wall), without = row(room + std::string(109, '.'));
  const RoomScore s = scoreRooms(with, without);
  EXPECT_EQ(s.seg.count, 1u);
  EXPECT_EQ(s.seg.dropped, 1u);
  EXPECT_EQ(s.seg.pixels, 101u);
  EXPECT_EQ(s.truth.dropped, 0u);
  expectAll(s, 1);
  EXPECT_LT(*scoreRooms(with, without, 99).precisionMicro, 1);
}

/** A room that is found only where the truth has something too small is not in both. */
TEST(ScoreRooms, droppedRegionsLabelNothing) {
  const RoomScore s = scoreRooms(row("aaaaa.bbb"), row("xxxyy.zzz"), 2);
  EXPECT_EQ(s.truth.dropped, 1u);
  EXPECT_EQ(s.pixelsInBoth, 6u);
  EXPECT_DOUBLE_EQ(*s.mcc, 1);
  EXPECT_DOUBLE_EQ(*s.precisionMicro, (3.0 / 5 + 1) / 2);
}

TEST(ScoreRooms, mapsWithoutRegionsHaveNoMeans) {
  const RoomScore nothing = score("...", "...");
  EXPECT_FALSE(nothing.precisionMicro || nothing.precisionMacro || nothing.recallMicro ||
               nothing.recallMacro || nothing.iouSeg || nothing.iouTruth || nothing.mcc);
  const RoomScore noneFound = score("...", "xxx");
  EXPECT_FALSE(noneFound.precisionMicro || noneFound.precisionMacro || noneFound.iouSeg);
  EXPECT_EQ(noneFound.recallMicro, 0.0);
  EXPECT_EQ(noneFound.recallMacro, 0.0);
  EXPECT_EQ(noneFound.iouTruth, 0.0);
  EXPECT_EQ(noneFound.mcc, 0.0);
}

TEST(ScoreRooms, mapsOfDifferentSizesAreRefusedWithBoth) {
  LabelMap tall = row("aaa");
  std::swap(tall.width, tall.height);
  const std::string text = test::refusalOf([&] { scoreRooms(row("aaa"), tall); });
  EXPECT_NE(text.find("3 x 1"), std::string::npos) << text;
  EXPECT_NE(text.find("1 x 3"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST(WriteScore, jsonHoldsEveryNumber) {
  LabelMap seg = row("aaaaaabbbb."), truth = row("xxxxyyyyy..");
  seg.source = {"folder/seg.png", "12ab"};
  const std::string text = roomScoreJson(scoreRooms(seg, truth, 0));
  for (const char* part :
       {"\"file\":\"seg.png\",\"sha256\":\"12ab\",\"regions\":2,\"dropped\":0,\"pixels\":10",
        "\"size\": [11,1]", "\"largest_dropped_px\": 0", "\"pixels_in_both\": 9", "\"pairs\": 2",
        "\"p_micro_percent\": 70.8333", "\"p_macro_percent\": 70.0", "\"r_micro_percent\": 80.0",
        "\"r_macro_percent\": 77.7778", "\"iou_seg_percent\": 58.3333",
        "\"iou_gt_percent\": 58.3333", "\"mcc\": 0.6"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

TEST(WriteScore, whatHasNoValueIsNullOrADash) {
  const RoomScore nothing = score("...", "...");
  EXPECT_NE(roomScoreJson(nothing).find("\"mcc\": null"), std::string::npos);
  EXPECT_NE(roomScoreJson(nothing).find("\"p_micro_percent\": null"), std::string::npos);
  EXPECT_NE(roomScoreText(nothing).find("P micro        - %"), std::string::npos);
  EXPECT_EQ(roomScoreText(nothing).find("nan"), std::string::npos);
}

TEST(WriteScore, textHasPercents) {
  const std::string text = roomScoreText(score("aaaaaabbbb.", "xxxxyyyyy.."));
  EXPECT_NE(text.find("P micro    70.83 %"), std::string::npos) << text;
  EXPECT_NE(text.find("IoU gt     58.33 %"), std::string::npos) << text;
}

}  // namespace
}  // namespace roomgraph
