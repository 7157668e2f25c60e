#pragma once
#include <string>

namespace roomgraph::test {

/** The schema share/roomgraph/schema/NAME-1.schema.json. */
std::string schemaText(const std::string& name);

/** Where a document breaks that schema; empty where it does not. */
std::string schemaComplaint(const std::string& name, const std::string& document);

}  // namespace roomgraph::test
