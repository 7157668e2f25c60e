#pragma once
#include <string>

namespace roomgraph {

/** A page for a browser that needs no other file, no network and no script, in the style of the
 *  report. All of it is HTML. */
struct SimplePage {
  std::string title, subject;  ///< of the browser's tab; of such pages
  std::string heading, counts, body, footer;
  std::string style;  ///< besides that of the report
};
std::string simplePage(const SimplePage& page);

}  // namespace roomgraph
