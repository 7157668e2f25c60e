#pragma once
#include <chrono>

namespace roomgraph {

/** Tells at most so often that a time has passed. */
class Beat {
 public:
  explicit Beat(double seconds) : length_(seconds) {}
  bool isDue() {
    const auto now = std::chrono::steady_clock::now();
    if (std::chrono::duration<double>(now - last_).count() < length_) return false;
    last_ = now;
    return true;
  }

 private:
  double length_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace roomgraph
