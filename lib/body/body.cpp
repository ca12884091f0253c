#include "lib/body/body.hpp"

#include <cmath>
#include <stdexcept>

namespace stationary {

Body::Body(double inertia_1, double inertia_2, double inertia_3)
    : J1(inertia_1), J2(inertia_2), J3(inertia_3) {
  const auto require = [](double value, const char* inequality) {
    if (!(value > 0.0) || !std::isfinite(value)) throw std::invalid_argument(inequality);
  };
  require(J1, "J1 > 0 and finite");
  require(J2, "J2 > 0 and finite");
  require(J3, "J3 > 0 and finite");
}

}  // namespace stationary
