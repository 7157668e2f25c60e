#include "CsvTable.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

std::vector<std::string> fieldsOf(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  if (!line.empty() && line.back() == ',') fields.emplace_back();
  return fields;
}

}  // namespace

CsvTable::CsvTable(const std::string& file) : file_(file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) throw DataError(file + ": is missing or empty");
  for (const std::string& name : fieldsOf(line)) columns_.emplace(name, columns_.size());
  while (std::getline(in, line)) {
    if (line.empty()) continue;
    rows_.push_back(fieldsOf(line));
    if (rows_.back().size() < columns_.size())
      throw DataError(file + ": a line is too short: " + line);
  }
}

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
  const auto found = columns_.find(column);
  if (found == columns_.end()) throw DataError(file_ + ": has no column " + column);
  return rows_.at(row).at(found->second);
}

double CsvTable::number(std::size_t row, const std::string& column) const {
  return std::atof(text(row, column).c_str());
}

Transform2D CsvTable::pose(std::size_t row, const std::string& name) const {
  return {number(row, name + "_x"), number(row, name + "_y"), number(row, name + "_phi")};
}

}  // namespace roomgraph
