#include "ProgressBar.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace roomgraph {

ProgressBar::ProgressBar(std::size_t total, bool isWanted)
    : total_(total), isWanted_(isWanted && total > 0 && isatty(STDERR_FILENO) != 0) {}

void ProgressBar::show(std::size_t done) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  if (!isWanted_ || elapsed.count() < 1) return;
  constexpr std::size_t kWidth = 40;
  const std::size_t filled = done * kWidth / total_;
  std::fprintf(stderr, "\r[%s%s] %3d %% %4.0f s", std::string(filled, '#').c_str(),
               std::string(kWidth - filled, ' ').c_str(), int(done * 100 / total_),
               elapsed.count());
  std::fflush(stderr);
  isShown_ = true;
}

void ProgressBar::clear() {
  if (isShown_) std::fputs("\r\x1b[K", stderr);
  isShown_ = false;
}

}  // namespace roomgraph
