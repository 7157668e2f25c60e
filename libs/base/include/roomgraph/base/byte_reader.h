#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "roomgraph/base/Error.h"

namespace roomgraph {

/** Bytes that somebody else owns. */
struct ByteView {
  const std::uint8_t* data = nullptr;  ///< the first of them
  std::size_t size = 0;                ///< how many there are

  /** A copy of them. */
  [[nodiscard]] std::string text() const { return {reinterpret_cast<const char*>(data), size}; }
};

/** Those of a text, which must outlive the result. */
[[nodiscard]] inline ByteView viewOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/** The value of that index in an array of any alignment. */
template <class T>
[[nodiscard]] T valueAt(const std::uint8_t* bytes, std::size_t index) {
  T value;
  std::memcpy(&value, bytes + index * sizeof(T), sizeof(T));
  return value;
}

/** Reads little-endian values, as MRPT streams them, and never past the end. */
class ByteReader {
 public:
  ByteReader(ByteView bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  const std::string& file() const { return file_; }                 ///< its name, for messages
  [[nodiscard]] std::size_t position() const { return position_; }  ///< bytes read
  [[nodiscard]] std::size_t left() const { return bytes_.size - position_; }  ///< bytes to come

  /** The next `count` bytes. Throws DataError where fewer are left. */
  const std::uint8_t* take(std::uint64_t count) {
    if (count > left()) refuse(file_, "it is cut short or damaged", "copy or save the map again");
    const std::uint8_t* start = bytes_.data + position_;
    position_ += static_cast<std::size_t>(count);
    return start;
  }
  [[nodiscard]] const std::uint8_t* peek() const { return bytes_.data + position_; }
  void skip(std::uint64_t count) { take(count); }  ///< as take()

  template <class T>
  T get() {
    static_assert(std::is_arithmetic_v<T>);
    return valueAt<T>(take(sizeof(T)), 0);
  }
  /** A stored bool is any byte, of which only 0 is false. */
  bool getFlag() { return get<std::uint8_t>() != 0; }
  /** A text behind its length. */
  std::string getText() {
    const auto size = get<std::uint32_t>();
    return ByteView{take(size), size}.text();
  }

 private:
  ByteView bytes_;
  std::string file_;
  std::size_t position_ = 0;
};

}  // namespace roomgraph
