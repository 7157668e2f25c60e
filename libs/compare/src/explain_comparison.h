#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** What speaks against a run, one line. */
std::string reasonOf(const ComparedRun& run, const Comparison& comparison);

/** One line on all runs, ranked. */
std::string verdictOf(const Comparison& comparison);

/** A sentence, with a space before it, on sites of which only the first was compared: the names of
 *  the runs of each. */
std::string otherSitesNote(const std::vector<std::vector<std::string>>& sites);

/** The same on runs that have drawn the site larger, by `ratio`, than others have. */
std::string scalesNote(const std::vector<std::string>& larger,
                       const std::vector<std::string>& smaller, double ratio);

/** The same on runs that share the scans of one drive. */
std::string sharedDriveNote(const std::vector<std::string>& names, std::size_t runsOfSite);

/** The same on copies of a map and edits of a picture. */
std::string copiesNote(const Comparison& comparison);

/** The same on runs whose drives are not known, as they have no scans. */
std::string unknownDrivesNote(std::size_t runsWithoutScans, std::size_t runsOfSite);

/** The same on pictures of which no map tells the scale. */
std::string usualScaleNote(const Comparison& comparison);

}  // namespace roomgraph
