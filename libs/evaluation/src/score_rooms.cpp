#include "roomgraph/evaluation/score_rooms.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/OneToOne.h"

namespace roomgraph {
namespace {

/** Numbers keys in the order in which they first come. Equal keys mostly follow each other. */
class Numbering {
 public:
  std::size_t numberOf(std::uint64_t key) {
    if (key == lastKey_ && !numbers_.empty()) return last_;
    lastKey_ = key;
    last_ = numbers_.emplace(key, numbers_.size()).first->second;
    return last_;
  }

 private:
  std::unordered_map<std::uint64_t, std::size_t> numbers_;  // looked up, never walked through
  std::uint64_t lastKey_ = 0;
  std::size_t last_ = 0;
};

/** The regions of one side, in the order of their first pixels. */
struct Regions {
  Numbering numbering;
  std::vector<std::size_t> size;    ///< |s| [px]
  std::vector<std::size_t> common;  ///< those that the other side labels, too

  std::size_t add(std::uint32_t label) {
    const std::size_t region = numbering.numberOf(label);
    if (region == size.size()) size.push_back(0);
    ++size[region];
    return region;
  }
};

struct Pair {
  std::size_t s = 0, g = 0;
  std::size_t overlap = 0;  ///< O[s,g], above 0
};

struct Counts {
  Regions seg, truth;
  std::vector<Pair> pairs;  ///< in the order of their first common pixels
};

Counts countPixels(const LabelMap& seg, const LabelMap& truth) {
  Counts counts;
  Numbering pairNumbers;
  for (std::size_t i = 0; i < seg.label.size(); ++i) {
    const std::uint32_t a = seg.label[i], b = truth.label[i];
    const std::size_t s = a ? counts.seg.add(a) : 0, g = b ? counts.truth.add(b) : 0;
    if (!a || !b) continue;
    const std::size_t pair = pairNumbers.numberOf(std::uint64_t(s) << 32 | g);
    if (pair == counts.pairs.size()) counts.pairs.push_back({s, g, 0});
    ++counts.pairs[pair].overlap;
  }
  return counts;
}

std::size_t unionOf(const Pair& pair, const Counts& counts) {
  return counts.seg.size[pair.s] + counts.truth.size[pair.g] - pair.overlap;
}

/** Leaves the pairs of regions that are large enough, sorted as in the contract, and sums up what
 *  is common. */
void keepLargePairs(Counts& counts, std::size_t largestDropped) {
  std::vector<Pair>& pairs = counts.pairs;
  const auto isDropped = [&](const Pair& pair) {
    return counts.seg.size[pair.s] <= largestDropped || counts.truth.size[pair.g] <= largestDropped;
  };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isDropped), pairs.end());
  std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) {
    if (a.overlap != b.overlap) return a.overlap > b.overlap;
    return unionOf(a, counts) < unionOf(b, counts);
  });
  counts.seg.common.assign(counts.seg.size.size(), 0);
  counts.truth.common.assign(counts.truth.size.size(), 0);
  for (const Pair& pair : pairs) {
    counts.seg.common[pair.s] += pair.overlap;
    counts.truth.common[pair.g] += pair.overlap;
  }
}

ScoredRegions scored(const LabelMap& map, const Regions& regions, std::size_t largestDropped) {
  ScoredRegions result;
  result.source = map.source;
  for (const std::size_t size : regions.size) {
    if (size <= largestDropped) {
      ++result.dropped;
      continue;
    }
    ++result.count;
    result.pixels += size;
  }
  return result;
}

/** What the regions of one side have in common with their largest partners. */
struct PartnerMeans {
  std::optional<double> micro, macro, iou;
};

/** `member` is the side's region in a pair. */
PartnerMeans partnerMeans(const Counts& counts, const Regions& regions, std::size_t Pair::*member,
                          const ScoredRegions& side) {
  if (side.count == 0) return {};
  std::vector<const Pair*> largest(regions.size.size());
  for (const Pair& pair : counts.pairs)
    if (!largest[pair.*member]) largest[pair.*member] = &pair;
  double share = 0, iou = 0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    if (!largest[i]) continue;
    share += double(largest[i]->overlap) / double(regions.size[i]);
    iou += double(largest[i]->overlap) / double(unionOf(*largest[i], counts));
    pixels += largest[i]->overlap;
  }
  const auto count = double(side.count);
  return {share / count, double(pixels) / double(side.pixels), iou / count};
}

double matthews(double tp, double fp, double fn, double tn) {
  const double below = std::sqrt((tp + fp) * (tp + fn)) * std::sqrt((tn + fp) * (tn + fn));
  if (below > 0) return (tp * tn - fp * fn) / below;
  return fp == 0 && fn == 0 ? 1 : 0;
}

void addMatthews(const Counts& counts, RoomScore& score) {
  OneToOne pairing(counts.seg.size.size(), counts.truth.size.size());
  double sum = 0;
  for (const Pair& pair : counts.pairs) {
    if (!pairing.take(pair.s, pair.g)) continue;
    ++score.pairs;
    const auto tp = double(pair.overlap);
    const double fp = double(counts.seg.common[pair.s]) - tp;
    const double fn = double(counts.truth.common[pair.g]) - tp;
    sum += matthews(tp, fp, fn, double(score.pixelsInBoth) - tp - fp - fn);
  }
  const std::size_t rooms = score.seg.count + score.truth.count - score.pairs;
  if (rooms > 0) score.mcc = sum / double(rooms);
}

std::string sizeText(const LabelMap& map) {
  return std::to_string(map.width) + " x " + std::to_string(map.height);
}

void checkSizes(const LabelMap& seg, const LabelMap& truth) {
  if (seg.width == truth.width && seg.height == truth.height) return;
  throw DataError("the labels have " + sizeText(seg) + " pixels and the truth has " +
                  sizeText(truth) + ": give two pictures of one map, in one size");
}

}  // namespace

RoomScore scoreRooms(const LabelMap& seg, const LabelMap& truth, std::size_t largestDropped) {
  checkSizes(seg, truth);
  Counts counts = countPixels(seg, truth);
  keepLargePairs(counts, largestDropped);
  RoomScore score;
  score.width = seg.width;
  score.height = seg.height;
  score.largestDropped = largestDropped;
  score.seg = scored(seg, counts.seg, largestDropped);
  score.truth = scored(truth, counts.truth, largestDropped);
  for (const Pair& pair : counts.pairs) score.pixelsInBoth += pair.overlap;
  const PartnerMeans ofSeg = partnerMeans(counts, counts.seg, &Pair::s, score.seg);
  score.precisionMicro = ofSeg.micro;
  score.precisionMacro = ofSeg.macro;
  score.iouSeg = ofSeg.iou;
  const PartnerMeans ofTruth = partnerMeans(counts, counts.truth, &Pair::g, score.truth);
  score.recallMicro = ofTruth.micro;
  score.recallMacro = ofTruth.macro;
  score.iouTruth = ofTruth.iou;
  addMatthews(counts, score);
  return score;
}

}  // namespace roomgraph
