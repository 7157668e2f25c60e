#include "roomgraph/page/comparison_report.h"

#ifdef ROOMGRAPH_DRAWS_REPORT
#include "mustache_values.h"
#include "page_data.h"
#include "page_files.h"
#include "page_tables.h"
#else
#include "page_summary.h"
#endif

namespace roomgraph {

#ifdef ROOMGRAPH_DRAWS_REPORT
std::string comparisonReport(const Comparison& comparison, const std::vector<Run>& runs) {
  kainjow::mustache::data page = mustacheValues(pageTables(comparison));
  page.set("leafletStyle", page_files::kLeafletCss);
  page.set("leaflet", page_files::kLeafletJs);
  page.set("d3", page_files::kD3Js);
  page.set("style", page_files::kReportCss);
  page.set("script", page_files::kReportJs);
  page.set("tools", page_files::kReportToolsJs);
  page.set("licences", page_files::kLicencesTxt);
  page.set("document", pageDocument(comparison));
  page.set("data", pageData(comparison, runs));
  return kainjow::mustache::mustache(page_files::kReportHtml).render(page);
}
#else
std::string comparisonReport(const Comparison& comparison, const std::vector<Run>&) {
  return bareReport(comparison);
}
#endif

}  // namespace roomgraph
