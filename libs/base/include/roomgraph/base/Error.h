#pragma once
#include <stdexcept>

namespace roomgraph {

/** What a file holds cannot be used. what() is one plain line: file, problem, remedy. */
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** What the caller asked for cannot be done. what() is one plain line: what, which value, what
 *  would do. */
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace roomgraph
