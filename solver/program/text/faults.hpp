// Wrong input, gathered: whoever reads goes on where one fault does not hide the next, and all are told
// at once, in the order of the file.
#pragma once

#include <string_view>
#include <vector>

#include "solver/program/text/input_error.hpp"

namespace stationary {

class Faults {
 public:
  /// Runs a check and keeps the InputError it throws; whether it threw none.
  template <class Check>
  bool collect(const Check& check) {
    try {
      check();
      return true;
    } catch (const InputError& fault) {
      add(fault);
      return false;
    }
  }
  void add(const InputError& fault) { all_.push_back(fault); }

  /// Whether nothing is known against a dotted key, the tables it stands in, and what stands in it.
  bool sound(std::string_view key) const;
  bool empty() const { return all_.empty(); }
  /// Throws all of them as one, if there are any.
  void raise() const;

 private:
  std::vector<InputError> all_;
};

}  // namespace stationary
