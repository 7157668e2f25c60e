#include "summary.h"

#include <algorithm>
#include <sstream>

namespace roomgraph::test {
namespace {

std::vector<char> roomNames(const RoomGraph& graph, const MapText& text) {
  std::vector<char> names(graph.rooms.size(), '?');
  for (std::size_t r = 0; r < names.size(); ++r)
    for (const auto& [name, at] : text.names)
      if (sideOf(graph.rooms[r].shape.polygon, at) == Side::inside) names[r] = name;
  return names;
}

/** The rooms that a walk from room `r` reaches without going through another room. */
std::set<std::size_t> neighbours(const RoomGraph& rooms, std::size_t r) {
  const TopologyGraph& graph = rooms.graph;
  std::set<std::size_t> found;
  std::vector<bool> isSeen(graph.vertices().size());
  std::vector<VertexId> open{rooms.rooms[r].vertex};
  isSeen[open.front().index()] = true;
  while (!open.empty()) {
    const VertexId at = open.back();
    open.pop_back();
    for (const HalfEdgeId h : graph.outgoing(at)) {
      const VertexId next = graph.target(h);
      const RoomId room = graph.edge(h).room;
      if (room && room != RoomId(r)) {
        found.insert(room.index());
      } else if (!isSeen[next.index()]) {
        isSeen[next.index()] = true;
        open.push_back(next);
      }
    }
  }
  return found;
}

template <class Map>
void compareNumbers(const Map& wanted, const Map& found, std::ostringstream& out) {
  for (const auto& [key, value] : wanted) {
    const auto it = found.find(key);
    const int is = it == found.end() ? -1 : it->second;
    if (is != value) out << key << ": " << is << ", expected " << value << "\n";
  }
}

std::string textOf(const std::set<NamePair>& pairs) {
  std::string text;
  for (const auto& [a, b] : pairs) text += std::string(1, a) + "-" + b + " ";
  return text;
}

std::string textOf(const std::set<std::string>& codes) {
  std::string text;
  for (const auto& code : codes) text += code + " ";
  return text;
}

}  // namespace

Expected summarize(const Stages& stages, const MapText& text) {
  const RoomGraph& result = stages.result;
  Expected found;
  found.counts = {{"rooms", 0},     {"borders", 0}, {"dead ends", 0}, {"junctions", 0},
                  {"corridors", 0}, {"rings", 0},   {"holes", 0}};
  const char* const kinds[] = {"junctions", "dead ends", "borders", "rooms", "rings"};
  for (const Vertex& vertex : result.graph.vertices())
    ++found.counts[kinds[std::size_t(vertex.kind)]];
  for (const Edge& edge : result.graph.edges()) found.counts["corridors"] += !edge.room;
  const std::vector<char> names = roomNames(result, text);
  for (std::size_t r = 0; r < names.size(); ++r) {
    found.counts["holes"] += int(result.rooms[r].shape.polygon.holes.size());
    found.exits[names[r]] = int(result.rooms[r].borderVertices.size());
    for (const std::size_t other : neighbours(result, r))
      found.joined.insert({std::min(names[r], names[other]), std::max(names[r], names[other])});
  }
  for (const Note& note : stages.notes) found.noteCodes.insert(note.code);
  return found;
}

std::string differenceFromExpected(const Stages& stages, const MapText& text) {
  const Expected found = summarize(stages, text);
  const Expected& wanted = text.expected;
  std::ostringstream out;
  compareNumbers(wanted.counts, found.counts, out);
  compareNumbers(wanted.exits, found.exits, out);
  for (const auto& [name, at] : text.names)
    if (!found.exits.count(name)) out << "no room is where the letter " << name << " is\n";
  if (found.joined != wanted.joined)
    out << "joined: " << textOf(found.joined) << ", expected " << textOf(wanted.joined) << "\n";
  if (found.noteCodes != wanted.noteCodes)
    out << "notes: " << textOf(found.noteCodes) << ", expected " << textOf(wanted.noteCodes)
        << "\n";
  return out.str();
}

}  // namespace roomgraph::test
