#include <gtest/gtest.h>

#include "MapText.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph::test {
namespace {

/** The codes of all notes, with a blank behind each. */
std::string notesOf(const GreyMap& map) {
  std::string codes;
  for (const Note& note : extract(map, {}).notes) codes += note.code + " ";
  return codes;
}

std::string notesOf(const std::vector<std::string>& rows) {
  return notesOf(greyMap(drawn(rows, 0.1)));
}

TEST(ExtractionNotes, tellThatAMapWithoutCellsHasNoFreeOne) {
  GreyMap map;
  map.frame = {0, 0, 0.1, {}};
  EXPECT_EQ(notesOf(map), "no_free_cell ");
  EXPECT_EQ(notesOf({"###", "###"}), "no_free_cell ");
}

TEST(ExtractionNotes, tellThatNothingStandsInTheWay) {
  EXPECT_EQ(notesOf({"....", "....", "...."}), "no_obstacle ");
}

TEST(ExtractionNotes, tellThatNoPathIsWideEnough) {
  const GreyMap walls = greyMap(drawn({"###", "#.#", "###"}, 0.1));
  const GreyMap unknown = greyMap(drawn({"???", "?.?", "???"}, 0.1));
  EXPECT_EQ(notesOf(walls), "no_path ");
  EXPECT_EQ(notesOf(unknown), "no_path ");
  EXPECT_NE(extract(walls, {}).notes[0].text.find("exchanged"), std::string::npos);
  EXPECT_EQ(extract(unknown, {}).notes[0].text.find("exchanged"), std::string::npos);
}

TEST(ExtractionNotes, tellThatFreeFloorRunsOutOfTheMap) {
  std::vector<std::string> rows(60, std::string(29, '.') + '#' + std::string(30, '.'));
  EXPECT_EQ(notesOf(rows), "open_edge ");
  for (std::string& row : rows) row.front() = row.back() = '?';
  rows.front() = rows.back() = std::string(60, '?');
  EXPECT_EQ(notesOf(rows).find("open_edge"), std::string::npos);
}

TEST(ExtractionNotes, haveNothingToSayOfARoom) {
  std::vector<std::string> rows(60, '#' + std::string(58, '.') + '#');
  rows.front() = rows.back() = std::string(60, '#');
  EXPECT_EQ(notesOf(rows), "");
}

}  // namespace
}  // namespace roomgraph::test
