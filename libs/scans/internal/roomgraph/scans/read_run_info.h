#pragma once
#include "roomgraph/scans/load_run_info.h"

namespace roomgraph {

/** What loadRunInfo() gives of a file that is a simplemap. */
RunInfo readRunInfo(CheckedFile& file);

}  // namespace roomgraph
