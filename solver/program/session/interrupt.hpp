// Ctrl-C and SIGTERM: the first asks the computation to end cleanly, another one, unless it comes within
// half a second, ends the program.
#pragma once

#include <atomic>

namespace stationary::cli {

/// Installs the handlers and unblocks both signals; the flag becomes true at the first signal.
const std::atomic<bool>& stop_on_signals();

}  // namespace stationary::cli
