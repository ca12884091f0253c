// The lock on a file that one run alone writes: of two runs only one has it, on this machine or on another
// that sees the same file. It is a lock of fcntl() on the open file, which NFS has too; it goes with the
// process, however that ends.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stationary {

/// Takes the lock on an open file; nothing, or why it cannot be had: "another run is writing it", "its
/// file system (nfs, mounted nolock) has no locks that other machines see".
std::optional<std::string> lock_file(int descriptor);

/// Of /proc/self/mountinfo the line of a device, "MAJOR:MINOR": why locks there hold on one machine
/// only; nothing where they hold, or where it is no file system of several machines.
std::optional<std::string> only_local_locks(std::string_view mounts, std::string_view device);

/// Whether a path still names the file that is open.
bool is_at(int descriptor, const std::string& path);

}  // namespace stationary
