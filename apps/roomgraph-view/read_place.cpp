#include "read_place.h"

#include <algorithm>
#include <cmath>

#include "draw_stage.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/geometry/Polyline.h"
#include "roomgraph/topology/kind_names.h"

namespace roomgraph {
namespace {

constexpr double kPlaceReach = 1;  // how far a thing may lie from a click [m]

std::optional<std::size_t> vertexNear(const View& view, Point place) {
  if (!view.graph) return std::nullopt;
  const auto& vertices = view.graph->file.graph.graph.vertices();
  const auto nearer = [&](const Vertex& l, const Vertex& r) {
    return distance(l.place, place) < distance(r.place, place);
  };
  const auto vertex = std::min_element(vertices.begin(), vertices.end(), nearer);
  if (vertex == vertices.end() || distance(vertex->place, place) > kPlaceReach) return std::nullopt;
  return std::size_t(vertex - vertices.begin());
}

void addSiteRoom(const View& view, Point place, std::vector<std::string>& lines) {
  const SiteRoom* room = siteRoomAt(view, place);
  if (!room) return;
  std::string missing;
  std::size_t seen = 0;
  for (const RoomInRun& in : room->runs) {
    if (in.sighting == RoomSighting::seen) {
      ++seen;
      continue;
    }
    missing += (missing.empty() ? "; not in " : ", ") + printable(in.run);
  }
  lines.push_back(formatted("%s %s, %.1f m2, in %zu of %zu runs",
                            room->isCorridor ? "corridor" : "room", printable(room->name).c_str(),
                            room->area, seen, room->runs.size()) +
                  missing);
}

void addGraph(const View& view, Point place, std::vector<std::string>& lines) {
  if (!view.graph) return;
  const RoomGraph& graph = view.graph->file.graph;
  if (const auto r = roomAt(view, place)) {
    const GraphRoom& room = graph.rooms[*r];
    lines.push_back(formatted("room %zu, %.1f m2, %.2f m wide, %zu ways out", *r,
                              area(room.shape.polygon), 2 * room.shape.inscribedRadius,
                              room.borderVertices.size()));
  }
  if (const auto v = vertexNear(view, place)) {
    const Vertex& vertex = graph.graph.vertices()[*v];
    lines.push_back(
        formatted("vertex %zu (%s), clearance %.2f m", *v, nameOf(vertex.kind), vertex.clearance));
  }
  if (const auto e = pathNear(view, place)) {
    const Edge& edge = graph.graph.edges()[*e];
    lines.push_back(formatted("path %zu from vertex %zu to %zu, %.2f m long, clearance %.2f m", *e,
                              edge.source.index(), edge.target.index(), edge.path.length,
                              edge.path.minClearance));
  }
}

std::string frameLine(const PathPose& at) {
  std::string text = formatted("key frame %zu at (%.2f, %.2f)", at.keyFrame, at.pose.x, at.pose.y);
  if (at.time) text += formatted(", time %.2f (", *at.time) + timeText(*at.time) + ")";
  if (at.error) text += formatted(", error %.2f m", *at.error);
  return text;
}

void addFault(const View& view, const ViewState& state, std::vector<std::string>& lines) {
  if (!state.fault) return;
  constexpr const char* kWords[] = {"break", "drawn twice", "laid over each other"};
  const Fault& fault = view.faults[*state.fault];
  lines.push_back((view.map ? "fault" : "break") +
                  formatted(" %zu of %zu", *state.fault + 1, view.faults.size()) +
                  (view.map ? std::string(", ") + kWords[std::size_t(fault.kind)] : "") + ": " +
                  fault.text);
  if (state.other)
    lines.push_back("what " + printable(view.comparison.runs[*state.other].name) + " shows there");
}

void addNudge(const View& view, const ViewState& state, std::vector<std::string>& lines) {
  const auto fit = nudgeFit(view, state);
  const std::string onto = printable(view.comparison.runs[*otherRun(view, state)].name);
  lines.push_back(formatted("nudged by (%.2f, %.2f) m, %.1f deg on ", state.nudge.x, state.nudge.y,
                            state.nudge.phi * 180 / M_PI) +
                  onto);
  if (fit)
    lines.push_back(
        formatted("overlap %.0f %%, walls found %.0f %%, contradicted %.0f %%, fit %.1f",
                  100 * fit->overlap, 100 * fit->found, 100 * fit->contradicted, fit->score));
}

void addMode(const View& view, const ViewState& state, std::vector<std::string>& lines) {
  const auto other = otherRun(view, state);
  if (state.mode == Mode::measure) {
    const std::size_t count = state.corners.size();
    const double last = count > 1 ? distance(state.corners[count - 2], state.corners.back()) : 0;
    lines.push_back(
        formatted("measured: %.2f m, the last piece %.2f m", length(state.corners), last));
  }
  if (state.mode == Mode::swipe && other)
    lines.push_back("left " + printable(view.comparison.runs[state.run].name) + ", right " +
                    printable(view.comparison.runs[*other].name));
  if (state.mode == Mode::nudge && other) addNudge(view, state, lines);
  if (state.isFlickering && other)
    lines.push_back("now " +
                    printable(view.comparison.runs[state.isFlicked ? *other : state.run].name));
}

}  // namespace

std::vector<std::string> readPlace(const View& view, const ViewState& state, Point place) {
  std::vector<std::string> lines{formatted("(%.2f, %.2f) m", place.x, place.y)};
  addSiteRoom(view, place, lines);
  addGraph(view, place, lines);
  const auto& path = view.path(state.run);
  const auto nearest =
      std::min_element(path.begin(), path.end(), [&](const PathPose& l, const PathPose& r) {
        return distance(l.pose.shift(), place) < distance(r.pose.shift(), place);
      });
  if (nearest != path.end() && distance(nearest->pose.shift(), place) < kPlaceReach)
    lines.push_back(frameLine(*nearest));
  return lines;
}

const SiteRoom* siteRoomAt(const View& view, Point place) {
  for (const SiteRoom& room : view.comparison.rooms)
    if (sideOf(room.polygon, place) != Side::outside) return &room;
  return nullptr;
}

std::optional<std::size_t> roomAt(const View& view, Point place) {
  if (!view.graph) return std::nullopt;
  const auto& rooms = view.graph->file.graph.rooms;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    if (sideOf(rooms[r].shape.polygon, place) != Side::outside) return r;
  return std::nullopt;
}

std::optional<std::size_t> pathNear(const View& view, Point place) {
  if (!view.graph) return std::nullopt;
  const auto& edges = view.graph->file.graph.graph.edges();
  std::optional<std::size_t> nearest;
  double least = kPlaceReach;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Polyline& points = edges[e].path.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double away = distanceToSegment(place, points[i], points[i + 1]);
      if (away < least) least = away, nearest = e;
    }
  }
  return nearest;
}

std::vector<std::string> readState(const View& view, const ViewState& state) {
  const ComparedRun& run = view.comparison.runs[state.run];
  std::vector<std::string> lines;
  std::string title = printable(run.name);
  if (run.score)
    title += formatted(": score %.0f, map error %.2f m", run.score->score, run.score->mapError);
  lines.push_back(title);
  if (state.stage && view.stages) lines.push_back(stageLine(*view.stages, *state.stage));
  if (state.frame < run.path.size()) lines.push_back(frameLine(run.path[state.frame]));
  addFault(view, state, lines);
  addMode(view, state, lines);
  return lines;
}

}  // namespace roomgraph
