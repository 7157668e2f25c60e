#include "note_lines.h"

#include <map>

#include "error_line.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {

std::string noteLines(const std::vector<MapNote>& notes, bool isVerbose) {
  std::map<std::string, std::size_t> counts;
  for (const MapNote& one : notes) ++counts[one.note.code];
  std::string lines;
  for (const auto& [file, note] : notes) {
    std::size_t& count = counts[note.code];
    if (count == 0) continue;
    std::string text = file + ": note: " + note.text;
    if (isVerbose && note.where)
      text += formatted(" (at %.2f, %.2f)", (*note.where)[0], (*note.where)[1]);
    if (!isVerbose) {
      if (count > 1)
        text += " (and " + std::to_string(count - 1) + " more like this: see --verbose)";
      count = 0;
    }
    lines += errorLine(text);
  }
  return lines;
}

}  // namespace roomgraph
