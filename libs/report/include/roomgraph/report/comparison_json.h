#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// In:   Comparison
// Out:  text of files, and a table
// Next: a file

/** JSON of format "roomgraph/comparison", version 1; see the schema in share/roomgraph/schema. What
 *  cannot be told is null. Numbers are rounded to 0.0001, resolutions to 0.000001. File names
 *  without their folder.
 *
 *      writeFileAtomically("comparison.json", comparisonJson(compareMaps(files, {})));
 *      const Comparison again = readComparison("comparison.json");
 */
[[nodiscard]] std::string comparisonJson(const Comparison& comparison);

/** The comparison of such a text: comparisonJson of it is the same text again, but for the version
 *  of the program. Fields that it does not know are skipped.
 *  @throws DataError with one line (`name` of the file, place, problem, remedy) where it is no such
 *  file, or damaged. */
[[nodiscard]] Comparison parseComparisonJson(const std::string& text, const std::string& name);

/** The same of a file. @throws DataError also where it cannot be read. */
[[nodiscard]] Comparison readComparison(const std::string& file);

/** The ranking, a line per run, then each scale that was estimated, and a line on the rooms, for
 *  people. */
[[nodiscard]] std::string comparisonText(const Comparison& comparison);

}  // namespace roomgraph
