#pragma once
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace roomgraph {

/** What printf would print, of any length. */
template <class... Values>
std::string formatted(const char* format, Values... values) {
  std::string text(std::size_t(std::snprintf(nullptr, 0, format, values...)), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

/** The shortest text that reads back equal; the same in every locale. */
template <class Number>
std::string numberText(Number value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/** Whether all of the text is a number, in any locale, that `value` can hold. */
template <class Number>
bool parseNumber(const std::string& text, Number& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

/** "1 room", "2 rooms". */
std::string counted(std::size_t count, const std::string& thing, const std::string& things);

/** "a, b and c"; of more than `most` names, and one, "a, b and 3 more". Empty for none. */
std::string listed(std::vector<std::string> names, std::size_t most = 1'000'000);
/** The same with "; ", which the sentences may have commas beside. */
std::string listedSentences(std::vector<std::string> sentences, std::size_t most);

/** "a, b or c". Empty for none. */
std::string alternatives(const std::vector<std::string>& names);

/** The word that was most likely meant: the one that takes the fewest letters changed, left out,
 *  put in or swapped with their neighbour, of equal ones the first. Empty where even that one needs
 *  more than a third of the letters of `typed`. */
std::string nearestWord(const std::string& typed, const std::vector<std::string>& words);

}  // namespace roomgraph
