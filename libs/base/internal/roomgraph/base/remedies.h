#pragma once

namespace roomgraph {

// What to do about a file that is damaged.
constexpr const char* kSavePictureAgain = "copy or save the picture again";
constexpr const char* kSaveMapAgain = "copy or save the map again";

}  // namespace roomgraph
