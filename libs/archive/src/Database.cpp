#include "Database.h"

#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

const char* remedyOf(int code) {
  switch (code & 0xff) {
    case SQLITE_NOTADB:
      return "name an archive, or a file that is not there yet";
    case SQLITE_CORRUPT:
      return "bring back a copy of it";
    case SQLITE_FULL:
      return "free some space, then call again: nothing is lost";
    case SQLITE_BUSY:
      return "another program is writing to it: call again";
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return "check its name and permissions, and those of its folder";
    default:
      return "call again: nothing is lost";
  }
}

/** Whoever writes an archive also makes files beside it. */
bool mayBeWritten(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return access(path.c_str(), W_OK) == 0 && access(folder.c_str(), W_OK) == 0;
}

/** The name that SQLite opens a file by that may only be read. Where no log lies beside it, nobody
 *  is writing to it, and SQLite need not make one to see that. */
std::string readOnlyUri(const std::string& path, bool hasLog) {
  std::string uri = "file:";
  for (const char c : path) {
    constexpr char digits[] = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    if (c == '%' || c == '?' || c == '#')
      uri += {'%', digits[byte >> 4u], digits[byte & 15u]};
    else
      uri += c;
  }
  return uri + (hasLog ? "?mode=ro" : "?immutable=1");
}

/** 0 where there is none. */
std::uintmax_t sizeOf(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

/** Whether SQLite finds room for what it makes beside a file before the first question. */
bool hasRoom(sqlite3* handle) {
  const int code = sqlite3_exec(handle, "PRAGMA user_version", nullptr, nullptr, nullptr) & 0xff;
  return code != SQLITE_FULL && (code != SQLITE_IOERR || sqlite3_system_errno(handle) != ENOSPC);
}

/** Whether the disk gives all bytes of the file. They are asked for by SQLite's own descriptor: to
 *  close another one would let go of its locks. */
bool isReadable(sqlite3* handle) {
  sqlite3_file* file = nullptr;
  sqlite3_int64 size = 0;
  sqlite3_file_control(handle, "main", SQLITE_FCNTL_FILE_POINTER, &file);
  if (!file || !file->pMethods || file->pMethods->xFileSize(file, &size) != SQLITE_OK) return false;
  std::array<char, 65536> bytes{};
  for (sqlite3_int64 at = 0; at < size; at += sqlite3_int64(bytes.size())) {
    const auto count = std::min(sqlite3_int64(bytes.size()), size - at);
    if (file->pMethods->xRead(file, bytes.data(), int(count), at) != SQLITE_OK) return false;
  }
  return true;
}

/** Whether SQLite, asked once more, finds nothing wrong in the whole file. */
bool isSound(sqlite3* handle) {
  std::string answer;
  const auto keep = [](void* to, int, char** values, char**) {
    *static_cast<std::string*>(to) = values[0];
    return 0;
  };
  return sqlite3_exec(handle, "PRAGMA integrity_check(1)", keep, &answer, nullptr) == SQLITE_OK &&
         answer == "ok";
}

/** Whether a file has no bytes; where it may be made, another program may just be making it. */
bool staysEmpty(const std::string& path, bool mayMake) {
  constexpr int kLooks = 20;
  for (int i = 1; mayMake && i < kLooks && sizeOf(path) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return sizeOf(path) == 0;
}

}  // namespace

Database::Database(const std::string& file, bool mayMake) : file_(file) {
  // Names such as ":memory:" and "file:x" are files like any other here.
  const std::string path = std::filesystem::absolute(file).string();
  std::error_code error;
  const std::filesystem::file_type kind = std::filesystem::status(path, error).type();
  const bool exists = kind != std::filesystem::file_type::not_found;
  if (!mayMake && !exists)
    refuse(file, "there is no such archive", "make it with 'roomgraph archive " + file + " add'");
  if (kind == std::filesystem::file_type::none)
    refuse(file, "cannot be opened (" + error.message() + ")", remedyOf(SQLITE_CANTOPEN));
  if (exists && kind != std::filesystem::file_type::regular)
    refuse(file, "is not a regular file", remedyOf(SQLITE_NOTADB));
  if (exists && staysEmpty(path, mayMake))
    refuse(file, "is empty: it may have been lost in a crash or a copy",
           "bring back a copy of it, or delete it to begin a new one");
  isNew_ = !exists;
  const std::string log = path + "-wal";
  if (exists && !mayBeWritten(path)) {
    openToRead(path, std::filesystem::exists(log));
    return;
  }
  open(path, SQLITE_OPEN_READWRITE | (mayMake ? SQLITE_OPEN_CREATE : 0));
  if (!exists || hasRoom(handle_)) return;
  sqlite3_close(handle_);
  isFull_ = true;
  openToRead(path, sizeOf(log) > 0);
}

void Database::open(const std::string& name, int flags) {
  if (sqlite3_open_v2(name.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
    const int code = handle_ ? sqlite3_extended_errcode(handle_) : SQLITE_NOMEM;
    sqlite3_close(handle_);
    refuse(file_, sqlite3_errstr(code), remedyOf(code));
  }
  sqlite3_extended_result_codes(handle_, 1);
  sqlite3_busy_timeout(handle_, 120'000);  // ms, for another program that writes
}

void Database::openToRead(const std::string& path, bool hasLog) {
  isReadOnly_ = true;
  open(readOnlyUri(path, hasLog), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

Database::~Database() {
  sqlite3_close(handle_);
  // On a full disk nothing was made: it is to be made by the next call.
  std::error_code ignored;
  if (isNew_ && sizeOf(file_) == 0) std::filesystem::remove(file_, ignored);
}

void Database::fail() const {
  const int code = sqlite3_errcode(handle_) & 0xff;
  const std::string text = sqlite3_errmsg(handle_);  // before the next question changes it
  // A disk that failed to read is damage to SQLite.
  const bool isOfDisk = code == SQLITE_CORRUPT && (!isReadable(handle_) || isSound(handle_));
  if (isOfDisk) refuse(file_, sqlite3_errstr(SQLITE_IOERR), remedyOf(SQLITE_IOERR));
  const bool isFull =
      isFull_ && (code == SQLITE_READONLY ||
                  (code == SQLITE_IOERR && sqlite3_system_errno(handle_) == ENOSPC));
  if (isFull) refuse(file_, sqlite3_errstr(SQLITE_FULL), remedyOf(SQLITE_FULL));
  refuse(file_, text, remedyOf(code));
}

void Database::run(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

bool Database::tryRun(const std::string& sql) {
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK && (code & 0xff) != SQLITE_BUSY) fail();
  return code == SQLITE_OK;
}

Statement::Statement(Database& database, const std::string& sql) : database_(database) {
  check(sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &statement_, nullptr));
}

Statement::~Statement() { sqlite3_finalize(statement_); }

void Statement::check(int code) const {
  if (code != SQLITE_OK) database_.fail();
}

void Statement::reset() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
  next_ = 1;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail();
  return code == SQLITE_ROW;
}

void Statement::bind(const std::string& value) {
  check(sqlite3_bind_text64(statement_, next_++, value.data(), value.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
}

void Statement::bind(double value) { check(sqlite3_bind_double(statement_, next_++, value)); }

void Statement::bind(std::int64_t value) { check(sqlite3_bind_int64(statement_, next_++, value)); }

void Statement::bind(const std::optional<double>& value) {
  if (value)
    bind(*value);
  else
    ++next_;  // no value is bound: null
}

std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return bytes ? std::string(bytes, std::size_t(sqlite3_column_bytes(statement_, column))) : "";
}

double Statement::number(int column) const { return sqlite3_column_double(statement_, column); }

std::optional<double> Statement::numberIfAny(int column) const {
  if (sqlite3_column_type(statement_, column) == SQLITE_NULL) return {};
  return number(column);
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

Transaction::Transaction(Database& database, Access access) : database_(database) {
  database.run(access == Access::reads ? "BEGIN" : "BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (isOpen_) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.run("COMMIT");
  isOpen_ = false;
}

}  // namespace roomgraph
