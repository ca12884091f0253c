#include "solver/motion/problem.hpp"

#include <string>

namespace stationary {
namespace {

ThicknessRule thickness_rule(const Potential& potential, Branch branch) {
  if (!potential.is_separable()) return ThicknessRule::coupled;
  return branch == Branch::iii ? ThicknessRule::constant : ThicknessRule::closed_form;
}

/// Of the plan: what is in balance.
std::string forces(bool elastic, bool gravity, bool pressure) {
  std::vector<std::string> all;
  if (elastic) all.emplace_back("elastic");
  all.emplace_back("centrifugal force");
  if (gravity) all.emplace_back("gravity");
  if (pressure) all.emplace_back("pressure");
  std::string out = "balance of " + all.front();
  for (std::size_t k = 1; k < all.size(); ++k)
    out += (k + 1 < all.size() ? ", " : " and ") + all[k];
  return out;
}

/// Of a potential that is not isotropic.
std::vector<PlanItem> oriented_plan(const AnisotropicPotential& V, Branch branch) {
  std::vector<PlanItem> plan;
  const bool even = V.even_in_alpha();
  const bool known = V.sheared();
  if (branch != Branch::iii) {
    plan.push_back(
        {"alpha", "0, not an unknown",
         V.shear_free() ? "compatibility (J1 xi + J2 zeta) alpha = 0 leaves no other value"
         : known        ? "compatibility leaves no other value, and V_alpha != 0 there: such a "
                          "motion exists by chance only"
                        : "compatibility leaves no other value, and V_alpha is not known to vanish "
                          "there: such a motion may exist by chance only"});
  } else {
    plan.push_back({"alpha", even ? "0 from rest; an unknown from another start" : "an unknown",
                    even    ? "V is even in alpha: alpha = 0 solves its equation"
                    : known ? "V_alpha != 0 at alpha = 0"
                            : "V is not even in alpha, or not known to be"});
  }
  plan.push_back({"rho", V.body().volume ? "volume/d, an unknown to the solver" : "an unknown",
                  V.body().volume       ? "det S is held; the pressure is the multiplier of that"
                  : V.body().gravitates ? "gravity couples it to xi, zeta and alpha"
                  : V.is_separable()
                      ? "its equation has no other unknown in it; a search takes it apart"
                      : "the potential couples it to xi, zeta and alpha"});
  plan.push_back(
      {"xi, zeta",
       branch == Branch::iii && !even ? "4 equations with alpha and rho" : "3 equations with rho",
       forces(true, V.body().gravitates, V.body().volume.has_value())});
  return plan;
}

std::vector<PlanItem> make_plan(const Body& body, const Potential& potential, Branch branch,
                                ThicknessRule rule) {
  if (!potential.is_isotropic()) return oriented_plan(potential.anisotropic(), branch);
  std::vector<PlanItem> plan;
  if (branch != Branch::iii) {
    plan.push_back({"alpha", "0, not an unknown",
                    "compatibility (J1 xi + J2 zeta) alpha = 0 leaves no other value"});
  } else if (!body.symmetric()) {
    plan.push_back({"alpha", "0, not an unknown",
                    "isotropic potential and J1 != J2: the spin lies along a principal axis"});
  } else {
    plan.push_back({"alpha", "0, not an unknown",
                    "J1 = J2 and an isotropic potential: material rotations are a symmetry, "
                    "solutions come in circles and theta = 0 is chosen"});
  }
  const bool closed = potential.is_built_in();
  switch (rule) {
    case ThicknessRule::constant:
      plan.push_back(
          {"rho", closed ? "closed form, once for all nu" : "1 equation, from the rest thickness",
           "separable potential; V_rho'(rho) = 0 has no nu in it"});
      break;
    case ThicknessRule::closed_form:
      plan.push_back({"rho",
                      closed ? "closed form, corrected in extended precision"
                             : "1 equation, from the rest thickness",
                      "separable potential: V_rho'(rho) = J3 nu^2 rho has no xi, zeta in it"});
      break;
    case ThicknessRule::coupled:
      if (potential.holds_volume()) {
        plan.push_back({"rho", "volume/(xi zeta), an unknown to the solver",
                        "det S is held; the pressure is the multiplier of that"});
      } else {
        plan.push_back({"rho", "an unknown",
                        potential.body_model() != nullptr && potential.body_model()->gravitates
                            ? "gravity couples it to xi and zeta"
                            : "the potential couples it to xi and zeta"});
      }
      break;
  }
  const auto* const own = potential.body_model();
  plan.push_back({"xi, zeta",
                  rule == ThicknessRule::coupled ? "3 equations with rho" : "2 equations",
                  forces(own == nullptr || !own->elastic.is_fluid(),
                         own != nullptr && own->gravitates, potential.holds_volume())});
  return plan;
}

}  // namespace

Problem::Problem(const Body& body, const Potential& potential, Branch branch)
    : body_(body),
      potential_(potential),
      branch_(branch),
      thickness_rule_(stationary::thickness_rule(potential, branch)),
      plan_(make_plan(body, potential, branch, thickness_rule_)) {}

bool mirror_symmetric(const Problem& problem, double nu) {
  if (!problem.potential().is_isotropic()) return false;
  const BodyModel<>* body = problem.potential().body_model();
  const bool sees_no_axes = body == nullptr || body->isotropic();
  return (nu == 0.0 && sees_no_axes) ||
         (problem.branch() == Branch::iii && problem.body().symmetric());
}

}  // namespace stationary
