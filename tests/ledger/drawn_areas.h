#pragma once
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "SiteAreas.h"

namespace roomgraph::test {

/** A door between two areas of a drawing, by their letters. */
struct DrawnDoor {
  char a, b;
  Point place;             ///< [m]
  bool isUpright = false;  ///< its ends lie one above the other
};

constexpr double kDrawnCell = 0.5;  ///< side of what a letter stands for [m]

/** The frame of a drawing: cells of 0.1 m, the lower left corner at the origin. */
inline GridFrame frameOf(const std::vector<std::string>& rows) {
  return {int(rows[0].size()) * 5, int(rows.size()) * 5, kDrawnCell / 5, {}};
}

/** The areas of a run as they are drawn, rows from the top: each letter is an area that is an
 *  upright box, in the order of the alphabet, small letters, which are corridors, last; '#' is
 *  wall, '.' is free and in no area, ' ' is unknown. */
inline RunAreas drawnAreas(const std::vector<std::string>& rows,
                           const std::vector<DrawnDoor>& doors = {}, double weight = 1) {
  const GridFrame frame = frameOf(rows);
  const auto letterAt = [&](Cell c) {
    return rows[rows.size() - 1 - std::size_t(c.y / 5)][std::size_t(c.x / 5)];
  };
  std::map<char, Box> boxes;
  for (std::size_t i = 0; i < frame.cellCount(); ++i) {
    const Cell cell{int(i) % frame.width, int(i) / frame.width};
    if (!std::isalpha(letterAt(cell))) continue;
    const Point half{frame.resolution / 2, frame.resolution / 2}, at = frame.center(cell);
    Box& box = boxes.emplace(letterAt(cell), Box{at - half, at + half}).first->second;
    box = boundingBox({box.low, box.high, at - half, at + half});
  }
  AreaGraph areas;
  std::map<char, AreaId> idOf;
  for (const auto& [letter, box] : boxes) {
    Area area;
    area.polygon.outer = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    if (std::isupper(letter)) area.room = RoomId(areas.areas.size());
    idOf[letter] = AreaId(areas.areas.size());
    areas.areas.push_back(area);
  }
  for (const DrawnDoor& door : doors) {
    const Point half = door.isUpright ? Point{0, 0.5} : Point{0.5, 0};
    areas.passages.push_back(
        {idOf.at(door.a), idOf.at(door.b), door.place - half, door.place + half, 1});
  }
  RunAreas run = areasIn(areas, frame);
  run.weight = weight;
  for (std::size_t i = 0; i < frame.cellCount(); ++i) {
    const char letter = letterAt({int(i) % frame.width, int(i) / frame.width});
    if (letter == '#') run.labels[i] = RunAreas::occupied, run.isWall[i] = true;
    if (letter == '.') run.labels[i] = RunAreas::free;
    if (letter == ' ') run.labels[i] = RunAreas::unknown;
  }
  return run;
}

/** The same run with its areas in another order: area order[i] becomes area i. */
inline RunAreas reordered(const RunAreas& run, const std::vector<std::size_t>& order) {
  std::vector<std::size_t> placeOf(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) placeOf[order[i]] = i;
  RunAreas other = run;
  for (std::size_t i = 0; i < order.size(); ++i) {
    other.shapes[i] = run.shapes[order[i]];
    other.doors[i] = run.doors[order[i]];
    for (AreaDoor& door : other.doors[i]) door.to = placeOf[door.to];
  }
  for (std::uint16_t& label : other.labels)
    if (label >= RunAreas::firstArea)
      label = std::uint16_t(RunAreas::firstArea + placeOf[label - RunAreas::firstArea]);
  return other;
}

/** The drawing as a mirror shows it. */
inline std::vector<std::string> mirrored(std::vector<std::string> rows) {
  for (std::string& row : rows) std::reverse(row.begin(), row.end());
  return rows;
}

/** A place of a drawing in its mirror image. */
inline Point mirrored(Point p, const std::vector<std::string>& rows) {
  return {double(rows[0].size()) * kDrawnCell - p.x, p.y};
}

/** A corridor with a room on the left and two on the right. */
inline const std::vector<std::string>& threeRooms() {
  static const std::vector<std::string> rows{
      "######################", "#AAAAAAAA##BBBBBBBBBB#", "#AAAAAAAA##BBBBBBBBBB#",
      "#AAAAAAAA##BBBBBBBBBB#", "#AAAAAAAA##BBBBBBBBBB#", "#AAAAAAAA#############",
      "##########dddddddddddd", "##########dddddddddddd", "##########dddddddddddd",
      "##########dddddddddddd", "######################", "##########CCCCCCCC####",
      "##########CCCCCCCC####", "##########CCCCCCCC####", "##########CCCCCCCC####",
      "######################"};
  return rows;
}

/** The doors of these rooms. */
inline std::vector<DrawnDoor> threeDoors() {
  return {{'B', 'd', {8, 5.25}}, {'C', 'd', {7, 2.75}}, {'A', 'B', {4.75, 6.5}, true}};
}

}  // namespace roomgraph::test
