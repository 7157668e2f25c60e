#include "MapText.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace roomgraph::test {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(trimmed(part));
  return parts;
}

/** "section.key = value" */
std::vector<std::string> parseSetting(const std::string& text) {
  const auto dot = text.find('.'), equals = text.find('=');
  return {text.substr(0, dot), trimmed(text.substr(dot + 1, equals - dot - 1)),
          trimmed(text.substr(equals + 1))};
}

void parseLine(const std::string& line, MapText& map) {
  const auto colon = line.find(':');
  if (colon == std::string::npos) throw std::runtime_error(map.name + ": no colon in " + line);
  const std::string key = line.substr(0, colon), value = trimmed(line.substr(colon + 1));
  Expected& expected = map.expected;
  if (key == "resolution") {
    map.resolution = std::stod(value);
  } else if (key == "preset") {
    map.preset = value;
  } else if (key == "by doors") {
    map.differsByDoors = value;
  } else if (key == "by disc") {
    map.differsByDisc = value;
  } else if (key == "not resampled") {
    map.notResampled = value;
  } else if (key == "set") {
    map.settings.push_back(parseSetting(value));
  } else if (key == "joined") {
    for (const auto& pair : splitAtCommas(value)) expected.joined.insert({pair[0], pair[2]});
  } else if (key == "exits") {
    for (const auto& part : splitAtCommas(value))
      expected.exits[part[0]] = std::stoi(part.substr(2));
  } else if (key == "notes") {
    for (const auto& code : splitAtCommas(value)) expected.noteCodes.insert(code);
  } else if (expected.counts.count(key)) {
    expected.counts[key] = std::stoi(value);
  } else {
    throw std::runtime_error(map.name + ": unknown key " + key);
  }
}

std::map<std::string, int> noCounts() {
  return {{"rooms", 0},     {"borders", 0}, {"dead ends", 0}, {"junctions", 0},
          {"corridors", 0}, {"rings", 0},   {"holes", 0}};
}

void setDrawing(const std::vector<std::string>& rows, MapText& map) {
  map.height = int(rows.size());
  for (const auto& row : rows) map.width = std::max(map.width, int(row.size()));
  map.cells.assign(std::size_t(map.width) * rows.size(), '?');
  const GridFrame frame = frameOf(map);
  for (int top = 0; top < map.height; ++top)
    for (int x = 0; x < int(rows[std::size_t(top)].size()); ++x) {
      const char drawnCell = rows[std::size_t(top)][std::size_t(x)];
      const Cell cell{x, map.height - 1 - top};
      const bool isName = std::isupper(static_cast<unsigned char>(drawnCell)) != 0;
      if (isName) map.names[drawnCell] = frame.center(cell);
      if (!isName && std::string("#.? ").find(drawnCell) == std::string::npos)
        throw std::runtime_error(map.name + ": strange cell " + drawnCell);
      map.cells[frame.index(cell)] = isName ? '.' : drawnCell == ' ' ? '?' : drawnCell;
    }
}

}  // namespace

MapText drawn(const std::vector<std::string>& rows, double resolution) {
  MapText map;
  map.resolution = resolution;
  map.expected.counts = noCounts();
  setDrawing(rows, map);
  return map;
}

MapText readMapText(const std::string& name) {
  MapText map;
  map.name = name;
  map.expected.counts = noCounts();
  std::ifstream in(std::string(ROOMGRAPH_TEST_MAPS) + "/" + name + ".map");
  if (!in) throw std::runtime_error("there is no drawing " + name);
  std::getline(in, map.sentence);
  std::string line;
  while (std::getline(in, line) && trimmed(line) != "drawing:") parseLine(line, map);
  std::vector<std::string> rows;
  while (std::getline(in, line)) rows.push_back(line);
  while (!rows.empty() && rows.back().empty()) rows.pop_back();
  setDrawing(rows, map);
  return map;
}

std::vector<std::string> mapNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(ROOMGRAPH_TEST_MAPS))
    if (entry.path().extension() == ".map") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

GridFrame frameOf(const MapText& text) {
  return {text.width, text.height, text.resolution, text.origin};
}

GreyMap greyMap(const MapText& text) {
  GreyMap map;
  map.frame = frameOf(text);
  map.occupiedAbove = 0.65;
  map.freeBelow = 0.35;
  map.source.kind = "drawing";
  map.source.file = text.name;
  for (const char cell : text.cells)
    map.grey.push_back(cell == '#'   ? std::uint8_t(0)
                       : cell == '.' ? std::uint8_t(255)
                                     : std::uint8_t(128));
  return map;
}

Grid gridOf(const MapText& text) {
  Grid grid{frameOf(text), {}};
  for (const char cell : text.cells)
    grid.cells.push_back(cell == '#'   ? State::occupied
                         : cell == '.' ? State::free
                                       : State::unknown);
  return grid;
}

ExtractOptions optionsOf(const MapText& text) {
  ExtractOptions options = preset(text.preset);
  FieldTable table = describe(options);
  for (const auto& setting : text.settings) table.set(setting[0], setting[1], setting[2]);
  return options;
}

bool hasUnknown(const MapText& text) {
  return std::find(text.cells.begin(), text.cells.end(), '?') != text.cells.end();
}

std::string picture(const MapText& text) {
  std::string rows;
  for (int y = text.height - 1; y >= 0; --y)
    rows += std::string(text.cells.begin() + std::ptrdiff_t(y) * text.width,
                        text.cells.begin() + std::ptrdiff_t(y + 1) * text.width) +
            "\n";
  return rows;
}

}  // namespace roomgraph::test
