#include "lib/material/material_coordinates.hpp"

#include <algorithm>
#include <cmath>

#include "lib/number/double_double_functions.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

bool is_fluid(const Potential& potential) {
  const BodyModel<>* body = potential.body_model();
  if (body == nullptr) return false;
  if (body->elastic.is_fluid()) return true;
  const auto elastic = with_indexed_coefficients(
      body->elastic, [](double value, std::size_t) { return DoubleDouble(value); });
  const double unit = body->volume ? cube_root(*body->volume) : 1.0;
  int defined = 0;
  for (const double first : {0.83, 1.29, 2.17}) {
    for (const double second : {0.71, 1.13}) {
      const DoubleDouble xi(unit * first);
      const DoubleDouble zeta(unit * second);
      const DoubleDouble rho =
          body->volume ? DoubleDouble(*body->volume) / (xi * zeta) : DoubleDouble(0.93 * unit);
      const DoubleDouble none(0.0);
      const auto force = elastic.log_balance(xi, zeta, rho, none, none, none);
      const double size = std::abs(double(force.g_xi)) + std::abs(double(force.g_zeta)) +
                          std::abs(double(force.g_rho));
      if (!std::isfinite(size)) continue;
      const double apart = std::max(std::abs(double(force.g_xi - force.g_rho)),
                                    std::abs(double(force.g_zeta - force.g_rho)));
      if (apart > 0x1p-70 * size) return false;
      ++defined;
    }
  }
  constexpr int enough = 3;
  return defined >= enough;
}

Body round_body(const Body& body) {
  const double product = body.J1 * body.J2 * body.J3;
  double s = cube_root(product);
  if (!std::isnormal(product)) {  // beyond the range of doubles, which their mean is not
    const int scale = -std::ilogb(std::max({body.J1, body.J2, body.J3}));
    const auto scaled = [scale](double J) { return std::ldexp(J, scale); };
    s = std::ldexp(
        cube_root(scaled(body.J1)) * cube_root(scaled(body.J2)) * cube_root(scaled(body.J3)),
        -scale);
  }
  return Body(s, s, s);
}

MaterialCoordinates coordinates_of(const Body& body) {
  const double s = round_body(body).J1;
  return {{std::sqrt(s / body.J1), std::sqrt(s / body.J2), std::sqrt(s / body.J3)}};
}

}  // namespace stationary
