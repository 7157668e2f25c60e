#pragma once
#include "roomgraph/scans/RunInfo.h"

namespace roomgraph {

/** What loadRunInfo() gives of a file that is a simplemap. */
RunInfo readRunInfo(CheckedFile& file);

}  // namespace roomgraph
