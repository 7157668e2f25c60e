#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** A fresh folder for one test, gone with the object. */
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  /** The full name of a file in it. */
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  /** Writes the bytes and returns the file's full name. */
  std::string write(const std::string& name, const std::string& bytes) const;
  /** Names of what is in it, in alphabetical order. */
  std::vector<std::string> names() const;

 private:
  std::string path_;
};

std::string readAll(const std::string& path);

}  // namespace roomgraph
