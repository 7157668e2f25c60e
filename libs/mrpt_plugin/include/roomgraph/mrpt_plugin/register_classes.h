#pragma once

namespace roomgraph {

/** Makes the classes of this library known to MRPT, so that its streams can read them without being
 *  told which to expect. For programs that link the library: a linker may drop a library that only
 *  registers itself. May be called any number of times. */
void registerMrptClasses();

}  // namespace roomgraph
