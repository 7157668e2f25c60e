#pragma once
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

}  // namespace roomgraph
