#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/report/faults.h"

namespace roomgraph {

/** comparison.json, as it may stand in a script element: without '<', '>' and '&', and
 *  without the folders of maps. */
std::string pageDocument(const Comparison& comparison);

/** What the scripts of the report draw and that document does not have: by how much the picture
 *  is turned to stand upright, and, so turned, the box of the site, the heat map, and colour, shape
 *  and picture of each run; also what the scans at each break met, in its order, in the frame of
 *  the site. JSON as in pageDocument. */
std::string pageData(const Comparison& comparison, const std::vector<Run>& runs);

/** "#rrggbb". */
std::string colourText(std::size_t run);

/** Shares of 0.1, for instance, as "10 %". */
std::string percentText(double share);

/** With so many digits behind the point, of the value as comparison.json holds it; "–" for
 *  nothing. */
std::string fixedText(std::optional<double> value, int digits);

/** What the scans at a break met, for a small picture [m, site frame]; at most some hundred places
 *  each, evenly. Behind it as the run's map has them. Empty where the run is not among `runs`, or
 *  has no scans. */
struct BreakScans {
  std::vector<Point> before, behind;
};
BreakScans breakScans(const Comparison& comparison, const Fault& fault,
                      const std::vector<Run>& runs);

/** RFC 4648, with padding, on one line. */
std::string base64(const std::string& bytes);

}  // namespace roomgraph
