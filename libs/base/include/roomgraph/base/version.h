#pragma once

namespace roomgraph {

/** The version of the library that is linked, as "major.minor.patch". */
[[nodiscard]] const char* version();

}  // namespace roomgraph
