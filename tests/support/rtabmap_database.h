#pragma once
#include <string>

namespace roomgraph::test {

/** A matrix as rtabmap packs it; `type` is OpenCV's, 1 for signed bytes. */
std::string packedMatrix(const std::string& cells, int rows, int columns, int type = 1);

/** The bytes as an SQL literal. */
std::string sqlBlob(const std::string& bytes);

/** The bytes of an SQLite database that the statements make. */
std::string sqliteDatabase(const std::string& sql);

/** The table of rtabmap that holds the grid, with those of its columns that stand round it. */
extern const char* const kRtabmapAdmin;

/** A database of rtabmap with a grid, both in SQL; `place` is x, y and resolution. */
std::string rtabmapDatabase(const std::string& grid,
                            const std::string& place = "-1.5, 2, 0.05000000075");

}  // namespace roomgraph::test
