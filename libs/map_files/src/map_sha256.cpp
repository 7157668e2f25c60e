#include "roomgraph/map_files/map_sha256.h"

#include "readers.h"

namespace roomgraph {

std::string mapSha256(const std::string& name) {
  CheckedFile file(name);
  const ByteView content = file.content();
  if (!isRosMap(file)) return file.sha256();
  CheckedFile picture(pictureOfRosMap(file));
  return sha256Of(content, picture.content());
}

std::string pictureOfMap(const std::string& name) {
  CheckedFile file(name);
  return isRosMap(file) ? pictureOfRosMap(file) : "";
}

}  // namespace roomgraph
