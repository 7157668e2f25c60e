#pragma once

namespace roomgraph {

/** Gives memory that is free, but lies between what is in use, back to the system: after work that
 *  took much more than what is kept of it. Does nothing where the C library has no way to. About a
 *  millisecond. */
void returnMemory();

}  // namespace roomgraph
