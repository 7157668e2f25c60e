#pragma once
#include <string>
#include <vector>

#include "roomgraph/check/RunCheck.h"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// In:   Comparison with the verdict of its gate
// Out:  text of files for CI systems
// Next: a file

/** JUnit XML, as Jenkins, GitLab and others show it: a test for each run that was judged, which
 *  fails with what the gate says of it; one for what it says of no run. Without a gate every run
 *  passes. */
std::string gateJunit(const Comparison& comparison);

/** A Markdown page, as GitHub shows it below a job: a heading of one line, why the gate fails or by
 *  how much it passes, the verdict of the comparison, and a table of the runs. */
std::string gateMarkdown(const Comparison& comparison);

/** The same of runs that were checked each by itself, and of files that could not be read, which
 *  do not pass. */
std::string gateJunit(const std::vector<RunCheck>& checks, const std::vector<std::string>& unread);
std::string gateMarkdown(const std::vector<RunCheck>& checks,
                         const std::vector<std::string>& unread);

}  // namespace roomgraph
