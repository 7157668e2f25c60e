#include "roomgraph/base/read_document.h"

#include "roomgraph/base/Error.h"
#include "roomgraph/base/json_fault.h"

namespace roomgraph {

nlohmann::ordered_json parseDocument(const std::string& text, const std::string& name,
                                     const std::string& format, const std::string& remedy) {
  const std::string fault = jsonFault(text, format);
  if (!fault.empty()) throw DataError(name + ": " + fault + "; " + remedy);
  auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  if (json.is_discarded()) throw DataError(name + ": is not JSON, or only a part of it; " + remedy);
  return json;
}

void refuseDocument(const std::string& name, const Broken& broken, const std::string& remedy) {
  const std::string where = broken.where.empty() ? "the file" : broken.where;
  throw DataError(name + ": " + where + " " + broken.problem + "; " + remedy);
}

}  // namespace roomgraph
