#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** A name for each run, all different, as UTF-8: X as in mapStem; where two files have the same,
 *  FOLDER/X; where that does not tell them apart, the file as it was given. A file that is given
 *  again, or whose name is taken all the same, gets the first of "#2" and so on that is free. The
 *  names of files do not depend on their order. */
std::vector<std::string> runNames(const std::vector<std::string>& files);

/** The one of some names that a user means who gives it or the file of that run to an option.
 *  @throws UsageError with some of the names where it is none. */
std::string nameOfRun(const std::string& given, const std::vector<std::string>& names,
                      const std::string& option);

}  // namespace roomgraph
