#include "roomgraph/base/Error.h"

#include "roomgraph/base/printable.h"

namespace roomgraph {

void refuse(const std::string& file, const std::string& problem, const std::string& remedy) {
  throw DataError(printable((file.empty() ? "''" : file) + ": " + problem + ": " + remedy));
}

}  // namespace roomgraph
