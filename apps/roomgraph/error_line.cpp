#include "error_line.h"

#include <new>

#include "Command.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"

namespace roomgraph {
namespace {

/** MRPT's messages carry a backtrace in further lines. */
std::string firstLine(const std::string& text) {
  constexpr std::size_t kMost = 200;
  return text.substr(0, std::min(text.find('\n'), kMost));
}

}  // namespace

std::string errorLine(const std::string& text) {
  constexpr std::size_t kMost = 10000;  // bytes; a name has at most 4096
  return "roomgraph: " + printable(text.substr(0, kMost)) + "\n";
}

Failure currentFailure(const std::string& file) {
  const std::string prefix = file.empty() ? "" : file + ": ";
  try {
    throw;
  } catch (const UsageError& error) {
    return {errorLine(error.what()), kBadUsage};
  } catch (const DataError& error) {
    return {errorLine(error.what()), kBadData};
  } catch (const std::bad_alloc&) {
    return {errorLine(prefix + "not enough memory: use a coarser map, or --threads 1"), kBadData};
  } catch (const std::exception& error) {
    return {errorLine(prefix + "failed (" + firstLine(error.what()) + "): please report this"),
            kBadData};
  }
}

}  // namespace roomgraph
