#include "bare_report.h"

#include "page_summary.h"
#include "roomgraph/base/xml_text.h"
#include "roomgraph/page/simple_page.h"

namespace roomgraph {

std::string bareReport(const Comparison& comparison) {
  SimplePage page;
  page.title = "Comparison of maps", page.subject = "comparison of maps";
  page.heading = xmlText(comparison.verdict), page.counts = xmlText(pageCounts(comparison));
  page.body = "<section>\n<ul>\n";
  for (const std::string& sentence : pageSummary(comparison))
    page.body += "<li>" + xmlText(sentence) + "</li>\n";
  page.body += "</ul>\n</section>\n";
  page.footer =
      "It was built without mustache, Leaflet and D3, which draw the maps and tables of this page: "
      "the figures are in comparison.json.";
  return simplePage(page);
}

}  // namespace roomgraph
