#include "roomgraph/page/repair_page.h"

#include <cmath>
#include <set>
#include <utility>

#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/xml_text.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/page/simple_page.h"
#include "roomgraph/report/upright_turn.h"

namespace roomgraph {
namespace {

/** Where the scans of a run and what they have met lie in its picture, in pixels of kWallCell; y is
 *  down. */
struct Drawing {
  std::set<std::pair<int, int>> walls;
  std::vector<Point> path;
};

Point pixelOf(const Transform2D& upright, Point place) {
  const Point point = upright(place);
  return {point.x / kWallCell, -point.y / kWallCell};
}

Drawing drawingOf(const Run& run, const std::vector<Transform2D>& poses,
                  const Transform2D& upright) {
  Drawing drawing;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    const ScanWalls& scan = run.scans[k];
    const Transform2D motion = upright * (poses[k] * scan.pose.inverse());
    for (const WallPoint& wall : scan.walls) {
      const Point place = pixelOf(motion, wall.place);
      drawing.walls.insert({int(std::floor(place.y)), int(std::floor(place.x))});
    }
    drawing.path.push_back(pixelOf(upright, poses[k].shift()));
  }
  return drawing;
}

/** A box round both drawings, as an SVG has it. */
std::string viewBox(const Drawing& one, const Drawing& other) {
  Box box;
  for (const Drawing* drawing : {&one, &other}) {
    for (const auto& [row, column] : drawing->walls) box.include({double(column), double(row)});
    for (const Point p : drawing->path) box.include(p);
  }
  box = box.widened(5);
  return formatted("%.0f %.0f %.0f %.0f", box.low.x, box.low.y, box.size().x, box.size().y);
}

/** Walls, and the path: blue, or grey where the scans stay on their links. */
std::string picture(const Drawing& drawing, const std::string& viewBox, const char* what,
                    const Run& run, const std::vector<KeyFrames>& unseen) {
  std::string walls;
  for (const auto& [row, column] : drawing.walls) walls += formatted("M%d %dh1", column, row);
  std::string known, driven;
  for (std::size_t k = 1; k < drawing.path.size(); ++k) {
    const std::size_t frame = run.scans[k].keyFrame;
    const bool isUnseen = anyOf(unseen, [&](const KeyFrames& some) { return some.holds(frame); });
    const Point from = drawing.path[k - 1], to = drawing.path[k];
    (isUnseen ? driven : known) += formatted("M%.0f %.0fL%.0f %.0f", from.x, from.y, to.x, to.y);
  }
  return "<svg role=\"img\" aria-label=\"" + std::string(what) + "\" viewBox=\"" + viewBox +
         "\"><g fill=\"none\"><path stroke=\"#17202e\" stroke-width=\"1.2\" d=\"" + walls +
         "\"/><path stroke=\"#0a4f8f\" stroke-width=\"2\" d=\"" + known +
         "\"/><path stroke=\"#8a929c\" stroke-width=\"2\" d=\"" + driven + "\"/></g></svg>";
}

/** The steps from scan to scan that were breaks, as the repair has changed them. */
std::vector<MapBreak> mendedBreaks(const Run& run, const RepairedRun& repaired) {
  std::vector<MapBreak> breaks;
  for (std::size_t k = 1; k < run.scans.size(); ++k) {
    const Transform2D drawn = run.scans[k - 1].pose.inverse() * run.scans[k].pose;
    const Transform2D mended = repaired.poses[k - 1].inverse() * repaired.poses[k];
    MapBreak tear;
    tear.rotation = wrappedAngle(mended.phi - drawn.phi);
    tear.shift = distance(drawn.shift(), mended.shift());
    tear.keyFrame = run.scans[k].keyFrame;
    if (tear.kind() != BreakClass::slight) breaks.push_back(tear);
  }
  sortDownBy(breaks, &MapBreak::size);
  return breaks;
}

std::string row(const char* head, const std::string& cell) {
  return "<tr><th scope=\"row\">" + std::string(head) + "</th><td>" + cell + "</td></tr>\n";
}

std::string figures(const Run& run, const RepairedRun& repaired) {
  std::string breaks, stretches;
  for (const MapBreak& tear : mendedBreaks(run, repaired))
    breaks += formatted("before key frame %zu, by %.1f degrees and %.2f m<br>\n", *tear.keyFrame,
                        std::abs(tear.rotation) * 180 / M_PI, tear.shift);
  const char* keyFrames = repaired.isOneUnseen() ? "key frame " : "key frames ";
  for (const KeyFrames& stretch : repaired.unseen)
    stretches += (stretches.empty() ? keyFrames : ", ") + stretch.text();
  const bool isMended = repaired.state == RepairState::mended;
  return "<table><tbody>\n" +
         (isMended
              ? row("Moved", formatted("%.2f m RMS, up to %.2f m at key frame %zu", repaired.moved,
                                       repaired.movedMost, repaired.movedMostAt)) +
                    row("Breaks mended (not slight)", breaks.empty() ? "none" : breaks)
              : std::string()) +
         row("Known by links alone", stretches.empty() ? "nothing" : stretches) +
         "</tbody></table>\n";
}

std::string section(const ShownRepair& shown) {
  const Run& run = *shown.run;
  const RepairedRun& repaired = *shown.repaired;
  const Transform2D upright{0, 0, uprightTurn(run.map, 0)};
  const Drawing before = drawingOf(run, drawnPoses(run.scans), upright);
  const Drawing after = drawingOf(run, repaired.poses, upright);
  const std::string box = viewBox(before, after);
  std::string html = "<section><h2>" + xmlText(run.name) + "</h2>\n<p>" + xmlText(shown.line) +
                     "</p>\n" + figures(run, repaired);
  if (repaired.state != RepairState::mended)
    return html + "<div class=\"swipe\">" +
           picture(before, box, "as it was", run, repaired.unseen) +
           "<p>as it was</p></div></section>\n";
  return html + "<div class=\"swipe\">" + picture(after, box, "after", run, repaired.unseen) +
         "<p>after</p><div class=\"before\">" + picture(before, box, "before", run, {}) +
         "<p>before</p></div></div></section>\n";
}

}  // namespace

std::string repairPage(const std::vector<ShownRepair>& repairs) {
  const auto mended = countIf(repairs, [](const ShownRepair& shown) {
    return shown.repaired->state == RepairState::mended;
  });
  SimplePage page;
  page.title = page.heading = "Repaired runs", page.subject = "runs before and after their repair";
  page.counts = formatted("%zu of %zu mended.", mended, repairs.size());
  // The picture before lies over the one after; its right edge can be drawn.
  page.style =
      ".swipe{position:relative;container-type:inline-size;border:1px solid var(--line);"
      "background:#fff} .swipe svg{display:block;width:100cqw} "
      ".swipe .before{position:absolute;inset:0 auto 0 0;width:50%;max-width:100%;overflow:hidden;"
      "resize:horizontal;background:#fff;border-right:2px solid #0a4f8f} "
      ".swipe p{position:absolute;top:0;margin:4px;padding:0 6px;background:#fff;color:#17202e} "
      ".swipe>p{right:0} ";
  page.body =
      "<p class=\"hint\">Drag the lower right corner of the picture on top to see more or less of "
      "the one below it. The path is grey where only the links from key frame to key frame tell "
      "where it lies.</p>\n";
  for (const ShownRepair& shown : repairs) page.body += section(shown);
  page.footer = "How runs are mended is explained in roomgraph's docs/repair.md.";
  return simplePage(page);
}

}  // namespace roomgraph
