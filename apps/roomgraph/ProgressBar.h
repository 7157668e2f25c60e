#pragma once
#include <chrono>
#include <cstddef>

namespace roomgraph {

/** A bar on stderr that shows how much of a long piece of work is done. Silent where stderr is no
 *  terminal, and during the first second. Used by one thread. */
class ProgressBar {
 public:
  ProgressBar(std::size_t total, bool isWanted);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done);
  /** Takes the bar off the screen, so that other lines can be printed. */
  void clear();

 private:
  std::size_t total_;
  bool isWanted_, isShown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace roomgraph
