// Long work without the interpreter's lock, which Ctrl-C ends.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <optional>

namespace stationary::python {

/// The interpreter's lock is let go while this lives. A thread that waits for the lock of an interpreter that
/// has ended is ended by unwinding, through what does not let it pass: it sleeps until the process is gone
/// instead, as threads of later Pythons do.
class WithoutLock {
 public:
  WithoutLock() : state_(PyEval_SaveThread()) {}
  WithoutLock(const WithoutLock&) = delete;
  WithoutLock& operator=(const WithoutLock&) = delete;
  ~WithoutLock() { take(state_); }

 private:
  static void take(PyThreadState* state);

  PyThreadState* state_;
};

/// Runs work(stop) without the lock. Called by the interpreter's main thread the work has a thread of
/// its own, and the main one looks for signals meanwhile: where one raises an exception `stop`
/// becomes true, the end of the work is waited for, and the exception is thrown. Other threads do
/// the work themselves. Throws what the work throws.
void interruptible(const std::function<void(const std::atomic<bool>& stop)>& work);

/// How many threads are asked for; nothing: as many as there are processors. Throws
/// std::invalid_argument for less than 1 or more than 1024.
int thread_count(std::optional<int> asked);

}  // namespace stationary::python
