#include "roomgraph/base/csv_text.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <string_view>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {

std::string csvField(const std::string& given) {
  const bool isFormula = given.find_first_of("=+-@\t\r") == 0;
  std::string text = isFormula ? "'" + given : given;
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csvNumber(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return "";
  return formatted("%.4f", rounded(*value));
}

bool isNamed(const std::string& column, const char* name) {
  return boost::algorithm::iequals(column, name);
}

std::optional<std::size_t> columnOf(const std::vector<std::string>& names, const char* name) {
  const auto* found = findIf(names, [&](const std::string& one) { return isNamed(one, name); });
  if (found == nullptr) return std::nullopt;
  return std::size_t(found - names.data());
}

std::vector<std::string> CsvReader::nextLine() {
  line_ = next_, begin_ = at_;
  written_.clear();
  std::vector<std::string> cells;
  for (std::size_t begin = at_;; begin = ++at_) {
    cells.push_back(cell());
    written_.push_back(text_.substr(begin, at_ - begin));
    if (isAtEnd() || text_[at_] != ',') break;
  }
  next_ = lineAt(at_) + 1;
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
  const std::size_t begin = at_;
  for (++at_; at_ < text_.size(); ++at_) {
    const bool isQuote = text_[at_] == '"';
    const bool isTwice = isQuote && at_ + 1 < text_.size() && text_[at_ + 1] == '"';
    if (isQuote && !isTwice) break;
    cell += text_[at_];
    if (isTwice) ++at_;
  }
  if (isAtEnd()) refuseQuote("a quote not closed", begin, "close it, or take it out");
  at_ = std::min(text_.find_first_not_of(" \t", at_ + 1), text_.size());
  if (!isAtEnd() && std::string_view(",\r\n").find(text_[at_]) == std::string_view::npos)
    refuseQuote("text after a closing quote", at_,
                "put the whole cell in quotes, and each quote in it twice");
  return cell;
}

std::size_t CsvReader::lineAt(std::size_t at) const {
  const std::string_view before = std::string_view(text_).substr(begin_, at - begin_);
  return line_ + countIf(before, [](char c) { return c == '\n'; });
}

void CsvReader::refuseQuote(const char* problem, std::size_t at, const char* remedy) {
  const std::size_t line = lineAt(at);
  at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1, next_ = line + 1;
  refuse(name_, "has " + std::string(problem) + " in line " + std::to_string(line), remedy);
}

}  // namespace roomgraph
