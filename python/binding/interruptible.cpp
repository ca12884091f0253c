#include "python/binding/interruptible.hpp"

#include <cxxabi.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace stationary::python {
namespace py = pybind11;

namespace {

/// Signals are handled by this thread alone.
bool on_main_thread() {
  const py::module_ threading = py::module_::import("threading");
  return threading.attr("get_ident")().equal(threading.attr("main_thread")().attr("ident"));
}

/// How long a signal waits at most.
constexpr std::chrono::milliseconds look_every{20};

/// A thread that lives on between one work and the next, for a new one costs as much as a short work:
/// its memory is new to it.
class Worker {
 public:
  Worker() {
    std::thread([this] { serve(); }).detach();
  }
  void begin(std::function<void()> work) {
    const std::lock_guard lock(mutex_);
    work_ = std::move(work);
    changed_.notify_all();
  }
  /// Whether the work is done, by then or before.
  bool wait(std::chrono::milliseconds at_most) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, at_most, [this] { return !work_; });
  }

 private:
  [[noreturn]] void serve() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return static_cast<bool>(work_); });
      lock.unlock();
      work_();
      lock.lock();
      work_ = nullptr;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> work_;
};

/// One for the main thread while this lives; another where a handler of a signal computes meanwhile.
/// Kept for the process that began them (a child has none of their threads), until it ends.
class Hired {
 public:
  Hired() {
    if (process_ != getpid()) idle_.clear();
    process_ = getpid();
    if (idle_.empty()) {
      worker_ = new Worker;  // NOLINT(cppcoreguidelines-owning-memory)
    } else {
      worker_ = idle_.back();
      idle_.pop_back();
    }
  }
  Hired(const Hired&) = delete;
  Hired& operator=(const Hired&) = delete;
  ~Hired() { idle_.push_back(worker_); }

  Worker* operator->() const { return worker_; }

 private:
  static inline pid_t process_ = 0;
  static inline std::vector<Worker*> idle_;
  Worker* worker_;
};

}  // namespace

void WithoutLock::take(PyThreadState* state) {
#ifdef __GLIBCXX__
  try {
    PyEval_RestoreThread(state);
  } catch (const abi::__forced_unwind&) {
    for (;;) pause();
  }
#else
  PyEval_RestoreThread(state);
#endif
}

void interruptible(const std::function<void(const std::atomic<bool>& stop)>& work) {
  std::atomic<bool> stop{false};
  if (!on_main_thread()) {
    const WithoutLock released;
    work(stop);
    return;
  }
  std::exception_ptr failure;
  std::exception_ptr signalled;
  {
    const Hired worker;
    const WithoutLock released;
    worker->begin([&] {
      try {
        work(stop);
      } catch (...) {
        failure = std::current_exception();
      }
    });
    while (!worker->wait(look_every)) {
      if (stop) continue;
      const py::gil_scoped_acquire held;
      if (PyErr_CheckSignals() != 0) {
        signalled = std::make_exception_ptr(py::error_already_set());
        stop = true;
      }
    }
  }
  if (signalled) std::rethrow_exception(signalled);
  if (failure) std::rethrow_exception(failure);
}

int thread_count(std::optional<int> asked) {
  constexpr int most = 1024;
  if (!asked) return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  if (*asked < 1 || *asked > most) throw std::invalid_argument("threads from 1 to 1024");
  return *asked;
}

}  // namespace stationary::python
