#include "python/binding/interruptible.hpp"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

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

}  // namespace

void interruptible(const std::function<void(const std::atomic<bool>& stop)>& work) {
  std::atomic<bool> stop{false};
  if (!on_main_thread()) {
    const py::gil_scoped_release released;
    work(stop);
    return;
  }
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  std::exception_ptr failure;
  std::exception_ptr signalled;
  {
    const py::gil_scoped_release released;
    std::thread worker([&] {
      try {
        work(stop);
      } catch (...) {
        failure = std::current_exception();
      }
      // Told under the lock: what is waited on lives in the other thread.
      const std::lock_guard lock(mutex);
      done = true;
      ended.notify_one();
    });
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, look_every, [&] { return done; })) {
      if (stop) continue;
      lock.unlock();
      {
        const py::gil_scoped_acquire held;
        if (PyErr_CheckSignals() != 0) {
          signalled = std::make_exception_ptr(py::error_already_set());
          stop = true;
        }
      }
      lock.lock();
    }
    lock.unlock();
    worker.join();
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
