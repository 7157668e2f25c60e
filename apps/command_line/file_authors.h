#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** The text with a first line that says who has written it, for kinds in which a line may be a
 *  comment that begins with #. */
std::string withAuthor(const std::string& text);

/** The picture that a ROS map's yaml names; empty for any other file. */
std::string pictureOf(const std::string& mapFile);

/** The ROS maps beside a picture that name it, whatever they are called. O(files there). */
std::vector<std::string> mapsWithPicture(const std::string& picture);

/** The ROS map of somebody else that has a file for its picture; empty for none. */
std::string foreignMapOf(const std::string& file);

/** Whether a file is a map or an archive, by its content. */
bool isMapOrArchive(const std::string& file);

/** Whether a file that is there may be taken for a result of this program: of the kinds that it
 *  reads (maps, logs, paths, graphs, places, lists of runs) that is one with a mark of it, or a
 *  file of places that it has carried; other kinds are told by their content. */
bool isOurs(const std::string& file);

}  // namespace roomgraph
