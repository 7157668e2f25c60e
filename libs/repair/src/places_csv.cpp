#include <boost/algorithm/string/join.hpp>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/csv_text.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

using Cells = std::vector<std::string>;

/** A table whose first line names its columns. */
class PlacesTable {
 public:
  PlacesTable(const std::string& text, const std::string& file) : file_(file), reader_(text, file) {
    names_ = reader_.nextLine(), writtenNames_ = reader_.writtenCells();
    for (const char* name : {"name", "x", "y", "yaw"})
      if (countIf(names_, [&](const std::string& one) { return isNamed(one, name); }) > 1)
        refuse(file, std::string("has two columns '") + name + "'", "leave one of them out");
    for (const char* needed : {"x", "y"})
      if (!columnOf(needed))
        refuse(file, std::string("has no column '") + needed + "'",
               "give GeoJSON, osmAG, a site.json, a mask's yaml, or a table whose first line names "
               "its columns: name,x,y,yaw");
  }

  /** As they stand in the text. */
  const Cells& writtenNames() const { return writtenNames_; }
  /** Those of the last line. */
  const Cells& writtenCells() const { return reader_.writtenCells(); }

  /** Empty behind the last line; lines without any text are left out. */
  Cells nextLine() {
    while (!reader_.isAtEnd()) {
      Cells cells = reader_.nextLine();
      if (cells.size() == 1 && cells[0].empty()) continue;
      while (cells.size() > names_.size() && cells.back().empty()) cells.pop_back();
      if (cells.size() > names_.size())
        refuse(file_,
               formatted("has %zu cells in line %zu, and %zu columns", cells.size(), reader_.line(),
                         names_.size()),
               "name each column in its first line, and put texts with commas in quotes");
      cells.resize(names_.size());
      return cells;
    }
    return {};
  }

  std::optional<std::size_t> columnOf(const char* name) const {
    return roomgraph::columnOf(names_, name);
  }

  std::string nameOf(const Cells& cells) const {
    const auto name = columnOf("name");
    return name && !cells[*name].empty() ? cells[*name] : "line " + std::to_string(reader_.line());
  }

  /** None of what was carried to where the map has not been, and has no x and y since. */
  std::optional<Transform2D> poseIn(const Cells& cells) const {
    if (cells[*columnOf("x")].empty() && cells[*columnOf("y")].empty()) return std::nullopt;
    return Transform2D{numberIn(cells, "x"), numberIn(cells, "y"),
                       columnOf("yaw") ? numberIn(cells, "yaw") : 0};
  }

 private:
  double numberIn(const Cells& cells, const char* name) const {
    const std::string& cell = cells[*columnOf(name)];
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    if (cell.empty() || *end != '\0' || !(std::abs(value) < kFarthestOrigin))
      refuse(file_,
             "'" + cell + "' in line " + std::to_string(reader_.line()) + " is not a valid " + name,
             "give metres, up to 10 000 km, and radians for yaw");
    return value;
  }

  std::string file_;
  CsvReader reader_;
  Cells names_, writtenNames_;
};

std::string csvRow(const Cells& cells) { return boost::algorithm::join(cells, ",") + "\n"; }

std::string carriedCsv(const std::string& text, const std::string& file,
                       const std::vector<CarriedThing>& carried) {
  PlacesTable table(text, file);
  Cells names = table.writtenNames();
  const auto columnOf = [&](const char* name) {
    const auto column = table.columnOf(name);
    if (!column) names.emplace_back(name);
    return column.value_or(names.size() - 1);
  };
  const std::size_t state = columnOf("state"), error = columnOf("error_m"),
                    reason = columnOf("reason");
  std::string out = csvRow(names);
  for (const CarriedThing& place : carried) {
    table.nextLine();
    Cells fields = table.writtenCells();
    fields.resize(names.size());
    const auto set = [&](const char* name, double Transform2D::*value) {
      if (const auto column = table.columnOf(name))
        fields[*column] = place.error ? csvNumber(place.poses.front().*value) : "";
    };
    set("x", &Transform2D::x), set("y", &Transform2D::y), set("yaw", &Transform2D::phi);
    fields[state] = nameOf(place.state), fields[error] = csvNumber(place.error);
    fields[reason] = csvField(place.reason);
    out += csvRow(fields);
  }
  return out;
}

}  // namespace

MarkedFile csvPlaces(const std::string& text, const std::string& file) {
  MarkedFile marked;
  PlacesTable table(text, file);
  for (Cells cells = table.nextLine(); !cells.empty(); cells = table.nextLine()) {
    Thing& thing = marked.things.emplace_back();
    thing.name = table.nameOf(cells);
    if (const auto pose = table.poseIn(cells)) {
      thing.places = {marked.places.size()};
      marked.places.push_back({thing.name, *pose});
    }
  }
  marked.files = {fileName(file)};
  marked.write = [text, file](const std::vector<CarriedThing>& carried, const GridFrame&) {
    return std::vector<NamedBytes>{{fileName(file), carriedCsv(text, file, carried)}};
  };
  return marked;
}

}  // namespace roomgraph
