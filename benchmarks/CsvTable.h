#pragma once
#include <map>
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** A small table of text, as the data sets come with. */
class CsvTable {
 public:
  /** Commas, no quotes; the first line names the columns. Throws DataError where the file is
   *  missing or a line has too few fields. */
  explicit CsvTable(const std::string& file);

  std::size_t size() const { return rows_.size(); }
  const std::string& text(std::size_t row, const std::string& column) const;
  double number(std::size_t row, const std::string& column) const;
  /** Of the columns NAME_x, NAME_y and NAME_phi. */
  Transform2D pose(std::size_t row, const std::string& name) const;

 private:
  std::string file_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace roomgraph
