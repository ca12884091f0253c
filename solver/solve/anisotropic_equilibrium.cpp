#include "solver/solve/anisotropic_equilibrium.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lib/number/elementary.hpp"
#include "solver/family/branch_switch.hpp"
#include "solver/motion/oriented_stability.hpp"
#include "solver/motion/oriented_system.hpp"
#include "solver/search/anisotropic_search.hpp"
#include "solver/solve/anisotropic_rest.hpp"
#include "solver/solve/family_solve.hpp"
#include "solver/solve/nonexistence.hpp"

namespace stationary {
namespace {

class AnisotropicSolve : FamilySolve {
 public:
  AnisotropicSolve(const Body& body, const Potential& potential, const SolveOptions& options)
      : FamilySolve(body, potential, options), V_(potential.anisotropic()) {}

  Equilibrium about_axis(Branch branch, double nu) {
    const double speed = std::abs(nu);
    const Problem problem(body_, potential_, branch);
    if (branch != Branch::iii && nu != 0.0 && !V_.shear_free()) {
      off_axis(problem, nu);
      return out_;
    }
    // At rest no axis is asked for; of an even V alpha = 0 is a choice.
    const bool alpha_free = branch == Branch::iii && options_.start && options_.start->alpha != 0.0;
    const bool at_rest = nu == 0.0 && !V_.shear_free();
    const AnyFamily family = anisotropic_family(body_, V_, at_rest ? Branch::iii : branch,
                                                alpha_free, {.parameter = {}, .spectrum = false});
    std::visit([&](const auto& each) { one(*each, speed); }, family);
    if (wants_search() && out_.status == SolveStatus::not_found)
      nearest_of(search_anisotropic(problem, speed, short_search()));
    out_.nu = angular_velocity(branch, nu);
    return out_;
  }

  Equilibrium oblique(const ObliqueRotation& motion) {
    if (options_.start || options_.method == Method::newton) {
      const auto family = oblique_family(motion.near.value_or(Branch::i));
      one(*family, motion.nu);
      if (out_.status == SolveStatus::solved && V_.even_in_alpha() && is_about_material_axis(out_))
        fail(out_.message + " came to a motion about axis " + (out_.nu[0] != 0.0 ? "1" : "2"));
    } else {
      std::string failures;
      for (const Branch near : {Branch::i, Branch::ii}) {
        if (motion.near && *motion.near != near) continue;
        begin_anew();
        oblique_from(near, motion.nu);
        if (out_.status == SolveStatus::solved || out_.status == SolveStatus::interrupted) break;
        failures += (failures.empty() ? "" : "; ") + out_.message;
      }
      if (out_.status == SolveStatus::not_found) out_.message = failures;
    }
    if (wants_search() && out_.status == SolveStatus::not_found)
      nearest_of(search_oblique(body_, potential_, motion, short_search()));
    upwards(out_);
    return out_;
  }

  /// near: the axis that the family is near at its beginning, if it is given.
  void oblique_each(std::optional<Branch> near, const NumberRange& all, std::span<AtValue> values) {
    const auto rest = rest_state();
    for (const Branch each : {Branch::i, Branch::ii}) {
      if (!rest || (near && *near != each)) continue;
      const auto family = oblique_family(each);
      for_each_beginning(*family, each, *rest, all.most(), [&](const Beginning& at) {
        const auto range_to = [&](double nu) { return limits(at.nu, nu); };
        along_each(*family, at.q, at.nu, range_to, all, values);
        return std::ranges::all_of(values, &AtValue::solved);
      });
    }
    for (AtValue& each : values) {
      const SolveStatus known = each.equilibrium.status;
      const bool open = known == SolveStatus::not_run || known == SolveStatus::not_found;
      if (open && wants_search() && !stopped()) {
        begin_anew();
        fail("not on a family followed from rest");
        nearest_of(search_oblique(body_, potential_, {each.value, near}, short_search()));
        each.equilibrium = out_;
      }
      upwards(each.equilibrium);
    }
  }

 private:
  bool wants_search() const { return options_.search && options_.method == Method::automatic; }
  /// For a solution and not for all: a tenth of the boxes, whose rest solve.all goes through.
  SearchOptions short_search() const { return {.max_boxes = 1000, .stop = options_.stop}; }
  std::unique_ptr<Family<5>> oblique_family(Branch near) const {
    return stationary::oblique_family(body_, V_, {.parameter = {}, .spectrum = false}, near);
  }

  /// From the start, or along the family through the rest state.
  template <int N>
  void one(const Family<N>& family, double nu) {
    if (options_.start) {
      by_newton(family, family.coordinates(*options_.start, nu), nu, Connection::given_start,
                "Newton from the given start");
      return;
    }
    const auto rest = rest_state();
    if (!rest) return;
    if (options_.method == Method::newton) {
      by_newton(family, family.coordinates(*rest, nu), nu, Connection::unknown,
                "Newton from the rest state");
    } else if (nu == 0.0) {
      by_newton(family, family.coordinates(*rest, nu), nu, Connection::rest, "the rest state");
    } else {
      to_nu(family, *rest, 0.0, nu, "the family through the rest state");
    }
  }

  std::optional<Stretch> rest_state() {
    SolveOptions how = options_;
    how.search = wants_search();
    const AnisotropicRest rest = anisotropic_rest(body_, potential_, how, out_.counts);
    if (rest.q) return rest.q;
    fail(rest.message);
    return std::nullopt;
  }

  /// From a motion of the family at p.
  template <int N>
  void to_nu(const Family<N>& family, const Stretch& q, double p, double nu,
             const std::string& what) {
    const auto [from, to] = limits(p, nu);
    along(family, q, p, nu, range(from, to, EventSet::none()), what);
  }
  /// Of the range from a motion at p to nu.
  static std::pair<double, double> limits(double p, double nu) {
    return {std::min(p, nu), std::max(p, nu)};
  }
  /// With alpha = 0: none of an oblique axis.
  static bool is_about_material_axis(const Equilibrium& at) {
    return at.q.alpha == 0.0 && (at.nu[0] == 0.0 || at.nu[1] == 0.0);
  }
  /// Of nu and -nu, which are the same oblique motion, that of search_oblique().
  static void upwards(Equilibrium& at) {
    if (at.nu[0] + at.nu[1] < 0.0) at.nu = -at.nu;
  }

  /// A motion that an oblique family begins at, or just inside it.
  struct Beginning {
    Stretch q;
    double nu;
    std::string what;
  };

  static std::string axis_name(Branch near) { return near == Branch::i ? "axis 1" : "axis 2"; }

  /// The oblique families from the rest state's own axis, or from where the sheet of (i) or (ii)
  /// through it lets the axis go, far beyond `most` too, until take() has what it wants. Whether there
  /// was one.
  template <class Take>
  bool for_each_beginning(const Family<5>& family, Branch near, const Stretch& rest, double most,
                          const Take& take) {
    if (!V_.shear_free()) {
      take(Beginning{rest, 0.0, "the family that starts about " + axis_name(near) + " at rest"});
      return true;
    }
    const AnyFamily straight =
        anisotropic_family(body_, V_, near, false, {.parameter = {}, .spectrum = false});
    bool any = false;
    for (const Member& event : events_from_rest(straight, rest, most, EventType::oblique)) {
      if (stopped()) break;
      const auto start = leave_straight(family, event, near);
      if (!start) continue;
      any = true;
      if (take(Beginning{
              start->q, start->parameter,
              "the family that leaves " + axis_name(near) + " at |nu| = " + text(event.nu)}))
        break;
    }
    return any;
  }

  void oblique_from(Branch near, double nu) {
    const auto rest = rest_state();
    if (!rest) return;
    const auto family = oblique_family(near);
    std::string failures;
    const bool any = for_each_beginning(*family, near, *rest, nu, [&](const Beginning& at) {
      to_nu(*family, at.q, at.nu, nu, at.what);
      if (out_.status == SolveStatus::solved) return true;
      failures += (failures.empty() ? "" : "; ") + out_.message;
      return false;
    });
    if (out_.status == SolveStatus::solved) return;
    fail(any ? failures
             : "no axis leaves " + axis_name(near) + " on the sheet through the rest state");
  }

  void off_axis(const Problem& problem, double nu) {
    const SearchResult all = search_anisotropic(problem, std::abs(nu), {.stop = options_.stop});
    out_.nu = angular_velocity(problem.branch(), nu);
    if (all.status == SearchStatus::interrupted) {
      out_.status = SolveStatus::interrupted;
      return;
    }
    out_.message = "no stationary ellipse about this axis: " + all.message;
    out_.status =
        all.status == SearchStatus::complete ? SolveStatus::none_exists : SolveStatus::not_found;
  }

  void nearest_of(const SearchResult& all) {
    if (all.status == SearchStatus::interrupted) {
      out_.status = SolveStatus::interrupted;
      return;
    }
    if (all.solutions.empty()) {
      out_.message += "; exhaustive search, " + all.message;
      return;
    }
    const double known = V_.rest_stretch();
    const double r = std::isfinite(known) ? known : 1.0;
    const auto distance = [&](const Equilibrium& at) {
      return std::max(
          {std::abs(log(at.q.xi / r)), std::abs(log(at.q.zeta / r)), std::abs(at.q.alpha) / r});
    };
    const Equilibrium& nearest = *std::ranges::min_element(all.solutions, {}, distance);
    const Counts counts = out_.counts;
    out_ = nearest;
    out_.counts = counts;
    out_.connection = Connection::unknown;
    out_.message =
        "Found by an exhaustive search; whether it is connected to the rest state is not known.";
  }

  const AnisotropicPotential& V_;
};

/// Of an oblique one.
Branch nearer_axis(const Vector3<double>& nu) {
  return std::abs(nu[0]) >= std::abs(nu[1]) ? Branch::i : Branch::ii;
}

void require_start(const SolveOptions& options) {
  if (options.start) require_positive_definite(*options.start);
  if (options.method != Method::automatic && options.method != Method::newton)
    throw std::invalid_argument("method auto or newton, for an anisotropic potential");
}

}  // namespace

Equilibrium solve_anisotropic(const Problem& problem, double nu, const SolveOptions& options) {
  require_start(options);
  return AnisotropicSolve(problem.body(), problem.potential(), options)
      .about_axis(problem.branch(), nu);
}

Equilibrium solve_oblique(const Body& body, const Potential& potential,
                          const ObliqueRotation& motion, const SolveOptions& options) {
  if (potential.is_isotropic())
    throw std::invalid_argument("an anisotropic potential, for an oblique axis");
  if (!(motion.nu > 0.0 && std::isfinite(motion.nu)))
    throw std::invalid_argument("|nu| finite and > 0");
  require_start(options);
  return AnisotropicSolve(body, potential, options).oblique(motion);
}

void solve_oblique_each(const Body& body, const Potential& potential, std::optional<Branch> near,
                        bool spectra, const SolveOptions& options, const NumberRange& all,
                        std::span<AtValue> at) {
  if (at.empty()) return;
  require_rates(at);
  AnisotropicSolve(body, potential, options).oblique_each(near, all, at);
  if (!spectra) return;
  std::array<std::unique_ptr<Family<5>>, 2> families;
  for (AtValue& each : at) {
    if (!each.solved() || each.spectrum) continue;
    const Branch axis = nearer_axis(each.equilibrium.nu);
    auto& family = families[axis == Branch::i ? 0 : 1];
    if (!family) family = oblique_family(body, potential.anisotropic(), {.parameter = {}}, axis);
    each.spectrum = family_spectrum(*family, each.equilibrium, each.equilibrium.nu.norm());
  }
}

const AnyFamily& AnisotropicSpectra::family_of(const Equilibrium& equilibrium) {
  const AnisotropicPotential& V = problem_.potential().anisotropic();
  const bool at_rest = equilibrium.nu[axis(problem_.branch())] == 0.0;
  const Branch branch = at_rest && !V.shear_free() ? Branch::iii : problem_.branch();
  const bool sheared = equilibrium.q.alpha != 0.0;
  if (!family_ || branch != branch_ || sheared != sheared_) {
    family_ = anisotropic_family(problem_.body(), V, branch_ = branch, sheared_ = sheared,
                                 {.parameter = {}, .errors = false, .energy = false});
  }
  return *family_;
}

Spectrum AnisotropicSpectra::at(const Equilibrium& rounded) {
  const auto solved = [](bool is) {
    if (!is) throw std::invalid_argument("a spectrum needs a solved equilibrium");
  };
  solved(rounded.status == SolveStatus::solved);
  // One correction more finds the digits that rounding took, but where that is ill-conditioned.
  constexpr double well_conditioned = 0x1p-42;
  if (!(rounded.error_bound <= well_conditioned)) {
    const auto out = corrected(rounded);
    solved(out.has_value());
    return *out;
  }
  const double nu = rounded.nu[axis(problem_.branch())];
  return std::visit(
      [&](const auto& family) {
        const auto x = family->coordinates(rounded.q, nu);
        auto unknown = x;
        unknown.setConstant(std::numeric_limits<double>::quiet_NaN());
        return *family->member(x, unknown, nu, rounded.error_bound).spectrum;
      },
      family_of(rounded));
}

std::optional<Spectrum> AnisotropicSpectra::corrected(const Equilibrium& equilibrium) {
  const double nu = equilibrium.nu[axis(problem_.branch())];
  return std::visit([&](const auto& family) { return family_spectrum(*family, equilibrium, nu); },
                    family_of(equilibrium));
}

std::optional<Spectrum> anisotropic_stability(const Problem& problem,
                                              const Equilibrium& equilibrium) {
  return AnisotropicSpectra(problem).corrected(equilibrium);
}

std::optional<Spectrum> oblique_stability(const Body& body, const Potential& potential,
                                          const Equilibrium& equilibrium) {
  const auto family =
      oblique_family(body, potential.anisotropic(), {.parameter = {}}, nearer_axis(equilibrium.nu));
  return family_spectrum(*family, equilibrium, equilibrium.nu.norm());
}

}  // namespace stationary
