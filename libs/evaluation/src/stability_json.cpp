#include "stability_json.h"

namespace roomgraph {

Json optionsJson(const ExtractOptions& options) {
  ExtractOptions copy = options;
  const FieldTable table = describe(copy);
  Json json = Json::object();
  for (const Field& field : table.fields())
    std::visit([&](const auto* value) { json[field.section][field.name] = *value; }, field.value);
  return json;
}

}  // namespace roomgraph
