#include "roomgraph/base/xml_text.h"

#include "roomgraph/base/printable.h"
#include "roomgraph/base/utf8_text.h"

namespace roomgraph {

std::string xmlText(const std::string& given) {
  std::string text;
  for (const char c : printable(utf8Text(given)))
    text += c == '<'   ? "&lt;"
            : c == '>' ? "&gt;"
            : c == '&' ? "&amp;"
            : c == '"' ? "&quot;"
                       : std::string(1, c);
  return text;
}

}  // namespace roomgraph
