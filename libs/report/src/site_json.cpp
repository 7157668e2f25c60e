#include "roomgraph/report/site_json.h"

#include <cmath>
#include <set>

#include "json_places.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/version.h"
#include "roomgraph/json/json_fault.h"

namespace roomgraph {
namespace {

constexpr double kFarthest = 1e11;  // beyond any place of a map that can be read [m]

/** What is wrong, and where. */
struct Fault {
  std::string where, problem;
};

const Json& member(const Json& json, const std::string& where, const char* key) {
  if (!json.is_object()) throw Fault{where, "is no object"};
  const auto found = json.find(key);
  if (found == json.end()) throw Fault{where, std::string("has no '") + key + "'"};
  return *found;
}

double number(const Json& json, const std::string& where) {
  if (!json.is_number()) throw Fault{where, "is no number"};
  const double value = json.get<double>();
  if (!(std::abs(value) <= kFarthest)) throw Fault{where, "is too large"};
  return value;
}

double number(const Json& json, const std::string& where, const char* key) {
  return number(member(json, where, key), where + "." + key);
}

std::string text(const Json& json, const std::string& where, const char* key) {
  const Json& value = member(json, where, key);
  if (!value.is_string()) throw Fault{where + "." + key, "is no text"};
  return value.get<std::string>();
}

const Json& list(const Json& json, const std::string& where) {
  if (!json.is_array()) throw Fault{where, "is no list"};
  return json;
}

Ring ring(const Json& json, const std::string& where) {
  Ring result;
  for (const Json& pair : list(json, where)) {
    if (!pair.is_array() || pair.size() != 2) throw Fault{where, "has an entry that is no [x, y]"};
    result.push_back({number(pair[0], where), number(pair[1], where)});
  }
  if (result.size() < 3) throw Fault{where, "has fewer than 3 corners"};
  return result;
}

int nextNumber(const Json& json, const char* key) {
  const Json& value = member(json, "next", key);
  if (!value.is_number_integer() || value < 1 || value > 1000000000)
    throw Fault{std::string("next.") + key, "is no number from 1 on"};
  return value.get<int>();
}

SiteDoor door(const Json& json, const std::string& where) {
  const Json& to = member(json, where, "to");
  return {{number(json, where, "x"), number(json, where, "y")},
          number(json, where, "width"),
          to.is_null() ? "" : text(json, where, "to")};
}

KnownRoom room(const Json& json, const std::string& where) {
  KnownRoom result;
  result.id = text(json, where, "id");
  if (result.id.empty()) throw Fault{where + ".id", "is empty"};
  result.name = json.contains("name") ? text(json, where, "name") : "";
  if (result.name.empty()) result.name = result.id;
  const std::string kind = text(json, where, "kind");
  if (kind != "room" && kind != "corridor")
    throw Fault{where + ".kind", "is neither 'room' nor 'corridor'"};
  result.isCorridor = kind == "corridor";
  result.center = {number(json, where, "x"), number(json, where, "y")};
  result.area = number(json, where, "area_m2");
  result.polygon.outer = ring(member(json, where, "polygon"), where + ".polygon");
  for (const Json& hole : list(member(json, where, "holes"), where + ".holes"))
    result.polygon.holes.push_back(ring(hole, where + ".holes"));
  for (const Json& one : list(member(json, where, "doors"), where + ".doors"))
    result.doors.push_back(door(one, where + ".doors"));
  return result;
}

SiteFile site(const Json& json) {
  if (text(json, "the file", "format") != "roomgraph/site")
    throw Fault{"format", "is not 'roomgraph/site'"};
  if (member(json, "the file", "version") != 1)
    throw Fault{"version", "is not 1, the only one that this program reads"};
  SiteFile file;
  const Json& next = member(json, "the file", "next");
  file.nextRoom = nextNumber(next, "room"), file.nextCorridor = nextNumber(next, "corridor");
  std::set<std::string> ids;
  for (const Json& one : list(member(json, "the file", "rooms"), "rooms")) {
    const std::string where = "rooms[" + std::to_string(file.rooms.size()) + "]";
    file.rooms.push_back(room(one, where));
    if (!ids.insert(file.rooms.back().id).second)
      throw Fault{where + ".id", "is that of another room, too"};
  }
  return file;
}

}  // namespace

SiteFile parseSiteJson(const std::string& content, const std::string& name) {
  constexpr const char* kRemedy = ": repair it, or name another file with --names";
  const std::string fault = jsonFault(content, "roomgraph/site");
  if (!fault.empty()) throw DataError(name + ": " + fault + kRemedy);
  const Json json = Json::parse(content, nullptr, false);
  if (json.is_discarded()) throw DataError(name + ": is no JSON, or only a part of one" + kRemedy);
  try {
    return site(json);
  } catch (const Fault& found) {
    throw DataError(name + ": " + found.where + " " + found.problem + kRemedy);
  }
}

std::string siteJson(const SiteFile& file) {
  std::string text = "{\n\"format\": \"roomgraph/site\",\n\"version\": 1,\n";
  text += "\"program\": " + lineOf({{"name", "roomgraph"}, {"version", version()}}) + ",\n";
  text += "\"next\": " + lineOf({{"room", file.nextRoom}, {"corridor", file.nextCorridor}}) + ",\n";
  text += "\"rooms\": [";
  const char* separator = "\n";
  for (const KnownRoom& room : file.rooms) {
    text += separator + lineOf({{"id", room.id},
                                {"name", room.name},
                                {"kind", room.isCorridor ? "corridor" : "room"},
                                {"x", toTenthMillimetre(room.center.x)},
                                {"y", toTenthMillimetre(room.center.y)},
                                {"area_m2", toTenthMillimetre(room.area)},
                                {"polygon", ringJson(room.polygon.outer)},
                                {"holes", ringsJson(room.polygon.holes)},
                                {"doors", doorsJson(room.doors)}});
    separator = ",\n";
  }
  return text + (file.rooms.empty() ? "]\n}\n" : "\n]\n}\n");
}

}  // namespace roomgraph
