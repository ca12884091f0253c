// Preloaded into the program: kills it at the FAULT_AT-th of its calls that change regular files (write,
// fdatasync, fsync, ftruncate, rename, unlink): before it, after it, or with half of a write done. Its clock
// runs ten thousand times as fast, so that what is done every few seconds is done every time.
#include <dlfcn.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>

namespace {

std::atomic<long> calls{0};

template <class Call>
Call real(const char* name) {
  return reinterpret_cast<Call>(dlsym(RTLD_NEXT, name));
}

bool is_file(int descriptor) {
  struct stat status {};
  return descriptor > STDERR_FILENO && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

bool is_when(const char* word) {
  const char* const when = std::getenv("FAULT_WHEN");
  return when != nullptr && std::strcmp(when, word) == 0;
}

/// Whether this call is the one.
bool struck() {
  const char* const at = std::getenv("FAULT_AT");
  return at != nullptr && ++calls == std::atol(at);
}

[[noreturn]] void die() {
  kill(getpid(), SIGKILL);
  for (;;) pause();
}

template <class Run>
auto around(const Run& run) {
  const bool here = struck();
  if (here && is_when("before")) die();
  const auto out = run();
  if (here) die();
  return out;
}

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t count) {
  static const auto next = real<ssize_t (*)(int, const void*, size_t)>("write");
  if (!is_file(descriptor)) return next(descriptor, bytes, count);
  return around([&] { return next(descriptor, bytes, is_when("half") ? count / 2 : count); });
}
int fdatasync(int descriptor) {
  static const auto next = real<int (*)(int)>("fdatasync");
  return around([&] { return next(descriptor); });
}
int fsync(int descriptor) {
  static const auto next = real<int (*)(int)>("fsync");
  return around([&] { return next(descriptor); });
}
int ftruncate(int descriptor, off_t size) noexcept {
  static const auto next = real<int (*)(int, off_t)>("ftruncate");
  return around([&] { return next(descriptor, size); });
}
int rename(const char* from, const char* to) noexcept {
  static const auto next = real<int (*)(const char*, const char*)>("rename");
  return around([&] { return next(from, to); });
}
int unlink(const char* path) noexcept {
  static const auto next = real<int (*)(const char*)>("unlink");
  return around([&] { return next(path); });
}
int clock_gettime(clockid_t which, timespec* out) noexcept {
  static const auto next = real<int (*)(clockid_t, timespec*)>("clock_gettime");
  const int result = next(which, out);
  if (which == CLOCK_MONOTONIC) out->tv_sec *= 10'000;
  if (which == CLOCK_MONOTONIC) out->tv_sec += out->tv_nsec / 100'000;
  return result;
}
}
