#pragma once
#include <string>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** Made by hand: two rooms of 4 m x 4 m side by side, with a door between them, and a dead end that
 *  leaves the right one on a bent way; cells of 0.1 m. The left room has a hole. All kinds of
 *  vertices occur, two parallel edges and a self loop; two rooms and a corridor as areas, and a
 *  piece of clutter. */
Stages sampleStages();

/** The same map through the whole pipeline. */
Stages extractedStages();

/** A fresh folder for one test, gone with the object. */
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  /** Names of what is in it, in alphabetical order. */
  std::vector<std::string> names() const;

 private:
  std::string path_;
};

std::string readAll(const std::string& path);

}  // namespace roomgraph
