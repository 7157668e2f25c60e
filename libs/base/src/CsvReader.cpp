#include "roomgraph/base/CsvReader.h"

#include <algorithm>

namespace roomgraph {

std::vector<std::string> CsvReader::nextLine() {
  ++line_;
  std::vector<std::string> cells{cell()};
  while (at_ < text_.size() && text_[at_] == ',') {
    ++at_;
    cells.push_back(cell());
  }
  if (at_ < text_.size() && text_[at_] == '\r') ++at_;
  if (at_ < text_.size() && text_[at_] == '\n') ++at_;
  return cells;
}

std::string CsvReader::cell() {
  if (at_ < text_.size() && text_[at_] == '"') return quotedCell();
  const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
  std::string cell = text_.substr(at_, end - at_);
  at_ = end;
  return cell;
}

std::string CsvReader::quotedCell() {
  std::string cell;
  for (++at_; at_ < text_.size(); ++at_) {
    const bool isQuote = text_[at_] == '"';
    const bool isTwice = isQuote && at_ + 1 < text_.size() && text_[at_ + 1] == '"';
    if (isQuote && !isTwice) break;
    cell += text_[at_];
    if (isTwice) ++at_;
  }
  at_ = std::min(text_.find_first_of(",\r\n", std::min(at_ + 1, text_.size())), text_.size());
  return cell;
}

}  // namespace roomgraph
