#include "PythonThreads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace roomgraph {
namespace {

namespace py = pybind11;

class Jobs {
 public:
  Jobs(std::size_t count, const std::function<void(std::size_t)>& job) : count_(count), job_(job) {}

  /** What each thread does: takes the next job until none is left. */
  void work() {
    for (std::size_t i = next_++; i < count_; i = next_++) {
      std::exception_ptr failure;
      try {
        job_(i);
      } catch (...) {
        failure = std::current_exception();
      }
      const std::lock_guard<std::mutex> lock(mutex_);
      ++done_;
      if (failure) stop(failure);
      changed_.notify_all();
    }
  }

  /** Calls `tell(done)` as jobs get done, and each 0.1 s, until all are. */
  template <class Tell>
  void wait(const Tell& tell) {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!failure_ && done_ < count_) {
      changed_.wait_for(lock, std::chrono::milliseconds(100));
      const std::size_t done = done_;
      lock.unlock();
      std::exception_ptr failure;
      try {
        tell(done);
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      if (failure) stop(failure);
    }
  }

  /** To be called when no thread is left. */
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void stop(const std::exception_ptr& failure) {
    next_ = count_;
    if (!failure_) failure_ = failure;
  }

  const std::size_t count_;
  const std::function<void(std::size_t)>& job_;
  std::atomic<std::size_t> next_{0};
  std::size_t done_ = 0;
  std::exception_ptr failure_;
  std::mutex mutex_;
  std::condition_variable changed_;
};

/** As many as asked for, or as the system has left; where it has none, all work is done at once. */
std::vector<std::thread> startThreads(Jobs& jobs, std::size_t count) {
  std::vector<std::thread> threads;
  try {
    for (std::size_t i = 0; i < count; ++i) threads.emplace_back([&jobs] { jobs.work(); });
  } catch (const std::system_error&) {
    if (threads.empty()) jobs.work();
  }
  return threads;
}

}  // namespace

ForEach onPythonThreads(unsigned threads, const py::object& progress) {
  const std::size_t most = threads ? threads : std::max(1u, std::thread::hardware_concurrency());
  return [most, &progress](std::size_t count, const std::function<void(std::size_t)>& job) {
    Jobs jobs(count, job);
    std::vector<std::thread> workers = startThreads(jobs, std::min(most, count));
    std::size_t told = count + 1;
    jobs.wait([&](std::size_t done) {
      const py::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress.is_none() && done != told) progress(told = done, count);
    });
    for (std::thread& worker : workers) worker.join();
    jobs.rethrow();
  };
}

}  // namespace roomgraph
