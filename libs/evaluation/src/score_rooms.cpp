#include "roomgraph/evaluation/score_rooms.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/OneToOne.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

struct Share {
  const char* name;  ///< as it is published
  const char* key;   ///< in the JSON
  std::optional<double> RoomScore::*value;
  const char* meaning;
};

constexpr Share kShares[] = {
    {"P micro", "p_micro_percent", &RoomScore::precisionMicro,
     "of a region of LABELS lies in one of TRUTH, mean of the regions"},
    {"P macro", "p_macro_percent", &RoomScore::precisionMacro, "the same, mean of the pixels"},
    {"R micro", "r_micro_percent", &RoomScore::recallMicro,
     "of a region of TRUTH lies in one of LABELS, mean of the regions"},
    {"R macro", "r_macro_percent", &RoomScore::recallMacro, "the same, mean of the pixels"},
    {"IoU seg", "iou_seg_percent", &RoomScore::iouSeg,
     "intersection over union of a region of LABELS and its largest partner"},
    {"IoU gt", "iou_gt_percent", &RoomScore::iouTruth,
     "intersection over union of a region of TRUTH and its largest partner"},
};

std::string line(const char* format, const char* name, const std::string& value,
                 const std::string& rest) {
  return formatted(format, name, value.c_str(), rest.c_str());
}

std::string number(const char* format, std::optional<double> value, double factor) {
  return value ? formatted(format, *value * factor) : "-";
}

std::string countLine(const char* name, std::size_t seg, std::size_t truth) {
  return line("%-22s %11s %11s\n", name, std::to_string(seg), std::to_string(truth));
}

Json roundedTo(std::optional<double> value, double digits) {
  if (!value) return nullptr;
  const double unit = std::pow(10, digits);
  return std::round(*value * unit) / unit;
}

Json json(const ScoredRegions& regions) {
  return {{"file", fileName(regions.source.file)},
          {"sha256", regions.source.sha256},
          {"regions", regions.count},
          {"dropped", regions.dropped},
          {"pixels", regions.pixels}};
}

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
  eraseIf(pairs, isDropped);
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

std::string roomScoreText(const RoomScore& score) {
  const std::string dropped = "<= " + std::to_string(score.largestDropped) + " px, dropped";
  std::string text = line("%-22s %11s %11s\n", "", "LABELS", "TRUTH");
  text += countLine("regions", score.seg.count, score.truth.count);
  text += countLine(dropped.c_str(), score.seg.dropped, score.truth.dropped);
  text += countLine("pixels in regions", score.seg.pixels, score.truth.pixels);
  text += countLine("pixels in both", score.pixelsInBoth, score.pixelsInBoth);
  text += countLine("paired one to one", score.pairs, score.pairs);
  for (const Share& share : kShares)
    text += line("%-8s %7s %%  %s\n", share.name, number("%.2f", score.*share.value, 100),
                 share.meaning);
  return text + line("%-8s %7s    %s\n", "MCC", number("%.4f", score.mcc, 1),
                     "Matthews correlation of regions paired one to one, 0 for those without");
}

std::string roomScoreJson(const RoomScore& score) {
  JsonDocument document("roomgraph/room_score");
  document.add("size", {score.width, score.height});
  document.add("largest_dropped_px", score.largestDropped);
  document.add("labels", json(score.seg));
  document.add("truth", json(score.truth));
  document.add("pixels_in_both", score.pixelsInBoth);
  document.add("pairs", score.pairs);
  for (const Share& share : kShares) {
    const std::optional<double> value = score.*share.value;
    document.add(share.key,
                 roundedTo(value ? std::optional<double>(100 * *value) : std::nullopt, 4));
  }
  document.add("mcc", roundedTo(score.mcc, 6));
  return std::move(document).text();
}

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
