#include "roomgraph/report/run_check_json.h"

#include <cmath>

#include "roomgraph/base/file_name.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/report/json_parts.h"

namespace roomgraph {
namespace {

Json ownBreakJson(const MapBreak& tear) {
  return {{"key_frame", orNull(tear.keyFrame)},
          {"time", orNull(tear.time)},
          {"x", rounded(tear.place.x)},
          {"y", rounded(tear.place.y)},
          {"rotation_deg", tear.torn ? Json(rounded(tear.rotation * 180 / M_PI)) : Json()},
          {"shift_m", tear.torn ? Json(rounded(tear.shift)) : Json()}};
}

Json checkedPoseJson(const CheckedPose& at) {
  return {{"key_frame", at.keyFrame},         {"time", orNull(at.time)},
          {"x", rounded(at.pose.x)},          {"y", rounded(at.pose.y)},
          {"phi", rounded(at.pose.phi)},      {"agreed_x", rounded(at.agreed.x)},
          {"agreed_y", rounded(at.agreed.y)}, {"agreed_phi", rounded(at.agreed.phi)},
          {"error_m", rounded(at.error)},     {"seen_twice", at.isSeenTwice}};
}

std::string stretchText(const DrawnStretch& stretch) {
  return formatted("at (%.1f, %.1f) by key frame", stretch.place.x, stretch.place.y) +
         (stretch.first == stretch.last ? formatted(" %zu", stretch.first)
                                        : formatted("s %zu to %zu", stretch.first, stretch.last));
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
  JsonDocument document("roomgraph/check");
  document.add("name", check.name);
  document.add("file", fileName(check.file));
  document.add("sha256", check.sha256);
  document.add("self_error_m", metres(check.selfError.value_or(0)));
  document.add("self_error_low_m", metres(check.low));
  document.add("self_error_high_m", metres(check.high));
  document.add("seen_twice", rounded(check.seenTwice));
  document.add("confirmed", check.isConfirmed);
  document.addList("breaks", check.breaks, ownBreakJson);
  document.addList("doubled", check.doubled, doubledJson);
  document.addList("welded", check.welded, weldedJson);
  document.addList("evidence", check.evidence, evidenceJson);
  document.addList("path", check.path, checkedPoseJson);
  document.add("sentence", toldText(check));
  return std::move(document).text();
}

std::string toldText(const RunCheck& check) {
  std::string text;
  const auto tell = [&](std::size_t count, const char* one, const char* many, const char* worst,
                        const std::string& first) {
    text += counted(count, one, many) + (count > 1 ? std::string(", ") + worst + " " : ", ") +
            first + "; ";
  };
  if (!check.breaks.empty() && check.breaks.front().torn)
    tell(check.breaks.size(), "break", "breaks", "the largest",
         selfBreakText(check.breaks.front()));
  else if (!check.breaks.empty())
    text += counted(check.breaks.size(), "break", "breaks") + "; ";
  if (!check.doubled.empty())
    tell(check.doubled.size(), "place drawn twice", "places drawn twice", "the worst",
         doubledText(check.doubled.front()));
  if (!check.welded.empty())
    tell(check.welded.size(), "place laid over another", "places laid over others", "the largest",
         weldedText(check.welded.front()));
  return text + check.sentence;
}

std::string runCheckText(const RunCheck& check) {
  return printable(check.name) + ": " + toldText(check) + "\n";
}

std::string doubledText(const DoubledPlace& place) {
  return stretchText(place.one) + formatted(" and, %.2f m away, ", place.apart) +
         stretchText(place.other);
}

std::string weldedText(const WeldedPlace& place) {
  return stretchText(place.one) + " and " + stretchText(place.other);
}

std::string selfBreakText(const MapBreak& tear) {
  const std::string place = formatted("before key frame %zu, ", tear.keyFrame.value_or(0));
  if (!tear.torn) return place + "by how much its scans do not tell";
  return place +
         formatted("%.1f degrees and %.2f m", std::abs(tear.rotation) * 180 / M_PI, tear.shift);
}

}  // namespace roomgraph
