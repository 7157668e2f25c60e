#include <sqlite3.h>
#include <zlib.h>

#include <memory>
#include <new>

#include "readers.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/compressed.h"

namespace roomgraph {
namespace {

using Database = std::unique_ptr<sqlite3, int (*)(sqlite3*)>;
using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

[[noreturn]] void refuseDamaged(const std::string& file) {
  refuse(file, "its database is cut short or damaged", kSaveMapAgain);
}

/** The bytes as a database that is only read, and in which nothing but tables is believed: a view
 *  or an expression in a foreign file may be anything. They must live as long as it does. */
Database openDatabase(ByteView bytes) {
  sqlite3* handle = nullptr;
  const int code =
      sqlite3_open_v2(":memory:", &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_MEMORY, nullptr);
  Database database(handle, sqlite3_close);
  if (code != SQLITE_OK) throw std::bad_alloc();
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  constexpr int steps = 10'000'000;  // of SQLite's machine; a row takes some dozens
  sqlite3_progress_handler(
      handle, steps, [](void*) { return 1; }, nullptr);
  const auto size = sqlite3_int64(bytes.size);
  if (sqlite3_deserialize(handle, "main", const_cast<std::uint8_t*>(bytes.data), size, size,
                          SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    throw std::bad_alloc();
  return database;
}

/** At the one row of rtabmap's own figures. */
Statement rowOfMap(sqlite3* database, const std::string& file) {
  sqlite3_stmt* handle = nullptr;
  const int code = sqlite3_prepare_v2(
      database,
      "SELECT opt_map, opt_map_x_min, opt_map_y_min, opt_map_resolution FROM Admin LIMIT 1", -1,
      &handle, nullptr);
  Statement statement(handle, sqlite3_finalize);
  if (code == SQLITE_ERROR)
    refuse(file, "is an SQLite database, but none of rtabmap 0.17 or newer",
           "give a map, or save it with rtabmap's map_saver");
  if (code != SQLITE_OK) refuseDamaged(file);
  const int row = sqlite3_step(handle);
  if (row != SQLITE_ROW && row != SQLITE_DONE) refuseDamaged(file);
  if (row == SQLITE_DONE || sqlite3_column_bytes(handle, 0) == 0)
    refuse(file, "has no 2D grid, as rtabmap was not closed in good order or made none",
           "open and close it with rtabmap, or save the grid with its map_saver");
  return statement;
}

/** A length of the row [m]. */
double lengthAt(sqlite3_stmt* row, int column, double low, double high, const std::string& file) {
  const double value = decimal(float(sqlite3_column_double(row, column)));
  if (!(value >= low && value <= high))
    refuse(file, "its grid has no sensible place and resolution", kSaveMapAgain);
  return value;
}

/** Sets the size of the frame and inflates the cells. */
std::vector<std::uint8_t> unpack(ByteView packed, GridFrame& frame, const std::string& file) {
  constexpr std::size_t trailer = 3 * sizeof(std::int32_t);
  if (packed.size <= trailer) refuseDamaged(file);
  const ByteView stream{packed.data, packed.size - trailer};
  ByteReader reader({packed.data + stream.size, trailer}, file);
  const auto rows = reader.get<std::int32_t>(), columns = reader.get<std::int32_t>();
  constexpr std::int32_t signedBytes = 1;  // OpenCV's CV_8SC1
  if (reader.get<std::int32_t>() != signedBytes || rows <= 0 || columns <= 0) refuseDamaged(file);
  frame.width = columns, frame.height = rows;
  if (frame.cellCount() > kMostCells)
    refuse(file,
           "claims " + std::to_string(columns) + " x " + std::to_string(rows) +
               " cells, more than 400 million",
           "save it with a coarser resolution");
  if (frame.cellCount() / kMostInflation > stream.size) refuseDamaged(file);
  std::vector<std::uint8_t> cells(frame.cellCount());
  uLongf size = cells.size();
  uLong used = stream.size;
  if (uncompress2(cells.data(), &size, stream.data, &used) != Z_OK || size != cells.size() ||
      used != stream.size)
    refuseDamaged(file);
  return cells;
}

std::uint8_t greyOfCell(std::uint8_t cell) {
  return cell <= 100 ? greyOfPercent(cell) : 128;  // unknown: -1 is 255 here
}

}  // namespace

bool isRtabmap(CheckedFile& file) {
  constexpr char magic[] = "SQLite format 3";  // and its zero
  constexpr std::size_t idAt = 68;
  constexpr char archive[] = "rmgr";  // the application id of our archives
  const ByteView head = file.head();
  if (head.size < sizeof magic || std::memcmp(head.data, magic, sizeof magic) != 0) return false;
  return head.size < idAt + sizeof archive ||
         std::memcmp(head.data + idAt, archive, sizeof archive - 1) != 0;
}

GreyMap readRtabmap(CheckedFile& file, const LoadGridOptions&) {
  const Database database = openDatabase(file.content());
  const Statement row = rowOfMap(database.get(), file.name());
  GreyMap map;
  map.frame.origin.x = lengthAt(row.get(), 1, -kFarthestOrigin, kFarthestOrigin, file.name());
  map.frame.origin.y = lengthAt(row.get(), 2, -kFarthestOrigin, kFarthestOrigin, file.name());
  map.frame.resolution = lengthAt(row.get(), 3, kSmallestCell, kLargestCell, file.name());
  const ByteView packed{static_cast<const std::uint8_t*>(sqlite3_column_blob(row.get(), 0)),
                        std::size_t(sqlite3_column_bytes(row.get(), 0))};
  map.grey = unpack(packed, map.frame, file.name());
  for (auto& cell : map.grey) cell = greyOfCell(cell);
  return map;
}

}  // namespace roomgraph
