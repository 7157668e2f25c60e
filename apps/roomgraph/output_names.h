#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** The X of the output files: the file's name without its folder, ".gz" and then the extension of a
 *  map: "a.simplemap.gz" gives "a", "odd.name.gridmap" gives "odd.name", "scan.dat" stays. */
std::string outputStem(const std::string& mapFile);

/** Where a map's results go: folder/X.extension. */
std::string outputFile(const std::string& folder, const std::string& mapFile,
                       const std::string& extension);

/** Whether two names are of one file, which must exist. */
bool areSameFile(const std::string& one, const std::string& other);

/** Whether two names are of one file once both are written; none need be there yet. */
bool wouldBeSameFile(const std::string& one, const std::string& other);

/** Throws UsageError where two maps have a result of the same name, or where a result would replace
 *  one of the maps, or the picture that a ROS map names. */
void checkOutputNames(const std::vector<std::string>& mapFiles, const std::string& folder,
                      const std::vector<std::string>& extensions);

/** Makes the folder if it is not there. Throws DataError where files cannot be written to it. */
void makeWritableFolder(const std::string& folder);

}  // namespace roomgraph
