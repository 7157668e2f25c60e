#pragma once
#include <set>
#include <string>

namespace roomgraph {

/** The name of a run as part of that of a file, another one than those that are taken: names may be
 *  paths, and YAML and TOML have signs of their own. */
std::string fileWord(const std::string& name, std::set<std::string>& taken);

}  // namespace roomgraph
