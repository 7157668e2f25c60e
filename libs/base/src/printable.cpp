#include "roomgraph/base/printable.h"

#include <cstdint>

namespace roomgraph {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t length = 0;  ///< in bytes; 0 for what is no UTF-8
};

Character characterAt(const std::string& text, std::size_t index) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(index);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || index + length > text.size()) return {};
  std::uint32_t code = first & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(index + i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(index + i) & 0x3f);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool isSurrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < kLeast[length] || code > 0x10ffff || isSurrogate) return {};
  return {code, length};
}

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
  for (std::size_t index = 0; index < text.size();) {
    const Character next = characterAt(text, index);
    const bool isGood = next.length > 0 && isShown(next.code);
    result += isGood ? text.substr(index, next.length) : "?";
    index += next.length > 0 ? next.length : 1;
  }
  return result;
}

}  // namespace roomgraph
