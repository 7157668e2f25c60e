#include "svg_bytes.h"

#include <map>

namespace roomgraph {
namespace {

constexpr const char* kMarks[] = {"id=\"image", "\"#image", "id=\"surface", "\"#surface"};

/** The next mention of such an id and the place of its digits; npos where there is none. */
std::size_t findMention(const std::string& svg, std::size_t from, std::size_t& digits) {
  std::size_t first = std::string::npos;
  for (const std::string mark : kMarks) {
    const std::size_t found = svg.find(mark, from);
    if (found >= first) continue;
    first = found;
    digits = found + mark.size();
  }
  return first;
}

void addSquaresHint(std::string& svg) {
  const std::string tag = "<image ";
  const std::size_t found = svg.find(tag);
  if (found != std::string::npos)
    svg.insert(found + tag.size(), "image-rendering=\"optimizeSpeed\" ");
}

}  // namespace

std::string finishedSvg(const std::string& svg) {
  std::string result;
  std::map<std::string, std::size_t> number;
  std::size_t copied = 0, digits = 0;
  while (findMention(svg, copied, digits) != std::string::npos) {
    const std::size_t end = svg.find_first_not_of("0123456789", digits);
    const std::string old = svg.substr(digits, end - digits);
    const std::size_t own = number.emplace(old, number.size() + 1).first->second;
    result.append(svg, copied, digits - copied);
    result += std::to_string(own);
    copied = end;
  }
  result.append(svg, copied);
  addSquaresHint(result);
  return result;
}

}  // namespace roomgraph
