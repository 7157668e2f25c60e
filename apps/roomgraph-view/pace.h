#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <string>

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

/** Does the work in a thread of its own, and returns when it is done. A window of this size [px]
 *  says meanwhile what is being done, if that takes longer than a moment; whoever closes it ends
 *  the program, so `work` should write nothing. It stays as long as what comes back is held, for
 *  another to take its place. Needs a display and nanogui::init().
 *  @throws what `work` throws. */
std::shared_ptr<void> waitBeside(const std::function<void()>& work, const std::string& words,
                                 int width, int height);

}  // namespace roomgraph
