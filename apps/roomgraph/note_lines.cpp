#include "note_lines.h"

#include <set>

#include "roomgraph/base/sentence_text.h"
#include "terminal.h"

namespace roomgraph {
namespace {

std::string lineOf(const MapNote& one) { return one.file + ": note: " + one.note.text; }

std::string allLines(const std::vector<MapNote>& notes) {
  std::string lines;
  for (const MapNote& one : notes) {
    std::string text = lineOf(one);
    if (one.note.where)
      text += formatted(" (at %.2f, %.2f)", (*one.note.where)[0], (*one.note.where)[1]);
    lines += errorLine(text);
  }
  return lines;
}

}  // namespace

std::string noteLines(const std::vector<MapNote>& notes, bool isVerbose) {
  if (isVerbose) return allLines(notes);
  std::set<std::string> files, codes;  // that were told
  std::vector<std::string> told;
  for (const MapNote& one : notes) {
    const bool isNew = codes.insert(one.note.code).second;
    if (isNew && files.insert(one.file).second) told.push_back(lineOf(one));
  }
  if (const std::size_t more = notes.size() - told.size())
    told.back() += " (and " + counted(more, "more note", "more notes") + ": see --verbose)";
  std::string lines;
  for (const std::string& text : told) lines += errorLine(text);
  return lines;
}

}  // namespace roomgraph
