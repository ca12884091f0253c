// Objects of the HDF5 library that close themselves.
#pragma once

#include <hdf5.h>

#include <utility>

namespace stationary {

/// An object of HDF5's, closed with this. Negative: none.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  bool valid() const { return id_ >= 0; }
  hid_t id() const { return id_; }
  /// Closes now; whether that went well.
  bool close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id < 0 || close_(id) >= 0;
  }

 private:
  hid_t id_;
  Close close_;
};

/// Before anything else of HDF5 is called, its version too: the first call lays its exit
/// handler. What it would print on standard error is said in exceptions instead; and
/// its exit handler is left out, which fails on a file that a full disk kept it from closing.
/// Whether it prints every thread has for itself, and rows come from several.
inline void silence_hdf5() {
  static const bool without_handler = H5dont_atexit() >= 0;
  (void)without_handler;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace stationary
