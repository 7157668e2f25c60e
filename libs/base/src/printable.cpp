#include "roomgraph/base/printable.h"

#include <boost/locale/utf.hpp>
#include <cstdint>

namespace roomgraph {
namespace {

bool isShown(std::uint32_t code) {
  const auto isIn = [code](std::uint32_t low, std::uint32_t high) {
    return code >= low && code <= high;
  };
  const bool isControl = code < 0x20 || isIn(0x7f, 0x9f);
  // Marks of direction and of width zero, ends of lines and paragraphs, and the byte order mark.
  const bool isMark = code == 0x061c || isIn(0x200b, 0x200f) || isIn(0x2028, 0x202e) ||
                      isIn(0x2060, 0x206f) || code == 0xfeff;
  return !isControl && !isMark;
}

}  // namespace

std::string printable(const std::string& text) {
  std::string result;
  for (auto at = text.begin(); at != text.end();) {
    auto next = at;
    const auto code = boost::locale::utf::utf_traits<char>::decode(next, text.end());
    const bool isGood = boost::locale::utf::is_valid_codepoint(code);
    if (!isGood) next = at + 1;  // a byte alone
    result += isGood && isShown(code) ? std::string(at, next) : "?";
    at = next;
  }
  return result;
}

}  // namespace roomgraph
