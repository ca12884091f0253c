# Fails where an object of the libraries needs an elementary function of the C library, whose last
# digit is another on another processor (lib/number/elementary.hpp), or a division of complex
# numbers of the compiler's run-time, whose products it may have fused there. What remains of these
# runs is rounded everywhere alike. Nor Eigen's own, of arrays (lib/matrix/elementwise.hpp).
set(functions exp exp2 expm1 log log1p log2 log10 pow sin cos sincos tan asin acos atan atan2
  sinh cosh tanh asinh acosh atanh hypot cbrt fma erf erfc tgamma lgamma
  cabs carg csqrt cexp clog cpow __divsc3 __divdc3 __divxc3 __divtc3 __mulxc3 __multc3)
# Ceres' numbers call them, on the way to a start that Newton's method forgets; Eigen divides for eigenvectors
# that nobody asks for.
set(others "ceres_solve\\.[^ ]*: +U |root_discs\\.[^ ]*: +U __divdc3")

set(found "")
foreach(library IN LISTS libraries)
  execute_process(COMMAND ${nm} -A ${library} OUTPUT_VARIABLE symbols ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" symbols "${symbols}")
  if(NOT symbols MATCHES " U ")
    message(FATAL_ERROR "${nm} says nothing of ${library}")
  endif()
  set(needed ${symbols})
  list(FILTER needed INCLUDE REGEX "5Eigen8internal[0-9]+(p(exp|log|log1p|log2|log10|expm1|sin|cos|tanh|atan|pow)_|generic_pow)")
  list(FILTER needed EXCLUDE REGEX ":ceres_solve\\.")
  list(APPEND found ${needed})
  foreach(function IN LISTS functions)
    set(needed ${symbols})
    list(FILTER needed INCLUDE REGEX " U ${function}[fl]?$")
    list(FILTER needed EXCLUDE REGEX ":(${others})")
    list(APPEND found ${needed})
  endforeach()
endforeach()
if(found)
  list(JOIN found "\n" found)
  message(FATAL_ERROR "Elementary functions of the C library or of Eigen, not of lib/number:\n${found}")
endif()
