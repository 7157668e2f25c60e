#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace roomgraph::test {

/** docs/scoring.md and docs/method.md on one line. */
inline std::string scoringDocument() {
  std::ostringstream text;
  for (const char* name : {"scoring.md", "method.md"})
    text << std::ifstream(std::string(ROOMGRAPH_DOCS) + name).rdbuf();
  std::string line = text.str();
  std::replace(line.begin(), line.end(), '\n', ' ');
  line.erase(
      std::unique(line.begin(), line.end(), [](char l, char r) { return l == ' ' && r == ' '; }),
      line.end());
  return line;
}

/** Whether the document has this text, with these figures where the format asks for some. */
template <class... Figures>
void expectSaid(const char* format, Figures... figures) {
  char text[300];
  std::snprintf(text, sizeof text, format, figures...);
  EXPECT_NE(scoringDocument().find(text), std::string::npos) << text;
}

inline double degrees(double angle) { return std::round(angle * 1800 / M_PI) / 10; }

}  // namespace roomgraph::test
