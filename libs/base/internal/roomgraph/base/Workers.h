#pragma once
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace roomgraph {

/** Threads that do some jobs, each the next that none of them has taken. Where a job throws, no
 *  further job begins. */
class Workers {
 public:
  /** As many as asked for, 0 standing for one per core, or as the system has left; where it has
   *  none, all work is done at once. */
  Workers(std::size_t threads, std::size_t count, std::function<void(std::size_t)> job)
      : count_(count), job_(std::move(job)) {
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    try {
      while (threads_.size() < std::min(threads, count)) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      if (threads_.empty()) work();
    }
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  /** Lets no further job begin. */
  ~Workers() {
    skipRest();
    for (std::thread& thread : threads_) thread.join();
  }

  /** Calls `tell(done)` as jobs get done or are skipped, and each 0.1 s, until all are; then throws
   *  what the first of those jobs that threw has thrown. */
  template <class Tell>
  void wait(const Tell& tell) {
    for (std::size_t told = 0; told < count_; tell(told)) {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait_for(lock, std::chrono::milliseconds(100), [&] { return done_ > told; });
      told = done_;
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < count_; i = next_++) {
      std::exception_ptr failure;
      try {
        job_(i);
      } catch (...) {
        failure = std::current_exception();
      }
      if (failure) skipRest();
      const std::lock_guard<std::mutex> lock(mutex_);
      ++done_;
      if (failure && (!failure_ || i < failed_)) failure_ = failure, failed_ = i;
      changed_.notify_all();
    }
  }

  void skipRest() {
    const std::size_t skipped = count_ - std::min(count_, next_.exchange(count_));
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ += skipped;
  }

  const std::size_t count_;
  const std::function<void(std::size_t)> job_;
  std::atomic<std::size_t> next_{0};
  std::size_t done_ = 0;
  std::exception_ptr failure_;
  std::size_t failed_ = 0;  ///< the job that threw it
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::thread> threads_;
};

}  // namespace roomgraph
