#include "terminal.h"

#include <cstdio>
#include <iostream>
#include <sstream>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"

namespace roomgraph {

void print(const std::string& lines) {
  std::istringstream in(lines);
  std::string whole;
  for (std::string line; std::getline(in, line);) whole += printable(line) + "\n";
  std::fputs(whole.c_str(), stdout);
  std::fflush(stdout);
}

void checkPrinted() {
  std::cout.flush();  // CLI11's help
  const bool isWhole = std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (!isWhole)
    refuse("standard output", "not all of the text could be written to it",
           "give it a place that is open and has room");
}

}  // namespace roomgraph
