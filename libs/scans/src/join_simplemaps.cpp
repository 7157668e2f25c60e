#include "roomgraph/scans/join_simplemaps.h"

#include <algorithm>
#include <cstdint>

#include "roomgraph/scans/object_header.h"

namespace roomgraph {
namespace {

template <class T>
std::string raw(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string textBytes(const std::string& text) { return raw(std::uint32_t(text.size())) + text; }

/** What MRPT writes for a speed that is not known. */
std::string noTwist() { return textBytes("std::optional") + textBytes("TTwist3D") + '\0'; }

}  // namespace

std::string joinSimplemaps(const std::vector<SimplemapPart>& parts) {
  if (parts.empty()) return {};
  const auto newest = std::max_element(parts.begin(), parts.end(),
                                       [](const SimplemapPart& l, const SimplemapPart& r) {
                                         return l.stored.mapVersion < r.stored.mapVersion;
                                       });
  std::uint32_t count = 0;
  for (const SimplemapPart& part : parts) count += std::uint32_t(part.frames.size());
  std::string joined =
      newest->content.substr(0, newest->stored.headEnd - sizeof count) + raw(count);
  for (const SimplemapPart& part : parts) {
    const bool lacksTwist = newest->stored.mapVersion >= 2 && part.stored.mapVersion < 2;
    for (const std::size_t k : part.frames) {
      const StoredPose& frame = part.stored.frames[k];
      joined.append(part.content, frame.begin, frame.end - frame.begin);
      if (lacksTwist) joined += noTwist();
    }
  }
  return joined + char(kObjectEnd);
}

}  // namespace roomgraph
