// The lock on a journal: of two runs only one has it, on this machine or on another that sees the same
// file. It is a lock of fcntl() on the open file, which NFS has too; it goes with the process, however
// that ends. Where a file system has no locks, or locks that only this machine knows of, the journal is
// refused.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stationary::cli {

/// Takes the lock on an open file; nothing, or why it cannot be had: "another run is writing it", "its
/// file system (nfs, mounted nolock) has no locks that other machines see".
std::optional<std::string> lock_journal(int descriptor);

/// Of /proc/self/mountinfo the line of a device, "MAJOR:MINOR": why locks there hold on one machine
/// only; nothing where they hold, or where it is no file system of several machines.
std::optional<std::string> only_local_locks(std::string_view mounts, std::string_view device);

}  // namespace stationary::cli
