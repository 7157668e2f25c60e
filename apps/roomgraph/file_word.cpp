#include "file_word.h"

#include <cctype>

namespace roomgraph {

std::string fileWord(const std::string& name, std::set<std::string>& taken) {
  std::string word;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    word += byte >= 0x80 || std::isalnum(byte) || c == '-' || c == '.' ? c : '_';
  }
  while (!taken.insert(word).second) word += '_';
  return word;
}

}  // namespace roomgraph
