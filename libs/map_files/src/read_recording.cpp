#include "roomgraph/map_files/read_recording.h"

#include "roomgraph/map_files/map_formats.h"

namespace roomgraph {

std::optional<Recording> readRecording(const std::string& name) {
  const auto file = std::make_shared<CheckedFile>(name);
  for (const MapFormat& format : mapFormats()) {
    if (!format.readRecording || !format.looksLike(*file)) continue;
    Recording recording = format.readRecording(*file);
    recording.bytes = file;
    return recording;
  }
  return std::nullopt;
}

}  // namespace roomgraph
