#include "draw_frame.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace roomgraph {
namespace {

constexpr int kFrameMargin = 20, kTitleHeight = 58, kMinWidth = 560;
constexpr double kTitlePx = 18, kTextPx = 12.5;
constexpr double kRowPx = 24, kSymbolPx = 26, kGapPx = 22;
constexpr double kScreenPx = 900;  // of the longer side, as much as a screen shows

using Cairo = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

/** Text is measured before there is a sheet to draw on. */
Cairo scratch() {
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
  Cairo cairo(cairo_create(surface), cairo_destroy);
  cairo_surface_destroy(surface);
  return cairo;
}

/** The whole line, or as much of it as fits, without cutting a UTF-8 character. */
std::string shortened(const Pen& pen, std::string line, double sizePx, bool isBold, double width) {
  if (pen.textWidth(line, sizePx, isBold) <= width) return line;
  while (!line.empty() && pen.textWidth(line + "…", sizePx, isBold) > width) {
    while (line.size() > 1 && (std::uint8_t(line.back()) & 0xc0u) == 0x80) line.pop_back();
    line.pop_back();
  }
  return line + "…";
}

/** By how much words are larger than said above, so that they can be read where a large picture is
 *  made as small as a screen. */
double enlarged(const View& view) {
  return std::max(1.0, std::max(view.widthPx(), view.heightPx()) / kScreenPx);
}

double scaleBarLength(const View& view) {
  return roundLength(std::clamp(0.22 * view.widthPx(), 60.0, 220.0 * enlarged(view)) /
                     view.pxPerMetre());
}

std::string metresText(double metres) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  if (metres < 0.01)
    text << metres * 1000 << " mm";
  else if (metres < 1)
    text << metres * 100 << " cm";
  else
    text << metres << " m";
  return text.str();
}

void drawScaleBar(const Pen& pen, Point place) {
  const double metres = scaleBarLength(pen.view());
  const double width = metres * pen.view().pxPerMetre(), large = enlarged(pen.view());
  cairo_t* cairo = pen.cairo();
  pen.ink(ink::text);
  cairo_move_to(cairo, place.x, place.y - 4);
  cairo_line_to(cairo, place.x, place.y + 4);
  cairo_move_to(cairo, place.x, place.y);
  cairo_line_to(cairo, place.x + width, place.y);
  cairo_move_to(cairo, place.x + width, place.y - 4);
  cairo_line_to(cairo, place.x + width, place.y + 4);
  pen.stroke(1.6);
  pen.text(metresText(metres), {place.x + width + 8 * large, place.y + 4.5 * large},
           kTextPx * large, true, Pen::Align::left);
}

void drawTitle(const Pen& pen, const Scene& scene, const Layout& layout) {
  const double width = layout.width - 2 * kFrameMargin, large = enlarged(pen.view());
  const auto line = [&](const std::string& words, double sizePx, bool isBold, double below) {
    pen.text(shortened(pen, words, sizePx * large, isBold, width),
             {kFrameMargin, kFrameMargin + below * large}, sizePx * large, isBold,
             Pen::Align::left);
  };
  pen.ink(ink::text);
  line(scene.title, kTitlePx, true, 14);
  pen.ink(ink::quiet);
  line(scene.subtitle, kTextPx, false, 36);
}

/** The symbol is drawn for words as small as said above. */
void drawLegendItem(const Pen& pen, const LegendItem& item, Point place) {
  const double large = enlarged(pen.view());
  cairo_t* cairo = pen.cairo();
  cairo_save(cairo);
  cairo_translate(cairo, place.x, place.y);
  cairo_scale(cairo, large, large);
  item.symbol(pen, {});
  pen.ink(ink::text);
  pen.text(item.label, {kSymbolPx - 11, 4.5}, kTextPx, false, Pen::Align::left);
  cairo_restore(cairo);
}

}  // namespace

double roundLength(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double step : {5.0, 2.0})
    if (step * power <= length) return step * power;
  return power;
}

Layout layoutOf(const Scene& scene, const View& view) {
  Layout layout;
  layout.width = std::max(kMinWidth, view.widthPx() + 2 * kFrameMargin);
  const int left = (layout.width - view.widthPx()) / 2;  // whole pixels
  const double large = enlarged(view), row = std::round(kRowPx * large);
  layout.map = {double(left), kFrameMargin + std::round((kTitleHeight - 6) * large)};
  const Cairo cairo = scratch();
  const Pen pen(cairo.get(), view);
  const double right = layout.width - kFrameMargin;
  Point next{kFrameMargin, layout.map.y + view.heightPx() + row};
  layout.scaleBar = {next.x + 1, next.y};
  const double metres = scaleBarLength(view);
  next.x += metres * view.pxPerMetre() + 8 * large +
            pen.textWidth(metresText(metres), kTextPx * large, true) + 1.5 * kGapPx * large;
  for (const LegendItem& item : scene.legend) {
    const double width = large * (kSymbolPx + pen.textWidth(item.label, kTextPx, false));
    if (next.x + width > right && next.x > kFrameMargin) next = {kFrameMargin, next.y + row};
    layout.legend.push_back({next.x + 9 * large, next.y});
    next.x += width + kGapPx * large;
  }
  layout.height = int(next.y) + kFrameMargin;
  return layout;
}

void drawFrame(cairo_t* cairo, const Scene& scene, const View& view, const Layout& layout) {
  const Pen pen(cairo, view);
  drawTitle(pen, scene, layout);
  cairo_rectangle(cairo, layout.map.x - 0.5, layout.map.y - 0.5, view.widthPx() + 1,
                  view.heightPx() + 1);
  pen.ink(ink::rule);
  pen.stroke(1);
  drawScaleBar(pen, layout.scaleBar);
  for (std::size_t i = 0; i < scene.legend.size(); ++i)
    drawLegendItem(pen, scene.legend[i], layout.legend[i]);
}

}  // namespace roomgraph
