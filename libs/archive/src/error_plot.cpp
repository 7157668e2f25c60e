#include "error_plot.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/base/xml_text.h"

namespace roomgraph {
namespace {

constexpr double kPlotWidth = 1000, kPlotHeight = 260;  // of the picture [px], as all that follows
constexpr double kLeft = 56, kRight = 16, kTop = 14, kBottom = 30;
constexpr double kSparkWidth = 120, kSparkHeight = 24;

/** A run that can be judged. */
struct Dot {
  double time = 0, error = 0, low = 0, high = 0;
  bool isTorn = false, isLastGood = false;
  std::string title;
};

std::vector<Dot> dotsOf(const WatchedSite& site, const RobotWatch& robot) {
  std::vector<Dot> dots;
  for (const std::size_t i : robot.runs) {
    const HistoryRun& run = site.history.runs[i];
    const Measure* error = find(run.figures, kMapError);
    Dot dot;
    dot.time = run.time, dot.error = *error->value;
    dot.low = error->low.value_or(dot.error), dot.high = error->high.value_or(dot.error);
    dot.isTorn = trustedValueOf(run.figures, kBreaks).value_or(0) > 0;
    dot.isLastGood = robot.lastGood == i;
    dot.title = timeText(run.time) + formatted(": %.3f m", dot.error) +
                (dot.isTorn ? ", with a break" : "") + "; " + fileName(run.file);
    dots.push_back(dot);
  }
  return dots;
}

/** From times and errors to the picture. */
struct Scales {
  double first = 0, last = 1, most = 1;

  double x(double time) const {
    return kLeft + (kPlotWidth - kLeft - kRight) * (time - first) / (last - first);
  }
  double y(double error) const {
    const double share = std::clamp(error / most, 0.0, 1.0);
    return kPlotHeight - kBottom - (kPlotHeight - kTop - kBottom) * share;
  }
};

/** The least of 1, 2 and 5 times a power of ten that is not below the value. */
double niceStep(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= value * (1 - 1e-9)) return step * power;
  return 10 * power;
}

/** A few bad nights do not make all others small. */
Scales scalesOf(const std::vector<Dot>& dots, const WatchOptions& options) {
  Scales scales;
  scales.first = dots.front().time, scales.last = dots.back().time;
  if (scales.last - scales.first < kDay)
    scales.first -= kDay / 2, scales.last = scales.first + kDay;
  const double typical = quantile(mapped(dots, &Dot::error), 0.9);
  const double most = std::max(1.3 * options.limit, 1.4 * typical);
  const double step = niceStep(most / 4);
  scales.most = step * std::ceil(most / step);
  return scales;
}

std::string line(double x1, double y1, double x2, double y2, const char* style) {
  return formatted("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" style=\"%s\"/>", x1, y1,
                   x2, y2, style);
}

std::string axes(const Scales& scales) {
  std::string svg;
  const double step = niceStep(scales.most / 4);
  for (int k = 0; k * step <= scales.most * (1 + 1e-9); ++k) {
    const double error = k * step, y = scales.y(error);
    svg += line(kLeft, y, kPlotWidth - kRight, y, "stroke:var(--grid)");
    svg += formatted("<text class=\"tick\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">%g m</text>",
                     kLeft - 8, y + 4, std::round(error * 1e6) / 1e6);
  }
  const double days = (scales.last - scales.first) / kDay;
  constexpr int kMostSteps = 6;  // so many at any time, even where a day more makes no difference
  const double apart = std::max(1.0, std::ceil(days / kMostSteps));
  const double firstDay = std::ceil(scales.first / kDay);
  for (int k = 0; k <= kMostSteps && (firstDay + k * apart) * kDay <= scales.last; ++k) {
    const double time = (firstDay + k * apart) * kDay;
    svg += formatted("<text class=\"tick\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%s</text>",
                     std::clamp(scales.x(time), kLeft + 20, kPlotWidth - 50), kPlotHeight - 8,
                     dayText(time).c_str());
  }
  return svg;
}

std::string dotMark(const Dot& dot, const Scales& scales) {
  const double x = scales.x(dot.time), y = scales.y(dot.error);
  std::string svg = "<g><title>" + xmlText(dot.title) + "</title>";
  svg += line(x, scales.y(dot.low), x, scales.y(dot.high), "stroke:var(--accent);opacity:.35");
  const char* colour = dot.isTorn ? "var(--alarm)" : "var(--accent)";
  if (dot.isLastGood)
    svg += formatted(
        "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"8\" style=\"fill:none;stroke:var(--ink);"
        "stroke-width:1.5\"/>",
        x, y);
  if (dot.error > scales.most)
    svg += formatted("<path d=\"M%.1f %.1fl5 9h-10z\" style=\"fill:%s\"/>", x, y, colour);
  else if (dot.isTorn)
    svg += formatted("<path d=\"M%.1f %.1fl8 8m0 -8l-8 8\" style=\"stroke:%s;stroke-width:2.5\"/>",
                     x - 4, y - 4, colour);
  else
    svg += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" style=\"fill:%s\"/>", x, y, colour);
  return svg + "</g>";
}

/** The limit, the trend of the window and the change. */
std::string judgements(const std::vector<Dot>& dots, const Scales& scales, const ErrorWatch& watch,
                       const WatchOptions& options) {
  const double limit = scales.y(options.limit);
  std::string svg =
      line(kLeft, limit, kPlotWidth - kRight, limit, "stroke:var(--alarm);stroke-dasharray:6 4") +
      formatted("<text class=\"note\" x=\"%.1f\" y=\"%.1f\">limit</text>", kLeft + 2, limit - 5);
  if (watch.slope && watch.isDeclining) {
    const Dot& first = dots[dots.size() - std::min(kDeclineNights, dots.size())];
    svg += line(scales.x(first.time), scales.y(watch.slope->at(first.time / kDay)),
                scales.x(dots.back().time), scales.y(watch.slope->at(dots.back().time / kDay)),
                "stroke:var(--ink);stroke-width:2");
  }
  if (watch.change && watch.isChanged) {
    const double x = scales.x(dots[watch.change->first].time);
    svg += line(x, kTop, x, kPlotHeight - kBottom, "stroke:var(--ink);stroke-dasharray:2 3");
    svg += formatted("<text class=\"note\" x=\"%.1f\" y=\"%.1f\">worse since</text>", x + 5,
                     kTop + 10);
  }
  return svg;
}

}  // namespace

std::string errorPlot(const WatchedSite& site, const RobotWatch& robot,
                      const WatchOptions& options) {
  const std::vector<Dot> dots = dotsOf(site, robot);
  if (dots.empty()) return "";
  const Scales scales = scalesOf(dots, options);
  std::string svg = formatted(
      "<svg viewBox=\"0 0 %g %g\" width=\"%g\" height=\"%g\" role=\"img\" "
      "aria-label=\"Map errors over time\">",
      kPlotWidth, kPlotHeight, kPlotWidth, kPlotHeight);
  svg += axes(scales) + judgements(dots, scales, robot.errors, options);
  for (const Dot& dot : dots) svg += dotMark(dot, scales);
  return svg + "</svg>";
}

std::string errorSparkline(const WatchedSite& site, const RobotWatch& robot,
                           const WatchOptions& options) {
  const std::vector<Dot> dots = dotsOf(site, robot);
  if (dots.empty()) return "";
  const Scales scales = scalesOf(dots, options);
  const double wide = kSparkWidth / (kPlotWidth - kLeft - kRight);
  const double high = kSparkHeight / (kPlotHeight - kTop - kBottom);
  const auto y = [&](double error) { return high * (scales.y(error) - kTop); };
  std::string svg = formatted(
      "<svg viewBox=\"0 -2 %g %g\" width=\"%g\" height=\"%g\" "
      "aria-hidden=\"true\">",
      kSparkWidth, kSparkHeight + 4, kSparkWidth, kSparkHeight + 4);
  svg += line(0, y(options.limit), kSparkWidth, y(options.limit),
              "stroke:var(--alarm);stroke-dasharray:3 3");
  svg += "<polyline style=\"fill:none;stroke:var(--accent);stroke-width:1.5\" points=\"";
  for (const Dot& dot : dots)
    svg += formatted("%.1f,%.1f ", wide * (scales.x(dot.time) - kLeft), y(dot.error));
  svg += "\"/>";
  if (dots.size() == 1)  // no line
    svg += formatted("<circle cx=\"%g\" cy=\"%.1f\" r=\"2.5\" style=\"fill:var(--accent)\"/>",
                     kSparkWidth / 2, y(dots[0].error));
  return svg + "</svg>";
}

}  // namespace roomgraph
