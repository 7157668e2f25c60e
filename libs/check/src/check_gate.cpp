#include "roomgraph/check/check_gate.h"

#include "roomgraph/base/sentence_text.h"

namespace roomgraph {

std::vector<std::string> complaintsOf(const RunCheck& check, const CheckGateOptions& options) {
  std::vector<std::string> complaints;
  if (options.maxError && !check.selfError)
    complaints.push_back(check.sentence);
  else if (options.maxError && *check.selfError > *options.maxError)
    complaints.push_back(
        formatted("its self error of %.3f m is above %g m", *check.selfError, *options.maxError));
  if (options.failsOnBreaks && !check.breaks.empty())
    complaints.push_back("it breaks in " + counted(check.breaks.size(), "place", "places"));
  if (options.failsOnDoubled && !check.doubled.empty())
    complaints.push_back("it has drawn " + counted(check.doubled.size(), "place", "places") +
                         " twice");
  if (options.failsOnDoubled && !check.welded.empty())
    complaints.push_back("it has laid " + counted(check.welded.size(), "place", "places") +
                         " over another");
  return complaints;
}

}  // namespace roomgraph
