#include "roomgraph/report/comparison_csv.h"

#include <array>

#include "roomgraph/base/csv_text.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/utf8_text.h"
#include "roomgraph/measures/measure_kinds.h"

namespace roomgraph {
namespace {

/** What is told of the breaks of a run, each kind of figure in a field. */
std::string breakFields(const Comparison& comparison, const std::string& run) {
  std::array<std::string, 4> fields;
  for (const MapBreak& tear : comparison.breaks) {
    if (tear.run != run) continue;
    const std::string figures[] = {tear.keyFrame ? std::to_string(*tear.keyFrame) : "-",
                                   csvNumber(tear.place.x) + " " + csvNumber(tear.place.y),
                                   csvNumber(tear.rotation * 180 / M_PI), csvNumber(tear.shift)};
    for (std::size_t i = 0; i < fields.size(); ++i)
      fields[i] += (fields[i].empty() ? "" : ";") + figures[i];
  }
  std::string text;
  for (const std::string& field : fields) text += "," + csvField(field);
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
            csvField(utf8Text(fileName(run.file)));
    for (double RunScore::*member :
         {&RunScore::score, &RunScore::low, &RunScore::high, &RunScore::mapError,
          &RunScore::errorLow, &RunScore::errorHigh})
      text +=
          "," + csvNumber(run.score ? std::optional<double>((*run.score).*member) : std::nullopt);
    text += run.score && run.score->isMeaningful ? ",1," : ",0,";
    if (run.name != comparison.reference) text += nameOf(comparison.certaintyOf(run));
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
