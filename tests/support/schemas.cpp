#include "schemas.h"

#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <rapidjson/stringbuffer.h>

#include <fstream>
#include <sstream>

namespace roomgraph::test {

std::string schemaText(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(ROOMGRAPH_SCHEMAS + name + "-1.schema.json").rdbuf();
  return text.str();
}

std::string schemaComplaint(const std::string& name, const std::string& document) {
  rapidjson::Document schemaDocument, parsed;
  if (schemaDocument.Parse(schemaText(name).c_str()).HasParseError())
    return "the schema is not JSON";
  if (parsed.Parse(document.c_str()).HasParseError()) return "the document is not JSON";
  const rapidjson::SchemaDocument schema(schemaDocument);
  rapidjson::SchemaValidator validator(schema);
  if (parsed.Accept(validator)) return {};
  rapidjson::StringBuffer place;
  validator.GetInvalidDocumentPointer().StringifyUriFragment(place);
  return std::string(validator.GetInvalidSchemaKeyword()) + " at " + place.GetString();
}

}  // namespace roomgraph::test
