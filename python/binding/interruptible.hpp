// Long work without the interpreter's lock, which Ctrl-C ends.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

namespace stationary::python {

/// Runs work(stop) without the lock. Called by the interpreter's main thread the work has a thread of
/// its own, and the main one looks for signals meanwhile: where one raises an exception `stop`
/// becomes true, the end of the work is waited for, and the exception is thrown. Other threads do
/// the work themselves. Throws what the work throws.
void interruptible(const std::function<void(const std::atomic<bool>& stop)>& work);

/// How many threads are asked for; nothing: as many as there are processors. Throws
/// std::invalid_argument for less than 1 or more than 1024.
int thread_count(std::optional<int> asked);

}  // namespace stationary::python
