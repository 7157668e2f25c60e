#pragma once

namespace roomgraph {

/** The style sheet of all pages. */
const char* pageStyle();

}  // namespace roomgraph
