#include "roomgraph/base/sentence_text.h"

#include <algorithm>

namespace roomgraph {
namespace {

/** Damerau and Levenshtein's distance, where no letter is changed twice. */
std::size_t changesBetween(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        least[i][j] = i + j;
        continue;
      }
      const std::size_t isOther = a[i - 1] == b[j - 1] ? 0 : 1;
      least[i][j] =
          std::min({least[i - 1][j] + 1, least[i][j - 1] + 1, least[i - 1][j - 1] + isOther});
      const bool areSwapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (areSwapped) least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
    }
  return least[a.size()][b.size()];
}

std::string joined(const std::vector<std::string>& names, const std::string& beforeLast,
                   const std::string& between = ", ") {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? beforeLast : between) + names[i];
  return text;
}

/** The first `most`, and how many more there are; "1 more" would be no shorter than the name. */
void shorten(std::vector<std::string>& names, std::size_t most) {
  if (names.size() <= most + 1) return;
  const std::size_t more = names.size() - most;
  names.resize(most);
  names.push_back(std::to_string(more) + " more");
}

}  // namespace

std::string nearestWord(const std::string& typed, const std::vector<std::string>& words) {
  std::string nearest;
  std::size_t fewest = std::max<std::size_t>(1, typed.size() / 3) + 1;
  if (typed.size() > 40) return nearest;  // nobody types that by mistake
  for (const std::string& word : words)
    if (const std::size_t changes = changesBetween(typed, word); changes < fewest)
      nearest = word, fewest = changes;
  return nearest;
}

std::string counted(std::size_t count, const std::string& thing, const std::string& things) {
  return std::to_string(count) + " " + (count == 1 ? thing : things);
}

std::string listed(std::vector<std::string> names, std::size_t most) {
  shorten(names, most);
  return joined(names, " and ");
}

std::string listedSentences(std::vector<std::string> sentences, std::size_t most) {
  shorten(sentences, most);
  return joined(sentences, "; and ", "; ");
}

std::string alternatives(const std::vector<std::string>& names) { return joined(names, " or "); }

}  // namespace roomgraph
