#pragma once
#include <cstdint>
#include <string>

namespace roomgraph {

/** A regular file that is open for reading. Pipes and devices, which may have no end or never
 *  answer, are refused at once. */
class InputFile {
 public:
  /** @throws DataError with one line (file, problem, remedy) where there is no such regular file,
   *  or it has more than `most` bytes. */
  InputFile(const std::string& name, std::uint64_t most);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  const std::string& name() const { return name_; }  ///< as the caller gave it
  /** When it was opened. */
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /** Copies `count` bytes from `offset` on. @throws DataError where there are fewer. */
  void read(std::uint64_t offset, void* to, std::size_t count) const;

 private:
  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/** More than any text that roomgraph reads has. */
constexpr std::uint64_t kLargestText = 200'000'000;

/** All bytes of a regular file that has at most `most`. @throws DataError like InputFile. */
[[nodiscard]] std::string readFile(const std::string& name, std::uint64_t most = kLargestText);

}  // namespace roomgraph
