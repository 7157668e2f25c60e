#include "roomgraph/compare/gate.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "roomgraph/base/Json.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/compare/record_error.h"
#include "roomgraph/relate/PairBend.h"

namespace roomgraph {
namespace {

using Lines = std::vector<std::string>;

std::string breakText(const MapBreak& found) {
  std::string text = "breaks ";
  if (found.keyFrame) text += "at key frame " + std::to_string(*found.keyFrame) + ", ";
  if (found.time) text += timeText(*found.time) + ", ";
  return text + formatted("at (%.1f, %.1f) by %.1f degrees and %.2f m (%s)", found.place.x,
                          found.place.y, std::abs(found.rotation) * 180 / M_PI, found.shift,
                          nameOf(found.kind()));
}

/** A share in percent, on the side of the limit that it is on. */
std::string shareText(const char* verb, double share, double least, const char* ofWhat) {
  const bool isEnough = share >= least;
  const double limit = 100 * least, percent = std::round(100 * share);
  return formatted("%s %.0f %% %s, %s than %.0f %%", verb,
                   isEnough ? std::max(percent, limit) : std::min(percent, limit - 1), ofWhat,
                   isEnough ? "no less" : "less", limit);
}

class Judge {
 public:
  Judge(const Comparison& comparison, const GateOptions& options)
      : comparison_(comparison), options_(options) {}

  GateVerdict verdict() {
    std::size_t judged = 0;
    for (const ComparedRun& run : comparison_.runs) {
      if (run.name == comparison_.reference || !isJudged(run.name)) continue;
      ++judged;
      judgeCopy(run), judgeScore(run), judgeError(run), judgeCoverage(run);
      judgeWalls(run), judgeConfirmed(run), judgeJitter(run), judgeBreaks(run);
    }
    for (const LeftOutRun& run : comparison_.leftOut)
      if (isJudged(run.name)) judgeLeftOut(run);
    if (judged == 0 && lines_.empty()) lines_.push_back("no run is left to be judged");
    if (comparison_.runs.size() < 2 && lines_.empty())
      lines_.push_back("nothing was compared, as one map alone was left");
    return {lines_, options_.candidates, asked(), lines_.empty() ? margins() : Lines()};
  }

 private:
  bool isJudged(const std::string& run) const {
    return options_.candidates.empty() || contains(options_.candidates, run);
  }
  bool areFew() const { return comparison_.runs.size() <= kFewestOthers; }
  bool needsError() const {
    return options_.maxError || options_.maxWorse || !options_.candidates.empty();
  }
  void complain(const std::string& run, const std::string& what) {
    lines_.push_back(run + ": " + what);
  }

  /** A figure that is `left` away from its limit, on the wrong side if that is negative. */
  void hold(const char* figure, const std::string& run, double left, const std::string& text) {
    if (left < 0) return complain(run, text);
    const auto [closest, isFirst] = closest_.insert({figure, {left, run + ": " + text}});
    if (!isFirst && left < closest->second.first) closest->second = {left, run + ": " + text};
  }

  /** Last night's map, handed in again, says nothing of tonight's drive. */
  void judgeCopy(const ComparedRun& run) {
    if (options_.candidates.empty()) return;
    for (const Lines& names : comparison_.copies()) {
      if (!contains(names, run.name)) continue;
      for (const std::string& other : names)
        if (!isJudged(other))
          return complain(run.name, "is a copy of " + other + ", which is of the record");
    }
  }

  /** Says of a figure that nothing backs why it cannot be told. */
  void complainOfDoubt(const ComparedRun& run, const char* figure) {
    std::string fault = comparison_.faultOf(run);
    if (fault.empty()) fault = areFew() ? "that takes two other maps" : "too little to compare";
    complain(run.name, std::string(figure) + " cannot be told: " + fault);
  }

  void judgeScore(const ComparedRun& run) {
    if (!options_.minScore) return;
    if (!trustedError(run)) return complainOfDoubt(run, "its score");
    const double left = run.score->score - *options_.minScore;
    hold("score", run.name, left,
         formatted("its score of %.1f is %.1f %s %.4g", run.score->score, std::abs(left),
                   left < 0 ? "below" : "above", *options_.minScore));
  }

  /** No map passes for want of a figure that takes two others. */
  void complainIfUntold(const ComparedRun& run, const char* measure, const char* figure) {
    if (trustedValueOf(run.measures, measure)) return;
    if (areFew() || !trustedError(run)) complainOfDoubt(run, figure);
  }

  void judgeCoverage(const ComparedRun& run) {
    if (!options_.failsOnCoverage) return;
    const Measure* coverage = find(run.measures, "coverage");
    if (!coverage || !coverage->value ||
        (!coverage->isMeaningful && *coverage->value >= kNearlyAll))
      return complainIfUntold(run, "coverage", "its coverage");
    const double value = *coverage->value;
    hold("coverage", run.name, value - kNearlyAll,
         shareText("has seen", value, kNearlyAll, "of what at least two runs have seen"));
  }

  /** A run without a score, of which nothing is borne out, has to be told so by another figure. */
  void judgeConfirmed(const ComparedRun& run) {
    if (!options_.failsOnUnconfirmed) return;
    const std::string fault = run.unconfirmedFault();
    if (!fault.empty()) return complain(run.name, fault);
    if (!run.score) return;
    const double confirmed = run.score->confirmed;
    hold("confirmed", run.name, confirmed - kNearlyAll,
         shareText("is confirmed by others in", confirmed, kNearlyAll, "of what it has drawn"));
  }

  /** A run that is smeared breaks at each of its key frames. */
  void judgeJitter(const ComparedRun& run) {
    if (options_.failsOnBreaks && run.score && run.score->jitter >= kSmeared)
      complain(
          run.name,
          formatted("is smeared: its key frames are off by %.2f m, independently of each other",
                    run.score->jitter));
  }

  /** A share that must not be larger than `most`, in per cent with so many decimals. */
  void judgeShare(const ComparedRun& run, const char* name, double most, int decimals,
                  const std::string& verb, const char* ofWhat) {
    const Measure* measure = find(run.measures, name);
    if (!measure || !measure->isMeaningful) return;
    if (!measure->place && verb != "lacks") return;  // nothing is added
    const double left = most - rounded(*measure->value), step = std::pow(10, -decimals);
    // Of the figure as it is written, one sees on which side of the limit it is.
    const double percent = std::max(left < 0 ? 100 * most + step : 0, 100 * (most - left));
    const std::string place = measure->place ? formatted(" round (%.1f, %.1f) where",
                                                         measure->place->x, measure->place->y)
                                             : "";
    hold(name, run.name, left,
         verb + place + formatted(" %.*f %% of ", decimals, percent) + ofWhat +
             formatted(", %s than %.0f %%", left < 0 ? "more" : "no more", 100 * most));
  }

  void judgeWalls(const ComparedRun& run) {
    if (!options_.failsOnWalls) return;
    complainIfUntold(run, "walls_missing", "what walls it lacks");
    judgeShare(run, "walls_missing", kMostMissing, 0, "lacks", "the walls that two others have");
    judgeShare(run, "walls_added", kMostAdded, 0, "has a place",
               "the walls stand in free space of the others");
    judgeShare(run, "straight_walls_added", kMostStraightAdded, 1, "has a place",
               "the walls are straight and stand in free space of the others");
    judgeSharpness(run);
  }

  /** Thinned to dots, or drawn thicker: the edge of free space tells, by how the others have it;
   *  not by a reference, which may be a plan with walls that no robot looks into. */
  void judgeSharpness(const ComparedRun& run) {
    const auto sharpness = [](const ComparedRun& of) {
      return trustedValueOf(of.measures, "wall_sharpness");
    };
    std::vector<double> others;
    for (const ComparedRun& other : comparison_.runs) {
      if (other.name == run.name || other.name == comparison_.reference) continue;
      if (const auto value = sharpness(other)) others.push_back(*value);
    }
    const auto own = sharpness(run);
    if (!own || others.size() < kFewestOthers) return;
    const std::string fault = sharpnessFault(*own, median(others));
    if (!fault.empty()) complain(run.name, "its walls " + fault);
  }

  /** The largest first. */
  void judgeBreaks(const ComparedRun& run) {
    for (const MapBreak& found : comparison_.breaks)
      if (options_.failsOnBreaks && found.run == run.name && found.kind() != BreakClass::slight)
        complain(run.name, breakText(found));
  }

  void judgeError(const ComparedRun& run) {
    if (!needsError()) return;
    if (comparison_.isScaleUsual())
      return complain(run.name,
                      "its map error cannot be told in metres, as no map tells its scale: give "
                      "--resolution");
    const auto error = trustedError(run);
    if (!error) return complainOfDoubt(run, "its map error");
    if (options_.maxError) judgeMetres(run, *options_.maxError);
    if (!options_.maxWorse) return;
    const auto record = recordError(comparison_, run.name, options_.candidates);
    if (!record) return complain(run.name, "there is no other run to hold it against");
    const double more = *error - record->error, left = *options_.maxWorse - more;
    const char* ofWhat = record->runs == 1   ? "that of the best other"
                         : record->runs == 2 ? "the median of the two best others"
                                             : "the median of the three best others";
    hold("record", run.name, left,
         formatted("its map error of %.3f m is %.3f m %s than %s (limit: %.4g m)", *error,
                   std::abs(more), more < 0 ? "less" : "more", ofWhat, *options_.maxWorse));
  }

  /** A run that may lie in the wrong place may be as far off as its interval reaches. */
  void judgeMetres(const ComparedRun& run, double most) {
    const bool isDoubtful = comparison_.certaintyOf(run) == Certainty::doubtful;
    const double error = run.score->mapError, high = run.score->errorHigh;
    const double left = most - (isDoubtful ? high : error);
    const std::string text =
        isDoubtful ? formatted("is %.3f m, but doubtful: it may be %.3f m,", error, high)
                   : formatted("of %.3f m is", error);
    hold("error", run.name, left,
         "its map error " + text +
             formatted(" %.3f m %s %.4g m", std::abs(left), left < 0 ? "above" : "below", most));
  }

  void judgeLeftOut(const LeftOutRun& run) {
    if (options_.minScore) complain(run.name, "has no score");
    // The reason tells a mirrored map, or one of another storey, from one of another building.
    if (run.isOtherSite && (options_.failsOnOtherSites || needsError()))
      complain(run.name, "is not of the same site (" + run.reason + ")");
    else if (needsError())
      complain(run.name, "could not be read");
  }

  Lines limits() const {
    Lines lines;
    if (options_.minScore) lines.push_back(formatted("score at least %.4g", *options_.minScore));
    if (options_.maxError)
      lines.push_back(formatted("map error at most %.4g m", *options_.maxError));
    if (options_.maxWorse)
      lines.push_back(
          formatted("map error at most %.4g m above the median of the three best others",
                    *options_.maxWorse));
    for (const auto& [isAsked, what] : {std::pair(options_.failsOnCoverage, "enough coverage"),
                                        {options_.failsOnBreaks, "no break that is not slight"},
                                        {options_.failsOnUnconfirmed, "a map that others confirm"},
                                        {options_.failsOnOtherSites, "the same site"},
                                        {options_.failsOnWalls, "walls as the others have them"}})
      if (isAsked) lines.emplace_back(what);
    return lines;
  }
  Lines asked() const {
    const Lines lines = limits();
    return lines.empty() ? Lines{"a map error that can be told"} : lines;
  }

  /** Of each figure the run that came closest to its limit. */
  Lines margins() const {
    if (limits().empty())
      return mapped(options_.candidates, [](const std::string& run) {
        return run + ": no limit is set, so any map that can be judged passes";
      });
    return mapped(closest_, [](const auto& figure) { return figure.second.second; });
  }

  const Comparison& comparison_;
  const GateOptions& options_;
  Lines lines_;
  std::map<std::string, std::pair<double, std::string>> closest_;  // by figure: what is left, text
};

}  // namespace

std::string sharpnessFault(double own, double usual) {
  const bool areThin = own * kMostThinned < usual, areThick = usual * kMostThinned < own;
  if (!areThin && !areThick) return "";
  return formatted(
      "are too %s: %.2f cells of wall for each cell at the edge of free space (wall_sharpness), "
      "where the others have %.2f",
      areThin ? "thin" : "thick", own, usual);
}

GateVerdict gateVerdict(const Comparison& comparison, const GateOptions& options) {
  if (options.asksNothing()) return {};
  return Judge(comparison, options).verdict();
}

}  // namespace roomgraph
