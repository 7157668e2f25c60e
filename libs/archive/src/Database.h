#pragma once
#include <cstdint>
#include <optional>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace roomgraph {

/** An SQLite file. All that fails is a DataError with one line: file, problem, remedy. */
class Database {
 public:
  /** A file that may not be written, or on a full disk, is opened to be read.
   *  @throws DataError where the file is empty, or not there, unless it may be made. */
  Database(const std::string& file, bool mayMake);
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database();

  /** Statements without results, separated by semicolons. */
  void run(const std::string& sql);
  /** The same; false where another program is just writing. */
  bool tryRun(const std::string& sql);
  /** A statement without results, with the values of its question marks. */
  template <class Value, class... Values>
  void run(const std::string& sql, const Value& first, const Values&... others);
  /** The first column of the first row as a number; 0 without a row. */
  template <class... Values>
  std::int64_t number(const std::string& sql, const Values&... values);

  const std::string& file() const { return file_; }
  bool isReadOnly() const { return isReadOnly_; }
  sqlite3* handle() const { return handle_; }
  /** Throws what the last call on the database ended with. */
  [[noreturn]] void fail() const;

 private:
  void open(const std::string& name, int flags);
  void openToRead(const std::string& path, bool hasLog);

  std::string file_;
  sqlite3* handle_ = nullptr;
  bool isReadOnly_ = false, isFull_ = false, isNew_ = false;
};

/** One SQL statement with its values. */
class Statement {
 public:
  Statement(Database& database, const std::string& sql);
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  /** The values of the question marks, from the first on. */
  template <class... Values>
  Statement& with(const Values&... values) {
    reset();
    (bind(values), ...);
    return *this;
  }

  /** Goes to the next row; false behind the last one. */
  bool step();

  std::string text(int column) const;
  double number(int column) const;
  std::optional<double> numberIfAny(int column) const;
  std::int64_t integer(int column) const;

 private:
  void reset();
  void bind(const std::string& value);
  void bind(const char* value) { bind(std::string(value)); }
  void bind(double value);
  void bind(const std::optional<double>& value);
  void bind(std::int64_t value);
  void bind(int value) { bind(std::int64_t(value)); }
  void bind(bool value) { bind(std::int64_t(value)); }
  void check(int code) const;

  Database& database_;
  sqlite3_stmt* statement_ = nullptr;
  int next_ = 1;
};

template <class Value, class... Values>
void Database::run(const std::string& sql, const Value& first, const Values&... others) {
  Statement(*this, sql).with(first, others...).step();
}

template <class... Values>
std::int64_t Database::number(const std::string& sql, const Values&... values) {
  Statement statement(*this, sql);
  return statement.with(values...).step() ? statement.integer(0) : 0;
}

/** From its begin on no other program writes; what is not committed is undone at the end. One that
 *  only reads sees one state of the file, and keeps nobody from writing. */
class Transaction {
 public:
  enum class Access { reads, writes };
  explicit Transaction(Database& database, Access access = Access::writes);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  void commit();

 private:
  Database& database_;
  bool isOpen_ = true;
};

}  // namespace roomgraph
