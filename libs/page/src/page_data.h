#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** What the scripts of the report draw: runs with their pictures, heat map, rooms and breaks. JSON
 *  that may stand in a script element: it holds no '<', '>' or '&'. */
std::string pageData(const Comparison& comparison, const std::vector<Run>& runs);

/** "#rrggbb". */
std::string colourText(std::size_t run);

/** Shares of 0.1, for instance, as "10 %". */
std::string percentText(double share);

/** With so many digits behind the point; "–" for nothing. */
std::string fixedText(std::optional<double> value, int digits);

}  // namespace roomgraph
