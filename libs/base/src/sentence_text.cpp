#include "roomgraph/base/sentence_text.h"

namespace roomgraph {

std::string counted(std::size_t count, const std::string& thing, const std::string& things) {
  return std::to_string(count) + " " + (count == 1 ? thing : things);
}

std::string listed(const std::vector<std::string>& names, std::size_t most) {
  // "and 1 more" would be no shorter than the name.
  const std::size_t shown = names.size() > most + 1 ? most : names.size();
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool isLast = i + 1 == shown && shown == names.size();
    text += (i == 0 ? "" : isLast ? " and " : ", ") + names[i];
  }
  if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

}  // namespace roomgraph
