#include "error_line.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "commands.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/failure_text.h"
#include "roomgraph/base/printable.h"

namespace roomgraph {

std::string errorLine(const std::string& text) {
  constexpr std::size_t kMost = 10000;  // bytes; a name has at most 4096
  return "roomgraph: " + printable(text.substr(0, kMost)) + "\n";
}

Failure currentFailure(const std::string& file) {
  const std::string line = errorLine(failureText(file));
  try {
    throw;
  } catch (const UsageError&) {
    return {line, kBadUsage};
  } catch (const std::exception&) {
    return {line, kBadData};
  }
}

int doEach(const std::vector<std::string>& files,
           const std::function<void(const std::string& file)>& job) {
  int exitCode = kDone;
  for (const std::string& file : files) {
    try {
      job(file);
    } catch (...) {
      const Failure failure = currentFailure(file);
      std::fputs(failure.line.c_str(), stderr);
      exitCode = std::max(exitCode, failure.exitCode);
    }
  }
  return exitCode;
}

}  // namespace roomgraph
