#include "roomgraph/mrpt_plugin/graph_text.h"

#include <array>
#include <iomanip>
#include <locale>
#include <sstream>

#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

std::ostringstream plainText() {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(2);
  return out;
}

std::string inputText(const GraphFile& file) {
  std::ostringstream out = plainText();
  const GridFrame& frame = file.input.frame;
  out << "Room graph of " << (file.input.file.empty() ? "an unnamed map" : file.input.file) << "\n";
  if (!file.input.kind.empty()) out << "  kind      " << file.input.kind << "\n";
  if (frame.cellCount() > 0)
    out << "  map       " << frame.width << " x " << frame.height << " cells of "
        << std::setprecision(4) << frame.resolution << std::setprecision(2)
        << " m, lower left corner at (" << frame.origin.x << ", " << frame.origin.y << ") m\n";
  if (!file.input.insertion.empty()) out << "  built by  " << file.input.insertion << "\n";
  if (!file.input.sha256.empty()) out << "  sha256    " << file.input.sha256 << "\n";
  if (!file.program.empty()) out << "  made by   " << file.program << " " << file.version << "\n";
  return out.str();
}

std::string vertexText(const TopologyGraph& graph) {
  constexpr std::array<std::pair<VertexKind, const char*>, 5> kinds{
      {{VertexKind::room, "room"},
       {VertexKind::border, "border"},
       {VertexKind::junction, "junction"},
       {VertexKind::deadEnd, "dead end"},
       {VertexKind::ring, "ring"}}};
  std::array<std::size_t, 5> counts{};
  for (const Vertex& vertex : graph.vertices())
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (vertex.kind == kinds[i].first) ++counts[i];
  std::ostringstream out;
  out << counted(graph.vertices().size(), "vertex", "vertices");
  for (std::size_t i = 0; i < kinds.size(); ++i)
    out << (i == 0 ? ": " : ", ") << counts[i] << " " << kinds[i].second;
  out << "\n";
  return out.str();
}

std::string edgeText(const TopologyGraph& graph) {
  std::size_t corridors = 0, inRooms = 0;
  double corridorLength = 0, roomLength = 0;
  for (const Edge& edge : graph.edges()) {
    ++(edge.room ? inRooms : corridors);
    (edge.room ? roomLength : corridorLength) += edge.path.length;
  }
  std::ostringstream out = plainText();
  out << counted(graph.edges().size(), "edge", "edges") << ": "
      << counted(corridors, "corridor", "corridors") << " of " << corridorLength << " m, "
      << inRooms << " inside of rooms of " << roomLength << " m\n"
      << "total path length " << corridorLength + roomLength << " m\n";
  return out.str();
}

std::string roomText(const std::vector<GraphRoom>& rooms) {
  std::ostringstream out = plainText();
  double total = 0;
  for (const GraphRoom& room : rooms) total += area(room.shape.polygon);
  out << counted(rooms.size(), "room", "rooms") << " of " << total << " m2\n";
  if (rooms.empty()) return out.str();
  out << "\n  room   area [m2]  inscribed radius [m]  exits  center [m]\n";
  for (std::size_t i = 0; i < rooms.size(); ++i)
    out << std::setw(6) << i << std::setw(12) << area(rooms[i].shape.polygon) << std::setw(22)
        << rooms[i].shape.inscribedRadius << std::setw(7) << rooms[i].borderVertices.size() << "  ("
        << rooms[i].center.x << ", " << rooms[i].center.y << ")\n";
  return out.str();
}

std::string noteText(const Notes& notes) {
  if (notes.empty()) return "";
  std::ostringstream out = plainText();
  out << "\nNotes\n";
  for (const Note& note : notes) {
    out << "  " << note.code << ": " << note.text;
    if (note.where) out << " (at " << (*note.where)[0] << ", " << (*note.where)[1] << ")";
    out << "\n";
  }
  return out.str();
}

}  // namespace

std::string graphText(const GraphFile& file) {
  return inputText(file) + "\n" + vertexText(file.graph.graph) + edgeText(file.graph.graph) +
         roomText(file.graph.rooms) + noteText(file.notes);
}

}  // namespace roomgraph
