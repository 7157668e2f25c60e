#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace roomgraph {

/** A text as one cell of a table: in quotes where it must be. One that begins like a formula gets
 *  an apostrophe in front, without which spreadsheets would take it for one. */
std::string csvField(const std::string& text);

/** A number with four places; empty for none. */
std::string csvNumber(std::optional<double> value);

/** Whether a column has this name, in letters of either case. */
bool isNamed(const std::string& column, const char* name);
/** The first column of this name. */
std::optional<std::size_t> columnOf(const std::vector<std::string>& names, const char* name);

/** Takes cells from a CSV text, line by line: what csvField wrote, and what spreadsheets write with
 *  commas. */
class CsvReader {
 public:
  /** `text` must outlive this; `name` is its file's, for messages. A byte order mark, as
   *  spreadsheets put before it, is skipped. */
  CsvReader(const std::string& text, std::string name)
      : text_(text), name_(std::move(name)), at_(text.rfind("\xef\xbb\xbf", 0) == 0 ? 3 : 0) {}

  bool isAtEnd() const { return at_ >= text_.size(); }
  /** The number of the line in which the last one began, from 1: cells may hold ends of lines. */
  std::size_t line() const { return line_; }

  /** At least one cell, which is empty where the line is.
   *  @throws DataError where a quote is not closed, or where text stands behind a closed one; the
   *  lines behind this one can be read then. */
  std::vector<std::string> nextLine();
  /** The same cells of the last line as they stand in the text. */
  const std::vector<std::string>& writtenCells() const { return written_; }

 private:
  std::string cell();
  std::string quotedCell();
  std::size_t lineAt(std::size_t at) const;
  [[noreturn]] void refuseQuote(const char* problem, std::size_t at, const char* remedy);

  const std::string& text_;
  std::string name_;
  std::vector<std::string> written_;
  std::size_t at_, begin_ = 0, line_ = 0, next_ = 1;  // begin_: of the last line
};

}  // namespace roomgraph
