#include "roomgraph/report/run_check_json.h"

#include <cmath>

#include "json_places.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/version.h"

namespace roomgraph {
namespace {

Json breakJson(const MapBreak& tear) {
  return {{"key_frame", orNull(tear.keyFrame)},
          {"time", orNull(tear.time)},
          {"x", rounded(tear.place.x)},
          {"y", rounded(tear.place.y)},
          {"rotation_deg", tear.torn ? Json(rounded(tear.rotation * 180 / M_PI)) : Json()},
          {"shift_m", tear.torn ? Json(rounded(tear.shift)) : Json()}};
}

Json poseJson(const CheckedPose& at) {
  return {{"key_frame", at.keyFrame},         {"time", orNull(at.time)},
          {"x", rounded(at.pose.x)},          {"y", rounded(at.pose.y)},
          {"phi", rounded(at.pose.phi)},      {"agreed_x", rounded(at.agreed.x)},
          {"agreed_y", rounded(at.agreed.y)}, {"agreed_phi", rounded(at.agreed.phi)},
          {"error_m", rounded(at.error)},     {"seen_twice", at.isSeenTwice}};
}

std::string stretchText(const DrawnStretch& stretch) {
  return formatted("at (%.1f, %.1f) by key frames %zu to %zu", stretch.place.x, stretch.place.y,
                   stretch.first, stretch.last);
}

Json stretchJson(const DrawnStretch& stretch) {
  return {{"first_key_frame", stretch.first}, {"last_key_frame", stretch.last},
          {"key_frame", stretch.keyFrame},    {"time", orNull(stretch.time)},
          {"x", rounded(stretch.place.x)},    {"y", rounded(stretch.place.y)}};
}

Json doubledJson(const DoubledPlace& place) {
  return {{"apart_m", rounded(place.apart)},
          {"passes", {stretchJson(place.one), stretchJson(place.other)}}};
}

Json weldedJson(const WeldedPlace& place) {
  return {{"passes", {stretchJson(place.one), stretchJson(place.other)}}};
}

Json evidenceJson(const Evidence& row) {
  return {{"name", row.name},
          {"unit", row.unit},
          {"drawn", numberOrNull(row.drawn)},
          {"agreed", numberOrNull(row.agreed)},
          {"support", row.support}};
}

}  // namespace

std::string runCheckJson(const RunCheck& check) {
  const auto metres = [&](double value) {
    return check.selfError ? Json(rounded(value)) : Json(nullptr);
  };
  std::string text = "{\n\"format\": \"roomgraph/check\",\n\"version\": 1,\n";
  text += "\"program\": " + lineOf({{"name", "roomgraph"}, {"version", version()}}) + ",\n";
  text += "\"name\": " + lineOf(Json(check.name)) + ",\n";
  text += "\"file\": " + lineOf(Json(fileName(check.file))) + ",\n";
  text += "\"sha256\": " + lineOf(Json(check.sha256)) + ",\n";
  text += "\"self_error_m\": " + lineOf(metres(check.selfError.value_or(0))) + ",\n";
  text += "\"self_error_low_m\": " + lineOf(metres(check.low)) + ",\n";
  text += "\"self_error_high_m\": " + lineOf(metres(check.high)) + ",\n";
  text += "\"seen_twice\": " + lineOf(Json(rounded(check.seenTwice))) + ",\n";
  text += "\"confirmed\": " + lineOf(Json(check.isConfirmed)) + ",\n";
  text += lines("breaks", check.breaks, breakJson);
  text += lines("doubled", check.doubled, doubledJson);
  text += lines("welded", check.welded, weldedJson);
  text += lines("evidence", check.evidence, evidenceJson);
  text += lines("path", check.path, poseJson);
  return text + "\"sentence\": " + lineOf(Json(check.sentence)) + "\n}\n";
}

std::string toldText(const RunCheck& check) {
  std::string text;
  if (!check.breaks.empty()) {
    text += counted(check.breaks.size(), "break", "breaks");
    if (check.breaks.front().torn) text += ", the largest " + selfBreakText(check.breaks.front());
    text += "; ";
  }
  if (!check.doubled.empty())
    text += counted(check.doubled.size(), "place", "places") + " drawn twice, the worst " +
            doubledText(check.doubled.front()) + "; ";
  if (!check.welded.empty())
    text += counted(check.welded.size(), "place", "places") + " laid over another, the largest " +
            weldedText(check.welded.front()) + "; ";
  return text + check.sentence;
}

std::string runCheckText(const RunCheck& check) {
  return printable(check.name) + ": " + toldText(check) + "\n";
}

std::string doubledText(const DoubledPlace& place) {
  return stretchText(place.one) + formatted(" and, %.2f m beside, ", place.apart) +
         stretchText(place.other);
}

std::string weldedText(const WeldedPlace& place) {
  return stretchText(place.one) + " and " + stretchText(place.other);
}

std::string selfBreakText(const MapBreak& tear) {
  const std::string place = formatted("before key frame %zu, ", tear.keyFrame.value_or(0));
  if (!tear.torn) return place + "by how much its scans do not tell";
  return place + formatted("%.1f degrees and %.2f m", tear.rotation * 180 / M_PI, tear.shift);
}

}  // namespace roomgraph
