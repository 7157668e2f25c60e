#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace roomgraph {

/** What a value of an enumeration is called in all files. Beside the enumeration, which counts from
 *  0, stands enumNames() with the names of its values in their order. */
template <class Enum, class = decltype(enumNames(Enum()))>
[[nodiscard]] const char* nameOf(Enum value) {
  return enumNames(value)[std::size_t(value)];
}

/** The value of that name; none for any other text. */
template <class Enum>
[[nodiscard]] std::optional<Enum> valueOfName(const std::string& name) {
  const auto names = enumNames(Enum());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i]) return Enum(i);
  return std::nullopt;
}

}  // namespace roomgraph
