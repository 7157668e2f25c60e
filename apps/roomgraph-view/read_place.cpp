#include "read_place.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "roomgraph/base/printable.h"
#include "roomgraph/topology/kind_names.h"

namespace roomgraph {
namespace {

constexpr double kNear = 1;  // how far a thing may lie from a click [m]

template <class... Values>
std::string line(const char* form, Values... values) {
  char text[240];
  std::snprintf(text, sizeof text, form, values...);
  return text;
}

void addSiteRoom(const View& view, Point place, std::vector<std::string>& lines) {
  for (const SiteRoom& room : view.comparison.rooms) {
    if (sideOf(room.polygon, place) == Side::outside) continue;
    std::string missing;
    std::size_t seen = 0;
    for (const RoomInRun& in : room.runs) {
      if (in.sighting == RoomSighting::seen) {
        ++seen;
        continue;
      }
      missing += (missing.empty() ? "; not in " : ", ") + printable(in.run);
    }
    lines.push_back(line("%s %s, %.1f m2, in %zu of %zu runs",
                         room.isCorridor ? "corridor" : "room", printable(room.name).c_str(),
                         room.area, seen, room.runs.size()) +
                    missing);
    return;
  }
}

void addGraph(const View& view, Point place, std::vector<std::string>& lines) {
  if (!view.graph) return;
  const RoomGraph& graph = view.graph->file.graph;
  for (std::size_t r = 0; r < graph.rooms.size(); ++r)
    if (sideOf(graph.rooms[r].shape.polygon, place) != Side::outside)
      lines.push_back(line("room %zu, %.1f m2, %.2f m wide", r, area(graph.rooms[r].shape.polygon),
                           2 * graph.rooms[r].shape.inscribedRadius));
  const auto& vertices = graph.graph.vertices();
  const auto nearer = [&](const Vertex& l, const Vertex& r) {
    return distance(l.at, place) < distance(r.at, place);
  };
  const auto vertex = std::min_element(vertices.begin(), vertices.end(), nearer);
  if (vertex == vertices.end() || distance(vertex->at, place) > kNear) return;
  lines.push_back(line("vertex %zu (%s), clearance %.2f m", std::size_t(vertex - vertices.begin()),
                       kindName(vertex->kind), vertex->clearance));
}

std::string frameLine(const PathPose& at) {
  std::string text = line("key frame %zu at (%.2f, %.2f)", at.keyFrame, at.pose.x, at.pose.y);
  if (at.time) text += line(", time %.2f", *at.time);
  if (at.error) text += line(", error %.2f m", *at.error);
  return text;
}

}  // namespace

std::vector<std::string> readPlace(const View& view, const ViewState& state, Point place) {
  std::vector<std::string> lines{line("(%.2f, %.2f) m", place.x, place.y)};
  addSiteRoom(view, place, lines);
  addGraph(view, place, lines);
  const auto& path = view.path(state.run);
  const auto nearest =
      std::min_element(path.begin(), path.end(), [&](const PathPose& l, const PathPose& r) {
        return distance(l.pose.shift(), place) < distance(r.pose.shift(), place);
      });
  if (nearest != path.end() && distance(nearest->pose.shift(), place) < kNear)
    lines.push_back(frameLine(*nearest));
  return lines;
}

std::vector<std::string> readState(const View& view, const ViewState& state) {
  const ComparedRun& run = view.comparison.runs[state.run];
  std::vector<std::string> lines;
  std::string title = printable(run.name);
  if (run.score)
    title += line(": score %.0f, map error %.2f m", run.score->score, run.score->mapError);
  lines.push_back(title);
  if (state.frame < run.path.size()) lines.push_back(frameLine(run.path[state.frame]));
  if (!state.tear) return lines;
  const MapBreak& tear = view.comparison.breaks[*state.tear];
  lines.push_back(line("break %zu of %zu: all behind it is turned by %.1f deg, shifted by %.2f m",
                       *state.tear + 1, view.comparison.breaks.size(), tear.rotation * 180 / M_PI,
                       tear.shift));
  return lines;
}

}  // namespace roomgraph
