#include "roomgraph/base/json_fault.h"

#include <algorithm>

namespace roomgraph {
namespace {

/** How deep lists and objects are nested in each other. */
int nesting(const std::string& text) {
  int depth = 0, most = 0;
  bool isInString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') isInString = !isInString;
    if (isInString && c == '\\') ++i;  // what follows ends no string
    if (isInString) continue;
    if (c == '{' || c == '[') most = std::max(most, ++depth);
    if (c == '}' || c == ']') --depth;
  }
  return most;
}

}  // namespace

std::string jsonFault(const std::string& text, const std::string& format) {
  constexpr const char* kBlank = " \t\r\n";
  constexpr int kDeepest = 20;
  const auto first = text.find_first_not_of(kBlank), last = text.find_last_not_of(kBlank);
  if (first == std::string::npos) return "is empty";
  if (text[first] != '{' || text[last] != '}') return "is not JSON, or only a part of it";
  if (text.find('"' + format + '"') == std::string::npos) return "is not of format " + format;
  if (nesting(text) > kDeepest) return "is nested too deeply";
  return {};
}

}  // namespace roomgraph
