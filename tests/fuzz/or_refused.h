#pragma once
#include <cstdlib>

#include "refusal.h"

namespace roomgraph::test {

/** What a reader may do with a bad file: refuse it in one line. */
template <class Read>
void orRefused(const Read& read) {
  if (refusalOf(read).find('\n') != std::string::npos) std::abort();
}

}  // namespace roomgraph::test
