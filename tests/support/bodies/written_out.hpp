// The built-in planar and coupled models as a user would write them out, each in other variables.
#pragma once

#include <string_view>
#include <vector>

namespace stationary::testing {

struct WrittenOut {
  std::string_view model;
  std::string_view expression;
  std::vector<std::string_view> parameters;  ///< of the model and, in this order, of the expression
  std::vector<std::string_view> renamed;
  bool coupled = false;
};

inline const std::vector<WrittenOut>& written_out_models() {
  static const std::vector<WrittenOut> all{
      {"reciprocal-determinant", "c/d + k/2*I1", {"c", "k"}, {"c", "k"}},
      {"saint-venant-kirchhoff",
       "mu*(I1^2 - 2*d^2 - 2*I1 + 2)/4 + la/8*(I1 - 2)^2",
       {"mu", "lambda"},
       {"mu", "la"}},
      {"biot", "mu*(I1 - 2*t + 2) + la/2*(t - 2)^2", {"mu", "lambda"}, {"mu", "la"}},
      {"biot-log",
       "mu*((lambda - 1)^2 + (mu_ - 1)^2) + la/2*log(lambda*mu_)^2",
       {"mu", "lambda"},
       {"mu", "la"}},
      {"neo-hookean",
       "mu/2*(xi^2 + 2*alpha^2 + zeta^2 - 2 - 2*log(xi*zeta - alpha^2)) + la/2*log(d)^2",
       {"mu", "lambda"},
       {"mu", "la"}},
      {"hencky", "mu*(log(lambda)^2 + log(mu_)^2) + la/2*log(d)^2", {"mu", "lambda"}, {"mu", "la"}},
      {"neo-hookean-3d",
       "mu/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + la/2*log(d*rho)^2",
       {"mu", "lambda"},
       {"mu", "la"},
       true}};
  return all;
}

}  // namespace stationary::testing
