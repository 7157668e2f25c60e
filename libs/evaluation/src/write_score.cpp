#include "roomgraph/evaluation/write_score.h"

#include <cmath>

#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/version.h"
#include "stability_json.h"

namespace roomgraph {
namespace {

struct Measure {
  const char* name;  ///< as it is published
  const char* key;   ///< in the JSON
  std::optional<double> RoomScore::*value;
  const char* meaning;
};

constexpr Measure kShares[] = {
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

}  // namespace

std::string roomScoreText(const RoomScore& score) {
  const std::string dropped = "<= " + std::to_string(score.largestDropped) + " px, dropped";
  std::string text = line("%-22s %11s %11s\n", "", "LABELS", "TRUTH");
  text += countLine("regions", score.seg.count, score.truth.count);
  text += countLine(dropped.c_str(), score.seg.dropped, score.truth.dropped);
  text += countLine("pixels in regions", score.seg.pixels, score.truth.pixels);
  text += countLine("pixels in both", score.pixelsInBoth, score.pixelsInBoth);
  text += countLine("paired one to one", score.pairs, score.pairs);
  for (const Measure& measure : kShares)
    text += line("%-8s %7s %%  %s\n", measure.name, number("%.2f", score.*measure.value, 100),
                 measure.meaning);
  return text + line("%-8s %7s    %s\n", "MCC", number("%.4f", score.mcc, 1),
                     "Matthews correlation of regions paired one to one, 0 for those without");
}

std::string roomScoreJson(const RoomScore& score) {
  Json all{{"format", "roomgraph/room_score"},
           {"version", 1},
           {"program", {{"name", "roomgraph"}, {"version", version()}}},
           {"size", {score.width, score.height}},
           {"largest_dropped_px", score.largestDropped},
           {"labels", json(score.seg)},
           {"truth", json(score.truth)},
           {"pixels_in_both", score.pixelsInBoth},
           {"pairs", score.pairs}};
  for (const Measure& measure : kShares) {
    const std::optional<double> share = score.*measure.value;
    all[measure.key] = roundedTo(share ? std::optional<double>(100 * *share) : std::nullopt, 4);
  }
  all["mcc"] = roundedTo(score.mcc, 6);
  std::string text;
  for (const auto& [key, value] : all.items())
    text += (text.empty() ? "{\n\"" : ",\n\"") + key + "\": " + lineOf(value);
  return text + "\n}\n";
}

}  // namespace roomgraph
