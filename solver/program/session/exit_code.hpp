// What the program tells a script.
#pragma once

namespace stationary::cli {

enum class ExitCode : int {
  done = 0,
  wrong_input = 2,
  no_equilibrium = 3,  ///< none exists, or none was found
  failure = 4,         ///< numerical, or of the machine
  interrupted = 130
};

}  // namespace stationary::cli
