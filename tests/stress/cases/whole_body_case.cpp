#include "tests/stress/cases/whole_body_case.hpp"

#include <algorithm>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "lib/balance/tilted_balance.hpp"
#include "lib/stability/general_spectrum.hpp"
#include "solver/proof/tilted_enclosure.hpp"
#include "solver/solve/stability.hpp"
#include "solver/solve/tilted_equilibrium.hpp"

namespace stationary::stress {
namespace {

using testing::Number50;
using Three = std::array<Number50, 3>;

struct WholeBody {
  Body body{1.0, 1.0, 1.0};
  std::optional<Potential> elastic;  ///< none: a fluid
  double g = 0.0;
  std::optional<double> volume;
  std::optional<TiltPlane> plane;  ///< of a tilted axis
  Branch branch = Branch::iii;
  double nu = 0.0;
  std::string text;

  Potential potential() const {
    BodyModel<> out;
    if (elastic) {
      if (elastic->is_separable()) {
        out.elastic.plane = AnyPlane<>{elastic->plane()};
        out.elastic.thickness = AnyThickness<>{elastic->thickness()};
      } else {
        std::visit([&](const auto& each) { out.elastic.coupled = each; }, elastic->coupled());
      }
    }
    out.gravitates = g > 0.0;
    out.g = g;
    out.J = {body.J1, body.J2, body.J3};
    out.volume = volume;
    return Potential(out);
  }
};

WholeBody drawn(Random& random, bool held, bool gravitates) {
  Ingredients raw = random_ingredients(random, 1.5);
  if (random.integer(0, 4) == 0) raw.J2 = raw.J1;
  const bool fluid = held && gravitates && random.integer(0, 3) == 0;
  if (fluid) raw.J2 = raw.J3 = raw.J1;  // others are computed as such a one
  WholeBody out;
  out.body = Body(raw.J1, raw.J2, raw.J3);
  if (!fluid) out.elastic = testing::named_potential(raw.model, raw.plane, raw.axial);
  if (gravitates) out.g = power_of_ten(random, -1.0, 1.0);
  if (held) out.volume = power_of_ten(random, -0.3, 0.3);
  out.branch = raw.branch;
  out.nu = fluid ? std::sqrt(out.g / raw.J1) * random.uniform(0.02, 0.36)
                 : escape_speed(raw) * random.log_uniform(1e-2, 1.2);
  if (!fluid && random.integer(0, 4) == 0)
    out.plane = random.integer(0, 1) == 0 ? TiltPlane::one_three : TiltPlane::two_three;
  std::ostringstream text;
  text.precision(17);
  text << (fluid ? std::string("fluid")
                 : std::string(raw.model.model) + " " + std::string(raw.model.thickness))
       << " " << raw.plane[0] << " " << raw.plane[1] << ", " << raw.axial[0] << " " << raw.axial[1]
       << ", J (" << raw.J1 << ", " << raw.J2 << ", " << raw.J3 << "), g " << out.g << ", volume "
       << out.volume.value_or(0.0) << ", "
       << (out.plane ? "tilted " + std::string(name(*out.plane)) : std::string(name(out.branch)))
       << ", nu " << out.nu;
  out.text = text.str();
  return out;
}

/// s_k V_k.
Three pulls(const WholeBody& of, const Three& s) {
  Three out{};
  if (of.elastic) {
    const CentrifugalRates<Number50> none{0, 0, 0};
    const auto b = testing::log_balance_50(*of.elastic, none, s);
    out = {b.g_xi, b.g_zeta, b.g_rho};
  }
  if (of.g == 0.0) return out;
  const Number50 J[3] = {of.body.J1, of.body.J2, of.body.J3};
  Three y;
  for (std::size_t k = 0; k < 3; ++k) y[k] = J[k] * s[k] * s[k];
  // dR_F/dy_k = -R_D(the others; y_k)/6.
  for (std::size_t k = 0; k < 3; ++k)
    out[k] +=
        Number50(of.g) * y[k] * boost::math::ellint_rd(y[(k + 1) % 3], y[(k + 2) % 3], y[k]) / 3;
  return out;
}

/// The balance of the unknowns that are left: all three stretches; xi and zeta of a held volume; of a
/// tilted axis those its ties leave.
class Balance50 {
 public:
  explicit Balance50(const WholeBody& of) : of_(of) {
    const Number50 square_nu = Number50(of.nu) * of.nu;
    const auto c = axis_rates(
        testing::Inertia50{Number50(of.body.J1), Number50(of.body.J2), Number50(of.body.J3)},
        of.plane ? Branch::iii : of.branch, square_nu);
    rates_ = {c.xi, c.zeta, c.rho};
    own_ = of.plane == TiltPlane::two_three ? 1 : 0;
  }

  std::size_t unknowns() const {
    return 3 - std::size_t{of_.plane.has_value()} - of_.volume.has_value();
  }
  Three stretches(const std::vector<Number50>& x) const {
    Three s{};
    if (!of_.plane) {
      s = {x[0], x[1], of_.volume ? Number50(*of_.volume) / (x[0] * x[1]) : x[2]};
      return s;
    }
    const double J_own = own_ == 0 ? of_.body.J1 : of_.body.J2;
    s[own_] = x[0];
    s[2] = sqrt(Number50(J_own) / of_.body.J3) * x[0];
    s[1 - own_] = of_.volume ? Number50(*of_.volume) / (s[own_] * s[2]) : x[1];
    return s;
  }
  std::vector<Number50> unknowns_of(const Stretch& q) const {
    const Number50 all[3] = {q.xi, q.zeta, q.rho};
    std::vector<Number50> out;
    if (of_.plane) {
      out = {all[own_]};
      if (!of_.volume) out.push_back(all[1 - own_]);
    } else {
      out.assign(all, all + unknowns());
    }
    return out;
  }
  std::vector<Number50> residual(const std::vector<Number50>& x) const {
    const Three s = stretches(x);
    Three gamma = pulls(of_, s);
    for (std::size_t k = 0; k < 3; ++k) gamma[k] -= rates_[k] * s[k] * s[k];
    if (of_.plane) {
      const Number50 tied = gamma[own_] + gamma[2];
      if (of_.volume) return {tied - 2 * gamma[1 - own_]};
      return {tied, gamma[1 - own_]};
    }
    if (of_.volume) return {gamma[0] - gamma[2], gamma[1] - gamma[2]};
    return {gamma[0], gamma[1], gamma[2]};
  }

 private:
  const WholeBody& of_;
  Three rates_;
  std::size_t own_;
};

template <std::size_t N>
Three polished(const Balance50& balance, const Stretch& q) {
  std::array<Number50, N> x;
  std::ranges::copy(balance.unknowns_of(q), x.begin());
  const auto residual = [&](const std::array<Number50, N>& at) {
    return balance.residual(std::vector<Number50>(at.begin(), at.end()));
  };
  const auto found = testing::newton_50<N>(x, [&](const std::array<Number50, N>& at) {
    const Number50 h("1e-22");
    testing::Linearized50<N> out;
    std::ranges::copy(residual(at), out.first.begin());
    for (std::size_t j = 0; j < N; ++j) {
      auto ahead = at;
      auto behind = at;
      ahead[j] *= 1 + h;
      behind[j] *= 1 - h;
      const auto up = residual(ahead);
      const auto down = residual(behind);
      for (std::size_t i = 0; i < N; ++i) out.second[i][j] = (up[i] - down[i]) / (2 * h);
    }
    return out;
  });
  return balance.stretches(std::vector<Number50>(found.begin(), found.end()));
}

Three whole_body_reference(const WholeBody& of, const Stretch& q) {
  const Balance50 balance(of);
  switch (balance.unknowns()) {
    case 1:
      return polished<1>(balance, q);
    case 2:
      return polished<2>(balance, q);
    default:
      return polished<3>(balance, q);
  }
}

/// The blocks' modes against those of the whole leaf, another way to the same: apart by no more than
/// both bounds.
void compare_ways(const WholeBody& of, const Potential& potential, const Equilibrium& at,
                  const Spectrum& blocks, Outcome& out) {
  const auto extended = [](const Number50& x) {
    const double hi = x.convert_to<double>();
    return DoubleDouble(hi, Number50(x - hi).convert_to<double>());
  };
  const BasicStretch<DoubleDouble> q{0.0, extended(out.exact[0]), extended(out.exact[1]),
                                     extended(out.exact[2])};
  const Vector3<DoubleDouble> nu{DoubleDouble(at.nu[0]), DoubleDouble(at.nu[1]),
                                 DoubleDouble(at.nu[2])};
  const Spectrum whole =
      general_spectrum(of.body, potential, q, nu, std::max(at.error_bound, 0x1p-53));
  const auto a = testing::by_lambda(blocks);
  const auto b = testing::by_lambda(whole);
  if (a.size() != b.size()) {
    out.wrong_class = true;
    out.fault = "the leaf has another number of modes: " + of.text;
    return;
  }
  for (const Mode& mode : a) {
    double nearest = HUGE_VAL;
    for (const Mode& other : b) {
      const double off =
          std::hypot(mode.lambda_re - other.lambda_re, mode.lambda_im - other.lambda_im);
      const double room = mode.lambda_error + other.lambda_error;
      nearest = std::min(nearest, off == 0.0 ? 0.0 : off / room);
    }
    out.mode_over_bound = std::max(out.mode_over_bound, nearest);
  }
  if (!(out.mode_over_bound <= 1.0) && out.fault.empty())
    out.fault = "a mode of the blocks is none of the leaf's: " + of.text;
}

Outcome tried_whole_body(Random& random, bool held, bool gravitates) {
  const WholeBody of = drawn(random, held, gravitates);
  const Potential potential = of.potential();
  Outcome out;
  if (of.plane) {
    const TiltedRotation motion{*of.plane, of.nu};
    const Equilibrium at = solve_tilted(of.body, potential, motion);
    out.status = at.status;
    out.work = work(at.counts);
    if (at.status != SolveStatus::solved) return out;
    judge_stretch(whole_body_reference(of, at.q), {at.q.xi, at.q.zeta, at.q.rho}, at.error_bound,
                  of.text, out);
    const auto spectrum = tilted_stability(of.body, potential, motion, at);
    if (!spectrum) return out;
    const Certificate proof = certify_tilted(of.body, potential, motion, at);
    judge_by_proof(
        proof, *spectrum,
        [&] { return enclose_spectrum(of.body, potential, motion, proof, *spectrum); }, of.text,
        out);
    return out;
  }
  const Problem problem(of.body, potential, of.branch);
  const Equilibrium at = solve(problem, of.nu);
  out.status = at.status;
  out.work = work(at.counts);
  if (at.status != SolveStatus::solved) return out;
  judge_stretch(whole_body_reference(of, at.q), {at.q.xi, at.q.zeta, at.q.rho}, at.error_bound,
                of.text, out);
  const Spectrum spectrum = stability(problem, at);
  const Certificate proof = certify(problem, at);
  judge_by_proof(
      proof, spectrum, [&] { return enclose_spectrum(problem, at, proof, spectrum); }, of.text,
      out);
  compare_ways(of, potential, at, spectrum, out);
  return out;
}

}  // namespace

Outcome try_held_volume(Random& random) {
  return tried_whole_body(random, true, random.integer(0, 1) == 0);
}
Outcome try_gravity(Random& random) { return tried_whole_body(random, false, true); }

}  // namespace stationary::stress
