#pragma once
#include <functional>
#include <optional>
#include <string>

namespace roomgraph {

/** Where pairs are kept from call to call, as pairBytes under a name that stands for both maps and
 *  the hub. Called from any thread; must not throw. What cannot be read is worked out again. */
struct KeptPairs {
  std::function<std::optional<std::string>(const std::string& name)> read;
  std::function<void(const std::string& name, const std::string& bytes)> write;
};

}  // namespace roomgraph
