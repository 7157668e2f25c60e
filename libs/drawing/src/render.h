#pragma once
#include <string>

#include "Scene.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

/** The scene on top of the map as the bytes of a picture file. Same scene, same bytes. */
std::string renderPng(const Grid& grid, const Scene& scene);
std::string renderSvg(const Grid& grid, const Scene& scene);

/** What cairo wrote, made the same every time: it numbers the pictures and groups inside of a file
 *  by a counter of the whole process; here they get the numbers 1, 2, ... in the order in which
 *  they occur. The picture of the map also gets a hint that its cells be shown as squares. */
std::string finishedSvg(const std::string& svg);

}  // namespace roomgraph
