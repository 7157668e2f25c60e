#pragma once
#include <string>

#include "roomgraph/base/Error.h"

namespace roomgraph::test {

/** What the user is told where a call throws an `Error`; empty where it does not. */
template <class Error = DataError, class Call>
std::string refusalOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace roomgraph::test
