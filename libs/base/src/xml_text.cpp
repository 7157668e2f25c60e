#include "roomgraph/base/xml_text.h"

#include "roomgraph/base/printable.h"
#include "roomgraph/base/utf8_text.h"

namespace roomgraph {

std::string xmlText(const std::string& given) {
  std::string text;
  for (const char c : printable(utf8Text(given))) switch (c) {
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '&':
        text += "&amp;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += c;
    }
  return text;
}

}  // namespace roomgraph
