#include "roomgraph/report/comparison_csv.h"

#include <functional>

#include "json_places.h"
#include "roomgraph/base/csv_text.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/measures/measure_kinds.h"

namespace roomgraph {
namespace {

/** A figure of each break of a run, in their order. */
std::string ofBreaks(const Comparison& comparison, const std::string& run,
                     const std::function<std::string(const MapBreak&)>& figure) {
  std::string text;
  for (const MapBreak& tear : comparison.breaks)
    if (tear.run == run) text += (text.empty() ? "" : ";") + figure(tear);
  return text;
}

std::string breakFields(const Comparison& comparison, const std::string& run) {
  const auto keyFrame = [](const MapBreak& tear) {
    return tear.keyFrame ? std::to_string(*tear.keyFrame) : "-";
  };
  const auto place = [](const MapBreak& tear) {
    return csvNumber(tear.place.x) + " " + csvNumber(tear.place.y);
  };
  const auto turn = [](const MapBreak& tear) { return csvNumber(tear.rotation * 180 / M_PI); };
  const auto shift = [](const MapBreak& tear) { return csvNumber(tear.shift); };
  std::string text;
  for (const auto& figure : std::initializer_list<std::function<std::string(const MapBreak&)>>{
           keyFrame, place, turn, shift})
    text += "," + csvField(ofBreaks(comparison, run, figure));
  return text;
}

}  // namespace

std::string comparisonRunsCsv(const Comparison& comparison) {
  std::string text =
      "rank,name,file,score,score_low,score_high,map_error_m,map_error_low,map_error_high,"
      "meaningful,certainty,x,y,phi";
  for (const MeasureKind& kind : runMeasureKinds()) text += std::string(",") + kind.name;
  text += ",break_key_frames,break_places,break_turns_deg,break_shifts_m\n";
  for (const ComparedRun& run : comparison.runs) {
    text += (run.rank ? std::to_string(run.rank) : "") + "," + csvField(run.name) + "," +
            csvField(fileName(run.file));
    for (double RunScore::*member :
         {&RunScore::score, &RunScore::low, &RunScore::high, &RunScore::mapError,
          &RunScore::errorLow, &RunScore::errorHigh})
      text +=
          "," + csvNumber(run.score ? std::optional<double>((*run.score).*member) : std::nullopt);
    text += run.score && run.score->isMeaningful ? ",1," : ",0,";
    if (run.score) text += nameOf(comparison.certaintyOf(run));
    for (const double value : {run.pose.x, run.pose.y, run.pose.phi})
      text += "," + csvNumber(value);
    for (const MeasureKind& kind : runMeasureKinds())
      text += "," + csvNumber(valueOf(run.measures, kind.name));
    text += breakFields(comparison, run.name) + "\n";
  }
  return text;
}

std::string comparisonRoomsCsv(const Comparison& comparison) {
  std::string text =
      "id,name,kind,x,y,area_m2,run,sighting,pieces,merged,shift_m,area_change,"
      "boundary_agreement,length_error_m,doors_gained,doors_lost\n";
  for (const SiteRoom& room : comparison.rooms) {
    std::string start = csvField(room.id) + "," + csvField(room.name) + "," +
                        (room.isCorridor ? "corridor" : "room");
    for (const double value : {room.center.x, room.center.y, room.area})
      start += "," + csvNumber(value);
    for (const RoomInRun& in : room.runs) {
      text += start + "," + csvField(in.run) + "," + nameOf(in.sighting) + "," +
              std::to_string(in.pieces) + (in.isMerged ? ",1" : ",0");
      for (const auto& value : {in.shift, in.areaChange, in.boundaryAgreement, in.lengthError})
        text += "," + csvNumber(value);
      text += "," + std::to_string(in.doorsGained) + "," + std::to_string(in.doorsLost) + "\n";
    }
  }
  return text;
}

}  // namespace roomgraph
