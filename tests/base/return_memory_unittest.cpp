#include "roomgraph/base/return_memory.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

namespace roomgraph {
namespace {

constexpr std::size_t kMega = 1 << 20;

/** Memory of this process that is there [bytes]. */
[[maybe_unused]] std::size_t residentBytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t all = 0, resident = 0;
  file >> all >> resident;
  return resident * 4096;
}

TEST(ReturnMemory, whatIsFreeBetweenWhatIsInUseGoesBack) {
// A sanitizer has an allocator of its own, which keeps what is free to find its late use.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
  constexpr std::size_t kBlock = 1 << 16, kBlocks = 64 * kMega / kBlock;
  std::vector<std::unique_ptr<char[]>> passing, kept;
  for (std::size_t i = 0; i < kBlocks; ++i) {
    passing.push_back(std::make_unique<char[]>(kBlock));
    std::memset(passing.back().get(), 1, kBlock);
    kept.push_back(std::make_unique<char[]>(64));
  }
  passing.clear();
  const std::size_t before = residentBytes();
  returnMemory();
  EXPECT_LT(residentBytes() + 32 * kMega, before);
#else
  returnMemory();
#endif
}

/** Ends well where \p threads call returnMemory() for the first time of their process at once. */
void callAtOnce(std::size_t threads) {
  std::atomic<std::size_t> there{0};
  std::vector<std::thread> calls;
  for (std::size_t i = 0; i < threads; ++i) {
    calls.emplace_back([&] {
      ++there;
      while (there < threads) std::this_thread::yield();
      returnMemory();
    });
  }
  for (std::thread& call : calls) call.join();
  std::_Exit(0);
}

// In a program of its own, since only the first call of all is at risk, beside another allocator.
TEST(ReturnMemoryDeathTest, manyThreadsMayCallItFirst) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  for (int i = 0; i < 5; ++i) EXPECT_EXIT(callAtOnce(8), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace roomgraph
