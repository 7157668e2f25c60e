#pragma once
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace roomgraph {

/** Without its folder. */
inline std::string fileName(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

/** In letters of either case; `end` is in small ones. False for the end alone. */
inline bool endsWith(const std::string& name, const std::string& end) {
  return name.size() > end.size() &&
         std::equal(end.rbegin(), end.rend(), name.rbegin(), [](char a, char b) {
           return a == std::tolower(static_cast<unsigned char>(b));
         });
}

}  // namespace roomgraph
