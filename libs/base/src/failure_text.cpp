#include "roomgraph/base/failure_text.h"

#include <algorithm>
#include <new>
#include <system_error>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** MRPT's messages carry a backtrace in further lines. */
std::string firstLine(const std::string& text) {
  return text.substr(0, std::min<std::size_t>(text.find('\n'), 200));
}

std::string unforeseen(const std::exception& error) {
  return "failed (" + firstLine(error.what()) + "): please report this";
}

}  // namespace

std::string failureText(const std::string& file) {
  const std::string prefix = file.empty() ? "" : file + ": ";
  try {
    throw;
  } catch (const UsageError& error) {
    return error.what();
  } catch (const DataError& error) {
    return error.what();
  } catch (const std::bad_alloc&) {
    return prefix + "not enough memory: use a coarser map, or --threads 1";
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again)
      return prefix + "not enough memory for a thread: end other programs";
    return prefix + unforeseen(error);
  } catch (const std::exception& error) {
    return prefix + unforeseen(error);
  }
}

}  // namespace roomgraph
