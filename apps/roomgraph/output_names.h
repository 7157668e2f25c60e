#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** Where a map's results go: folder/X.extension, see mapStem. */
std::string outputFile(const std::string& folder, const std::string& mapFile,
                       const std::string& extension);

/** Whether two names are of one file, which must exist. */
bool areSameFile(const std::string& one, const std::string& other);

/** Whether two names are of one file once both are written; none need be there yet. */
bool wouldBeSameFile(const std::string& one, const std::string& other);

/** Throws UsageError where two maps have a result of the same name, or where a result would replace
 *  one of the maps, the picture that a ROS map names, or a yaml, picture, grid map or log that this
 *  program has not written. */
void checkOutputNames(const std::vector<std::string>& mapFiles, const std::string& folder,
                      const std::vector<std::string>& extensions);

}  // namespace roomgraph
