// Preloaded into the program, does what its environment says:
//
//   FAULT_AT=N, FAULT_WHEN=before|half|after   kills it at the N-th of its calls that change regular files
//                     (write, fdatasync, fsync, ftruncate, rename, unlink), before it, after it, or with half
//                     of a write done
//   FAULT_UNDER=PATH  counts only files whose paths begin so
//   FAULT_LOCK=ERRNO  no lock of an open file is to be had, for that reason
//   FAULT_THREADS=N   the system begins no more than N threads of it
//   FAULT_CLOCK=K     its clock runs K times as fast, so that what is done every few seconds is done every
//                     time
#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
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

bool counts(const char* path) {
  const char* const under = std::getenv("FAULT_UNDER");
  return under == nullptr || std::strncmp(path, under, std::strlen(under)) == 0;
}

bool counts(int descriptor) {
  char name[64];
  char path[PATH_MAX] = "";
  std::snprintf(name, sizeof name, "/proc/self/fd/%d", descriptor);
  return readlink(name, path, sizeof path - 1) > 0 && counts(path);
}

bool is_when(const char* word) {
  const char* const when = std::getenv("FAULT_WHEN");
  return when != nullptr && std::strcmp(when, word) == 0;
}

/// Whether this call is the one.
template <class File>
bool struck(File file) {
  const char* const at = std::getenv("FAULT_AT");
  return at != nullptr && counts(file) && ++calls == std::atol(at);
}

[[noreturn]] void die() {
  kill(getpid(), SIGKILL);
  for (;;) pause();
}

/// run(here): the call, here where it is the one.
template <class File, class Run>
auto around(File file, const Run& run) {
  const bool here = struck(file);
  if (here && is_when("before")) die();
  const auto out = run(here);
  if (here) die();
  return out;
}

long clock_factor() {
  static const long out = [] {
    const char* const text = std::getenv("FAULT_CLOCK");
    return text == nullptr ? 1L : std::atol(text);
  }();
  return out;
}

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t count) {
  static const auto next = real<ssize_t (*)(int, const void*, size_t)>("write");
  if (!is_file(descriptor)) return next(descriptor, bytes, count);
  return around(descriptor, [&](bool here) {
    return next(descriptor, bytes, here && is_when("half") ? count / 2 : count);
  });
}
int fdatasync(int descriptor) {
  static const auto next = real<int (*)(int)>("fdatasync");
  return around(descriptor, [&](bool) { return next(descriptor); });
}
int fsync(int descriptor) {
  static const auto next = real<int (*)(int)>("fsync");
  return around(descriptor, [&](bool) { return next(descriptor); });
}
int ftruncate(int descriptor, off_t size) noexcept {
  static const auto next = real<int (*)(int, off_t)>("ftruncate");
  return around(descriptor, [&](bool) { return next(descriptor, size); });
}
int rename(const char* from, const char* to) noexcept {
  static const auto next = real<int (*)(const char*, const char*)>("rename");
  return around(to, [&](bool) { return next(from, to); });
}
int unlink(const char* path) noexcept {
  static const auto next = real<int (*)(const char*)>("unlink");
  return around(path, [&](bool) { return next(path); });
}
int fcntl(int descriptor, int command, ...) {
  static const auto next = real<int (*)(int, int, ...)>("fcntl");
  va_list rest;
  va_start(rest, command);
  void* const argument = va_arg(rest, void*);
  va_end(rest);
  const char* const reason = std::getenv("FAULT_LOCK");
  if (reason != nullptr && (command == F_OFD_SETLK || command == F_SETLK)) {
    errno = std::atoi(reason);
    return -1;
  }
  return next(descriptor, command, argument);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* argument) noexcept {
  static const auto next =
      real<int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  static std::atomic<long> begun{0};
  const char* const most = std::getenv("FAULT_THREADS");
  if (most != nullptr && ++begun > std::atol(most)) return EAGAIN;
  return next(thread, attributes, run, argument);
}
int clock_gettime(clockid_t which, timespec* out) noexcept {
  static const auto next = real<int (*)(clockid_t, timespec*)>("clock_gettime");
  const int result = next(which, out);
  const long factor = clock_factor();
  if (which != CLOCK_MONOTONIC || factor == 1) return result;
  // From the first reading on: that of a machine that has been up for days would not fit, K times.
  constexpr long second = 1'000'000'000;
  const long now = out->tv_sec * second + out->tv_nsec;
  static const long first = now;
  const long fast = first + (now - first) * factor;
  out->tv_sec = fast / second;
  out->tv_nsec = fast % second;
  return result;
}
}
