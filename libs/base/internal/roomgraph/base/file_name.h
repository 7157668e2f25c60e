#pragma once
#include <filesystem>
#include <string>

namespace roomgraph {

/** Without its folder. */
inline std::string fileName(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

}  // namespace roomgraph
