#include "roomgraph/page/check_page.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/xml_text.h"
#include "roomgraph/breaks/frames_at_break.h"
#include "roomgraph/page/simple_page.h"
#include "roomgraph/report/run_check_json.h"

namespace roomgraph {
namespace {

constexpr double kScanReach = 12;  // walls that are shown at a break, from it [m]
constexpr const char* kCheckStyle =
    "svg.map{width:100%;max-height:80vh;background:#fff;border:1px solid var(--line)} "
    ".pair{display:flex;gap:16px;flex-wrap:wrap} .pair figure{margin:0;flex:1 1 320px} "
    ".pair svg{width:100%;background:#fff;border:1px solid var(--line)} "
    ".dots{fill:none;stroke-linecap:round}";

/** Places as dots of a path; y is up in maps and down in pictures. */
std::string dots(const std::vector<Point>& places, const char* colour, double size) {
  std::string path;
  for (const Point p : places) path += formatted("M%.2f %.2fh0", p.x, -p.y);
  return std::string("<path class=\"dots\" stroke=\"") + colour +
         formatted("\" stroke-width=\"%.2f\" d=\"", size) + path + "\"/>\n";
}

std::string pictureOf(Point low, Point high, const char* kind) {
  return std::string("<svg class=\"") + kind +
         formatted("\" role=\"img\" viewBox=\"%.2f %.2f %.2f %.2f\">\n", low.x - 1, -high.y - 1,
                   high.x - low.x + 2, high.y - low.y + 2);
}

/** Grey where it was driven once; else from green to red, by how far it is off. */
const char* colourOf(const CheckedPose& at) {
  if (!at.isSeenTwice) return "#8a929c";
  if (at.error < 0.1) return "#1f7a3d";
  return at.error < 0.3 ? "#b08900" : at.error < 1 ? "#cc5a00" : "#b00020";
}

std::string mapPicture(const RunCheck& check, const Run& run) {
  std::vector<Point> walls;
  for (const WallPoint& wall : run.map.walls) walls.push_back(wall.place);
  Point low{1e9, 1e9}, high{-1e9, -1e9};
  const auto include = [&](Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  };
  for (const Point wall : walls) include(wall);
  for (const CheckedPose& at : check.path) include(at.pose.shift());
  if (low.x > high.x) return "";
  std::string svg = pictureOf(low, high, "map") + dots(walls, "#17202e", 0.1);
  for (std::size_t k = 1; k < check.path.size(); ++k) {
    const Point from = check.path[k - 1].pose.shift(), to = check.path[k].pose.shift();
    svg += formatted("<path fill=\"none\" stroke-width=\".25\" d=\"M%.2f %.2fL%.2f %.2f\" ", from.x,
                     -from.y, to.x, -to.y) +
           "stroke=\"" + colourOf(check.path[k]) + "\"/>\n";
  }
  for (std::size_t i = 0; i < check.breaks.size(); ++i) {
    const Point at = check.breaks[i].place;
    svg += formatted(
        "<circle cx=\"%.2f\" cy=\"%.2f\" r=\".8\" fill=\"none\" stroke=\"#b00020\" "
        "stroke-width=\".2\"><title>break %zu</title></circle>\n",
        at.x, -at.y, i + 1);
  }
  return svg + "</svg>\n";
}

/** The scans at a break, those behind it moved by `motion`. */
std::string scansPicture(const MapBreak& tear, const Run& run, const Transform2D& motion) {
  const FramesAtBreak frames = framesAtBreak(tear, run.scans);
  std::vector<Point> before, behind;
  for (std::size_t k = frames.first; k < frames.end; ++k)
    for (const WallPoint& wall : run.scans[k].walls) {
      const Point at = k < frames.behind ? wall.place : motion(wall.place);
      if (distance(at, tear.place) < kScanReach)
        (k < frames.behind ? before : behind).push_back(at);
    }
  const Point reach{kScanReach, kScanReach};
  return pictureOf(tear.place - reach, tear.place + reach, "scans") +
         dots(before, "#0a4f8f", 0.14) + dots(behind, "#c44d00", 0.14) + "</svg>";
}

std::string breakHtml(const MapBreak& tear, std::size_t number, const Run& run) {
  const std::string fits = tear.torn ? "</figure>\n<figure>" +
                                           scansPicture(tear, run, tear.torn->mend()) +
                                           "<figcaption>as they fit</figcaption>"
                                     : "";
  return formatted("<h3>Break %zu: ", number) + selfBreakText(tear) + "</h3>\n" +
         "<div class=\"pair\"><figure>" + scansPicture(tear, run, {}) +
         "<figcaption>as drawn</figcaption>" + fits + "</figure></div>\n";
}

std::string breaksHtml(const RunCheck& check, const Run& run) {
  std::string html = "<section id=\"breaks\">\n<h2>Breaks</h2>\n";
  if (check.breaks.empty())
    return html +
           "<p class=\"none\">Of the steps from scan to scan none is contradicted.</p>\n"
           "</section>\n";
  html +=
      "<p class=\"hint\">Blue is what the scans ahead of the break have met, orange those behind "
      "it.</p>\n";
  for (std::size_t i = 0; i < check.breaks.size(); ++i)
    html += breakHtml(check.breaks[i], i + 1, run);
  return html + "</section>\n";
}

std::string figuresHtml(const RunCheck& check) {
  const std::string error = check.selfError ? formatted("%.3f m, %.3f to %.3f m in 4 of 5 cases",
                                                        *check.selfError, check.low, check.high)
                                            : "cannot be told";
  return "<table><tbody><tr><th scope=\"row\">Self error</th><td>" + error +
         "</td></tr>\n<tr><th scope=\"row\">Seen twice</th><td>" +
         formatted("%.0f %% of its path", 100 * check.seenTwice) +
         "</td></tr>\n<tr><th scope=\"row\">Breaks</th><td>" + std::to_string(check.breaks.size()) +
         "</td></tr></tbody></table>\n";
}

}  // namespace

std::string checkPage(const RunCheck& check, const Run& run) {
  SimplePage page;
  page.title = xmlText(check.name) + " by itself", page.subject = "one run by itself";
  page.heading = xmlText(check.name), page.counts = "It " + xmlText(check.sentence) + ".";
  page.style = kCheckStyle;
  page.body =
      figuresHtml(check) +
      "<section id=\"site\"><h2>Map</h2>\n<p class=\"hint\">Its path: grey where it was driven "
      "once; else green where it agrees with itself within 0.1 m, then yellow to 0.3 m, orange "
      "to 1 m, red beyond. A ring is a break.</p>\n" +
      mapPicture(check, run) + "</section>\n" + breaksHtml(check, run);
  page.footer = "What the figures mean stands in roomgraph's docs/check.md.";
  return simplePage(page);
}

}  // namespace roomgraph
