#include "roomgraph/page/check_page.h"

#include <cmath>
#include <optional>

#include "roomgraph/align/wall_quality.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/xml_text.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/page/simple_page.h"
#include "roomgraph/report/faults.h"
#include "roomgraph/report/run_check_json.h"
#include "roomgraph/report/upright_turn.h"

namespace roomgraph {
namespace {

constexpr double kScanReach = 12;  // walls that are shown at a break, from it [m]

/** Places as dots of a path; y is up in maps and down in pictures. */
std::string dots(const std::vector<Point>& places, const char* colour, double size) {
  std::string path;
  for (const Point p : places) path += formatted("M%.2f %.2fh0", p.x, -p.y);
  return std::string("<path class=\"dots\" stroke=\"") + colour +
         formatted("\" stroke-width=\"%.2f\" d=\"", size) + path + "\"/>\n";
}

/** Opens a picture of what lies in `box` once it has been turned by `turn` about `middle`. */
std::string pictureOf(const Box& box, const char* kind, double turn, Point middle) {
  return std::string("<svg class=\"") + kind + "\" aria-label=\"" + kind +
         formatted("\" role=\"img\" viewBox=\"%.2f %.2f %.2f %.2f\">\n", box.low.x - 1,
                   -box.high.y - 1, box.size().x + 2, box.size().y + 2) +
         formatted("<g transform=\"rotate(%.2f %.2f %.2f)\">\n", -turn * 180 / M_PI, middle.x,
                   -middle.y);
}

/** Grey where it was driven once; else from green to red, by how far it is off. */
const char* colourOf(const CheckedPose& pose) {
  if (!pose.isSeenTwice) return "#8a929c";
  if (pose.error < 0.1) return "#1f7a3d";
  return pose.error < 0.3 ? "#b08900" : pose.error < 1 ? "#cc5a00" : "#b00020";
}

std::string mapPicture(const RunCheck& check, const Run& run) {
  std::vector<Point> walls, copies;
  const bool hasCopies = run.map.wallDoubling.value_or(0) > 0;
  for (const WallPoint& wall : run.map.walls)
    (hasCopies && hasCopy(run.map, wall) ? copies : walls).push_back(wall.place);
  const double turn = uprightTurn(run.map, 0);
  const Transform2D upright{0, 0, turn};
  Box box;
  for (const WallPoint& wall : run.map.walls) box.include(upright(wall.place));
  for (const CheckedPose& checked : check.path) box.include(upright(checked.pose.shift()));
  if (box.isEmpty()) return "";
  std::string svg =
      pictureOf(box, "map", turn, {}) + dots(walls, "#17202e", 0.1) + dots(copies, "#c44d00", 0.1);
  for (std::size_t k = 1; k < check.path.size(); ++k) {
    const Point from = check.path[k - 1].pose.shift(), to = check.path[k].pose.shift();
    svg += formatted("<path fill=\"none\" stroke-width=\".25\" d=\"M%.2f %.2fL%.2f %.2f\" ", from.x,
                     -from.y, to.x, -to.y) +
           "stroke=\"" + colourOf(check.path[k]) + "\"/>\n";
  }
  for (std::size_t i = 0; i < check.breaks.size(); ++i) {
    const Point centre = check.breaks[i].place;
    svg += formatted(
        "<circle cx=\"%.2f\" cy=\"%.2f\" r=\".8\" fill=\"none\" stroke=\"#b00020\" "
        "stroke-width=\".2\"><title>break %zu</title></circle>\n",
        centre.x, -centre.y, i + 1);
  }
  for (const DoubledPlace& place : check.doubled)
    svg += formatted(
               "<path fill=\"none\" stroke=\"#7a1fa2\" stroke-width=\".3\" d=\"M%.2f %.2fL%.2f "
               "%.2f\">",
               place.one.place.x, -place.one.place.y, place.other.place.x, -place.other.place.y) +
           "<title>" + doubledText(place) + "</title></path>\n";
  return svg + "</g></svg>\n";
}

/** What some scans have met within kScanReach of a place, moved by `motion` first. */
std::vector<Point> wallsNear(Point middle, const Run& run, const KeyFrames& range,
                             const Transform2D& motion) {
  std::vector<Point> walls;
  for (const ScanWalls& scan : run.scans) {
    if (!range.holds(scan.keyFrame)) continue;
    for (const WallPoint& wall : scan.walls)
      if (const Point moved = motion(wall.place); distance(moved, middle) < kScanReach)
        walls.push_back(moved);
  }
  return walls;
}

/** What both times of a fault have met around it, that of the later one moved by `motion`. */
std::string scansPicture(const Fault& fault, const Run& run, const Transform2D& motion) {
  const Point middle = fault.place;
  return pictureOf(Box{middle, middle}.widened(kScanReach), "scans", uprightTurn(run.map, 0),
                   middle) +
         dots(wallsNear(middle, run, fault.earlier, {}), "#0a4f8f", 0.14) +
         dots(wallsNear(middle, run, fault.later, motion), "#c44d00", 0.14) + "</g></svg>";
}

/** The same as drawn and, if that is known, as they fit. */
std::string faultHtml(const Fault& fault, const char* what, const Run& run) {
  const std::string fits = fault.mend
                               ? "</figure>\n<figure>" + scansPicture(fault, run, *fault.mend) +
                                     "<figcaption>as they fit</figcaption>"
                               : "";
  return std::string("<h3>") + what + formatted(" %zu: ", fault.number) + fault.text +
         "</h3>\n<div class=\"pair\"><figure>" + scansPicture(fault, run, {}) +
         "<figcaption>as drawn</figcaption>" + fits + "</figure></div>\n";
}

/** A section of the page: the faults of one kind. */
struct FaultSection {
  FaultKind kind;
  const char *id, *heading, *what;
  const char* none;  ///< what stands there without any; nullptr for no section at all
};

constexpr FaultSection kFaultSections[] = {
    {FaultKind::broken, "breaks", "Breaks", "Break", "No break was found."},
    {FaultKind::doubled, "doubled", "Drawn twice", "Place",
     "Of what was seen twice nothing that no break explains is drawn in two places."},
    {FaultKind::welded, "welded", "Laid over each other", "Place", nullptr}};

std::string faultsHtml(const std::vector<Fault>& faults, const FaultSection& section,
                       const Run& run) {
  std::string found;
  for (const Fault& fault : faults)
    if (fault.kind == section.kind) found += faultHtml(fault, section.what, run);
  if (found.empty() && !section.none) return "";
  return std::string("<section id=\"") + section.id + "\">\n<h2>" + section.heading + "</h2>\n" +
         (found.empty() ? std::string("<p class=\"none\">") + section.none
                        : "<p class=\"hint\">Blue is what the earlier scans have met, orange the "
                          "later ones.") +
         "</p>\n" + found + "</section>\n";
}

std::string figureText(const std::optional<double>& value, const Evidence& row) {
  if (!value) return "-";
  if (row.unit == "1") return formatted("%.1f %%", 100 * *value);
  return formatted("%.2f ", *value) + row.unit;
}

std::string evidenceHtml(const RunCheck& check) {
  std::string html =
      "<section id=\"evidence\">\n<h2>Evidence</h2>\n<table><thead><tr><th>What</th><th>As "
      "drawn</th><th>If it agreed with itself</th><th>Of</th></tr></thead><tbody>\n";
  for (const Evidence& row : check.evidence)
    html += "<tr><th scope=\"row\">" + xmlText(row.label) + "</th><td>" +
            figureText(row.drawn, row) + "</td><td>" + figureText(row.agreed, row) + "</td><td>" +
            formatted("%.0f", row.support) + "</td></tr>\n";
  return html + "</tbody></table>\n</section>\n";
}

std::string mapHtml(const RunCheck& check, const Run& run) {
  const char* path =
      "Its path: grey where it was driven once; else green where it agrees with itself within 0.1 "
      "m, then yellow to 0.3 m, orange to 1 m, red beyond. A red ring is a break, a line joins the "
      "two places of what is drawn twice. ";
  return std::string("<section id=\"site\"><h2>Map</h2>\n<p class=\"hint\">") +
         (run.scans.empty() ? "" : path) +
         "Walls in orange stand before others that face alike.</p>\n" + mapPicture(check, run) +
         "</section>\n";
}

std::string figuresHtml(const RunCheck& check) {
  const std::string error = check.selfError ? formatted("%.3f m, %.3f to %.3f m in 4 of 5 cases",
                                                        *check.selfError, check.low, check.high)
                                            : "cannot be told";
  return "<table><tbody><tr><th scope=\"row\">Self error</th><td>" + error +
         "</td></tr>\n<tr><th scope=\"row\">Seen twice</th><td>" +
         formatted("%.0f %% of its path", 100 * check.seenTwice) +
         "</td></tr>\n<tr><th scope=\"row\">Breaks</th><td>" + std::to_string(check.breaks.size()) +
         "</td></tr>\n<tr><th scope=\"row\">Places drawn twice</th><td>" +
         std::to_string(check.doubled.size()) +
         "</td></tr>\n<tr><th scope=\"row\">Places laid over others</th><td>" +
         std::to_string(check.welded.size()) + "</td></tr></tbody></table>\n";
}

std::string verdictOf(const RunCheck& check) {
  std::vector<std::string> faults;
  const auto add = [&](std::size_t count, const std::string& one, const std::string& more) {
    if (count > 0) faults.push_back(counted(count, one, more));
  };
  add(check.breaks.size(), "break", "breaks");
  add(check.doubled.size(), "place drawn twice", "places drawn twice");
  add(check.welded.size(), "place laid over another", "places laid over others");
  if (faults.empty()) return check.selfError ? "no fault found" : "cannot tell";
  return listed(faults);
}

}  // namespace

std::string checkPage(const RunCheck& check, const Run& run) {
  SimplePage page;
  page.title = xmlText(check.name) + " by itself", page.subject = "one run by itself";
  page.heading = xmlText(check.name) + ": " + verdictOf(check);
  page.counts = "It " + xmlText(check.sentence) + ".";
  page.style =
      "svg.map{width:100%;max-height:80vh;background:#fff;border:1px solid var(--line)} "
      ".pair{display:flex;gap:16px;flex-wrap:wrap} .pair figure{margin:0;flex:1 1 320px} "
      ".pair svg{width:100%;background:#fff;border:1px solid var(--line)} "
      ".dots{fill:none;stroke-linecap:round}";
  if (!run.scans.empty()) page.body = figuresHtml(check);
  page.body += mapHtml(check, run);
  const std::vector<Fault> faults = faultsOf(check);
  if (!run.scans.empty())
    for (const FaultSection& section : kFaultSections)
      page.body += faultsHtml(faults, section, run);
  page.body += evidenceHtml(check);
  page.footer = "roomgraph's docs/check.md explains the figures.";
  return simplePage(page);
}

}  // namespace roomgraph
