#pragma once
#include <stdexcept>
#include <string>

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

/** What `get` returns; empty, or false, where it throws a DataError. */
template <class Get>
[[nodiscard]] auto orNothing(const Get& get) -> decltype(get()) {
  try {
    return get();
  } catch (const DataError&) {
    return {};
  }
}

/** Throws the DataError "file: problem: remedy" as one printable line. */
[[noreturn]] void refuse(const std::string& file, const std::string& problem,
                         const std::string& remedy);

}  // namespace roomgraph
