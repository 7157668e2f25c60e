#include "roomgraph/graph_files/GraphFile.h"

#include "roomgraph/base/file_name.h"
#include "roomgraph/base/version.h"

namespace roomgraph {
namespace {

SavedOption savedOption(const Field& field) {
  SavedOption option{field.section, field.name, {}};
  std::visit([&](const auto* value) { option.value = *value; }, field.value);
  return option;
}

/** The same field over a value of our own, for valueText(). */
std::string text(SavedOption option) {
  Field field;
  std::visit([&](auto& value) { field.value = &value; }, option.value);
  return valueText(field);
}

}  // namespace

GraphFile graphFile(const Stages& stages) {
  const GreyMap::Source& source = stages.source;
  GraphFile file;
  file.program = "roomgraph", file.version = version();
  file.input = {fileName(source.file), source.kind, source.sha256, source.insertion,
                stages.grid.frame};
  ExtractOptions options = stages.options;
  const FieldTable table = describe(options);
  for (const Field& field : table.fields()) file.options.push_back(savedOption(field));
  file.graph = stages.result;
  file.areas.areas = stages.areas.areas;
  file.areas.passages = stages.areas.passages;
  file.notes = stages.notes;
  return file;
}

std::string optionsIni(const GraphFile& file) {
  std::string ini, section;
  for (const SavedOption& option : file.options) {
    if (option.section != section) ini += "[" + option.section + "]\n";
    section = option.section;
    ini += option.key + " = " + text(option) + "\n";
  }
  return ini;
}

}  // namespace roomgraph
