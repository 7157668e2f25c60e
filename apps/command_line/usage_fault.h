#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace roomgraph {

/** Which command or option there is not, and which was most likely meant; what CLI11 says of any
 *  other fault of the call. */
std::string usageFault(const CLI::App& app, const std::vector<std::string>& arguments,
                       const CLI::ParseError& error);

}  // namespace roomgraph
