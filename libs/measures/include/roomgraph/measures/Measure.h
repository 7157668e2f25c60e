#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** One figure, and how far it can be trusted. */
struct Measure {
  std::string name;             ///< of a MeasureKind
  std::optional<double> value;  ///< none where nothing supports it
  std::string unit = "1";       ///< see MeasureKind
  double support = 0;           ///< how many things were counted: wall points, cells or rooms
  /** The range of the value when any one of the other runs is left out; none without a value, or
   *  with a single other run. */
  std::optional<double> low, high;
  bool isMeaningful = false;  ///< enough other runs, and enough support
  /** Where it is worst, of a figure that is of one place [m, frame of the site]. */
  std::optional<Point> place{};
};

/** The measure of this name; null for none. */
[[nodiscard]] const Measure* find(const std::vector<Measure>& measures, const std::string& name);

/** The value of the measure of this name; none where it has none. */
[[nodiscard]] std::optional<double> valueOf(const std::vector<Measure>& measures,
                                            const std::string& name);

/** The same of one that is meaningful; none of any other. */
[[nodiscard]] std::optional<double> trustedValueOf(const std::vector<Measure>& measures,
                                                   const std::string& name);

}  // namespace roomgraph
