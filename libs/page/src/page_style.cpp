#include "roomgraph/page/page_style.h"

#include "page_files.h"

namespace roomgraph {

const char* pageStyle() { return page_files::kReportCss; }

}  // namespace roomgraph
