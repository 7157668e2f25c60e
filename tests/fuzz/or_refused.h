#pragma once
#include <cstdlib>
#include <string>

#include "roomgraph/base/Error.h"

namespace roomgraph::test {

/** What a reader may do with a bad file: refuse it in one line. */
template <class Read>
void orRefused(const Read& read) {
  try {
    read();
  } catch (const DataError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
}

}  // namespace roomgraph::test
