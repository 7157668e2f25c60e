#pragma once
#include <charconv>
#include <string>

#include "roomgraph/base/sentence_text.h"

namespace roomgraph {

/** The text in quotes as YAML and TOML read it, whatever it holds. */
inline std::string quotedText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      quoted += formatted("\\u%04x", unsigned(c));
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

/** The shortest text that reads back equal; the same in every locale. */
inline std::string numberText(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

}  // namespace roomgraph
