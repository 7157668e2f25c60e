#include <dlfcn.h>

#include <cstring>

#include "OnDemand.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/version.h"

namespace roomgraph {
namespace {

[[noreturn]] void refuseLibrary(const std::string& problem) {
  throw DataError(problem + ": install roomgraph again");
}

/** The library is found beside the program, by its run path. It is never closed: MRPT keeps the
 *  classes in it. */
template <class Functions>
const Functions& load(const char* name) {
  void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  if (!library) refuseLibrary(dlerror());  // the text begins with the name
  const auto* found =
      static_cast<const OnDemandLibrary<Functions>*>(dlsym(library, "roomgraph_on_demand"));
  if (!found || std::strcmp(found->version, version()) != 0)
    refuseLibrary(std::string(name) + ": belongs to another version of the program");
  return found->functions;
}

const WithMrpt& withMrpt() {
  static const WithMrpt& functions = load<WithMrpt>(ROOMGRAPH_WITH_MRPT);
  return functions;
}

const WithPoses& withPoses() {
  static const WithPoses& functions = load<WithPoses>(ROOMGRAPH_WITH_POSES);
  return functions;
}

const WithCeres& withCeres() {
  static const WithCeres& functions = load<WithCeres>(ROOMGRAPH_WITH_CERES);
  return functions;
}

}  // namespace

// These take the place of the functions of the same names in the libraries, which are then not
// linked to the program.

GreyMap gridOfScans(CheckedFile& file, const LoadGridOptions& options) {
  return withMrpt().gridOfScans(file, options);
}

std::vector<Keyframe> readKeyframes(CheckedFile& file, const LoadGridOptions& options) {
  return withMrpt().readKeyframes(file, options);
}

RunInfo readRunInfo(CheckedFile& file) { return withPoses().readRunInfo(file); }

std::vector<mrpt::math::TPoint3Df> readKeyframeLayer(ByteReader& in) {
  return withPoses().readKeyframeLayer(in);
}

PoseGraphSolution solvePoseGraph(const PoseGraph& graph, const GraphTrust& trust, NodePoses start,
                                 StartIs startIs) {
  return withCeres().solvePoseGraph(graph, trust, std::move(start), startIs);
}

std::string gridmapBytes(const GreyMap& map, const Grid& grid) {
  return withMrpt().gridmapBytes(map, grid);
}

std::string graphSceneFile(const Stages& stages) { return withMrpt().graphSceneFile(stages); }
std::string graphObjectFile(const Stages& stages) { return withMrpt().graphObjectFile(stages); }

std::string comparisonSceneFile(const Comparison& comparison, const std::vector<Run>& runs) {
  return withMrpt().comparisonSceneFile(comparison, runs);
}
std::string comparisonObjectFile(const Comparison& comparison, const std::vector<Run>& runs) {
  return withMrpt().comparisonObjectFile(comparison, runs);
}

std::vector<std::string> addBreakFiles(const Comparison& comparison, const std::vector<Run>& runs,
                                       const LoadGridOptions& reading,
                                       const std::filesystem::path& folder, StagedFiles& staged) {
  return withMrpt().addBreakFiles(comparison, runs, reading, folder, staged);
}

std::string scanLog(const std::string& file, const LoadGridOptions& reading,
                    const KeyFrameStretch& stretch) {
  return withMrpt().scanLog(file, reading, stretch);
}

}  // namespace roomgraph
