#pragma once
#include <string>

#include "Scene.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

/** The scene on top of the map as the bytes of a picture file. Same scene, same bytes. */
std::string renderPng(const Grid& grid, const Scene& scene);
std::string renderSvg(const Grid& grid, const Scene& scene);

}  // namespace roomgraph
