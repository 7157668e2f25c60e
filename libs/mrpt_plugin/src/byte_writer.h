#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace roomgraph {

/** Appends little-endian values, as MRPT streams them and ByteReader reads them. */
class ByteWriter {
 public:
  template <class T>
  void put(T value) {
    static_assert(std::is_arithmetic_v<T>);
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    bytes_.append(bytes, sizeof(T));
  }
  void putCount(std::size_t count) { put(static_cast<std::uint32_t>(count)); }
  void putText(const std::string& text) {
    putCount(text.size());
    bytes_ += text;
  }
  std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace roomgraph
