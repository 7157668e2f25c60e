#include "rtabmap_database.h"

#include <sqlite3.h>
#include <zlib.h>

#include <cstdint>
#include <memory>
#include <stdexcept>

namespace roomgraph::test {

std::string packedMatrix(const std::string& cells, int rows, int columns, int type) {
  std::string bytes(compressBound(cells.size()), '\0');
  uLongf size = bytes.size();
  compress(reinterpret_cast<Bytef*>(bytes.data()), &size,
           reinterpret_cast<const Bytef*>(cells.data()), cells.size());
  bytes.resize(size);
  for (const std::int32_t value : {rows, columns, type})
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

std::string sqlBlob(const std::string& bytes) {
  std::string text;
  for (const unsigned char byte : bytes)
    text += "0123456789abcdef"[byte >> 4], text += "0123456789abcdef"[byte & 15];
  return "x'" + text + "'";
}

std::string sqliteDatabase(const std::string& sql) {
  sqlite3* handle = nullptr;
  sqlite3_open(":memory:", &handle);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> database(handle, sqlite3_close);
  if (sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    throw std::runtime_error(sqlite3_errmsg(handle));
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> bytes(
      sqlite3_serialize(handle, "main", &size, 0), sqlite3_free);
  return {reinterpret_cast<const char*>(bytes.get()), std::size_t(size)};
}

const char* const kRtabmapAdmin =
    "CREATE TABLE Admin (version TEXT, preview_image BLOB, opt_map BLOB, opt_map_x_min FLOAT, "
    "opt_map_y_min FLOAT, opt_map_resolution FLOAT, time_enter DATE);";

std::string rtabmapDatabase(const std::string& grid, const std::string& place) {
  return sqliteDatabase(kRtabmapAdmin +
                        ("INSERT INTO Admin VALUES ('0.21.4', NULL, " + grid + ", " + place) +
                        ", NULL);");
}

}  // namespace roomgraph::test
