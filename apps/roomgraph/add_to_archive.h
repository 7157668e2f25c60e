#pragma once
#include <string>

#include "ArchiveArguments.h"
#include "roomgraph/archive/Archive.h"

namespace roomgraph {

/** The site that is asked for, or that the archive is named after. @throws UsageError where it has
 *  several, and none is asked for. */
std::string siteToAddTo(const ArchiveArguments& arguments, const Archive& archive);

/** How runs are added, but for the site. @throws UsageError for a time that is none. */
AddRunOptions addOptionsOf(const ArchiveArguments& arguments);

/** `roomgraph archive ARCHIVE add`; gives its exit code. Adds one run after the other, so that what
 *  is done stays whatever happens to the rest. */
int addToArchive(const ArchiveArguments& arguments);

}  // namespace roomgraph
