#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace roomgraph::test {

/** Turns the bytes of a fuzzer into choices. Once they have run out, all choices are the first. */
class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  std::uint8_t byte() { return next_ < end_ ? *next_++ : 0; }
  /** From 0 to count - 1. */
  unsigned below(unsigned count) { return (byte() * 256u + byte()) % count; }
  bool flag() { return (byte() & 1) != 0; }
  template <class Value, std::size_t N>
  const Value& oneOf(const Value (&values)[N]) {
    return values[below(unsigned(N))];
  }
  /** All that is left. */
  std::string rest() {
    const std::string all(next_, end_);
    next_ = end_;
    return all;
  }
  bool isEmpty() const { return next_ == end_; }

 private:
  const std::uint8_t *next_, *end_;
};

}  // namespace roomgraph::test
