#pragma once
#include <string>

namespace roomgraph {

/** A coordinate as JSON text, rounded as files hold it. Most of a file is coordinates, and text
 *  written at once takes a fraction of the time of a tree of values. null where not finite. */
void addNumber(std::string& json, double value);

}  // namespace roomgraph
