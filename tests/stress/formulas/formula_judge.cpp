#include "tests/stress/formulas/formula_judge.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <optional>
#include <thread>

#include "solver/family/follow_sheet.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/case/case_toml.hpp"
#include "solver/proof/certify.hpp"
#include "solver/search/search.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary::stress {
namespace {

using support::Random;
using support::Real50;

template <class T>
using Point = std::array<T, 4>;  ///< alpha, xi, zeta, rho

constexpr double min_stretch = 0.02;
constexpr double max_stretch = 50.0;
/// Of Newton's last step in 50 digits: stretches 1e10 apart cost it twenty of them.
constexpr double converged = 1e-28;

/// The balance of a case by its own formula: V_i - T_i at given nu, T the kinetic energy at that
/// nu.
template <class T>
class OwnBalance {
 public:
  OwnBalance(const FormulaCase& c, const T& nu) : c_(c), nu_squared_(nu * nu) {
    for (std::size_t k = 0; k < 3; ++k)
      if constexpr (std::is_same_v<T, double>)
        J_[k] = std::stod(c.inertia[k]);
      else
        J_[k] = T(c.inertia[k]);
  }

  /// Of alpha, xi, zeta, rho.
  Point<T> rates() const {
    const T none(0);
    switch (c_.branch) {
      case 1:
        return {nu_squared_ * J_[0], none, nu_squared_ * J_[1], nu_squared_ * J_[2]};
      case 2:
        return {nu_squared_ * J_[1], nu_squared_ * J_[0], none, nu_squared_ * J_[2]};
      default:
        return {nu_squared_ * (J_[0] + J_[1]), nu_squared_ * J_[0], nu_squared_ * J_[1], none};
    }
  }

  /// Newton's method in the unknowns that the motion has; nothing where it does not converge in the
  /// domain to a motion.
  std::optional<Point<T>> solved(Point<T> q, int steps, const T& tolerance) const {
    using std::abs;
    const bool shear = c_.branch == 3 && c_.anisotropic;
    const int n = shear ? 4 : 3;
    const Point<T> rate = rates();
    for (int step = 0; step < steps; ++step) {
      const Evaluated<T> V = evaluated(*c_.energy, q);
      if (!V.defined) return std::nullopt;
      Eigen::Matrix<T, 4, 4> A = Eigen::Matrix<T, 4, 4>::Identity();
      Eigen::Matrix<T, 4, 1> b = Eigen::Matrix<T, 4, 1>::Zero();
      for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>((i + 1) % 4);
        b[i] = V.energy.slope[at] - rate[at] * q[at];
        for (int j = 0; j < n; ++j) {
          const auto by = static_cast<std::size_t>((j + 1) % 4);
          A(i, j) = V.energy.curvature[at][by];
        }
        A(i, i) -= rate[at];
      }
      const Eigen::Matrix<T, 4, 1> d = A.fullPivLu().solve(b);
      T size(0);
      for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>((i + 1) % 4);
        const T part = abs(d[i]) / abs(at == 0 ? q[1] : q[at]);
        if (!(part == part)) return std::nullopt;
        size = std::max(size, part);
      }
      const T shorter = size > T(0.3) ? T(T(0.3) / size) : T(1);
      for (int i = 0; i < n; ++i) q[static_cast<std::size_t>((i + 1) % 4)] -= shorter * d[i];
      if (!(q[1] > T(0)) || !(q[2] > T(0)) || !(q[3] > T(0)) || !(q[1] * q[2] > q[0] * q[0]))
        return std::nullopt;
      if (size < tolerance) return is_motion(q) ? std::optional(q) : std::nullopt;
    }
    return std::nullopt;
  }

  /// In the domain, and with the balance in alpha where alpha is held at 0.
  bool is_motion(const Point<T>& q) const {
    using std::abs;
    const Evaluated<T> V = evaluated(*c_.energy, q);
    if (!V.defined) return false;
    if (c_.domain && !(evaluated(*c_.domain, q).energy.value > T(0))) return false;
    T force(0);
    for (const T& each : V.energy.slope) force = std::max(force, T(abs(each)));
    if (!(force < T(1e200))) return false;
    return c_.branch == 3 || abs(V.energy.slope[0]) <= T(1e-9) * (force + T(1e-30));
  }

 private:
  const FormulaCase& c_;
  T nu_squared_;
  std::array<T, 3> J_;
};

Point<Real50> widened(const Stretch& q) {
  return {Real50(q.alpha), Real50(q.xi), Real50(q.zeta), Real50(q.rho)};
}

/// Relative, as error bounds are.
double distance(const Point<Real50>& exact, const Stretch& q) {
  using boost::multiprecision::abs;
  using boost::multiprecision::sqrt;
  const Point<Real50> x = widened(q);
  Real50 out = abs(exact[0] - x[0]) / sqrt(exact[1] * exact[2]);
  for (std::size_t k = 1; k < 4; ++k) out = std::max(out, Real50(abs(exact[k] - x[k]) / exact[k]));
  return out.convert_to<double>();
}

struct Rows final : CurveSink {
  struct Row {
    Member member;
    EventType event;
  };
  void row(const Member& member, EventType event) override { rows.push_back({member, event}); }
  std::vector<Row> rows;
};

class Judge {
 public:
  Judge(const FormulaCase& c, const Falsified& how, std::uint64_t seed, FormulaTally& tally)
      : c_(c), how_(how), tally_(tally), seed_(seed) {}

  void run() {
    ++tally_.cases;
    std::optional<Case> input;
    try {
      input = make_case(CaseTree::parse(c_.text(!how_.without_domain), "random"));
    } catch (const InputError&) {
      ++tally_.refused;
      return;
    }
    tally_.anisotropic += c_.anisotropic ? 1 : 0;
    tally_.poles += c_.has_pole ? 1 : 0;
    const Problem problem = input->problem();
    searched(problem);
    followed(problem);
  }

 private:
  void fault(const std::string& what) {
    constexpr std::size_t most = 50;
    if (tally_.faults.size() < most) tally_.faults.push_back(what + "\n" + c_.text());
  }

  /// Existence, the bound and the domain; nu in its own decimals or a double's.
  void solution(const char* whose, const Stretch& q, double bound, const Real50& nu) {
    const OwnBalance<Real50> own(c_, nu);
    auto exact = own.solved(widened(q), 12, Real50(converged));
    char text[240];
    std::snprintf(text, sizeof text, "%s at xi = %.17g, zeta = %.17g, rho = %.17g: ", whose, q.xi,
                  q.zeta, q.rho);
    // A bound as large as the motion itself claims nothing.
    constexpr double something = 1e-3;
    if (!(bound < something)) return;
    // Beside a pole the rounding of a stretch leads out of where Newton's method converges.
    for (std::size_t k = 1; k < 4 && !exact; ++k) {
      for (const double units : {1.0, -1.0, 3.0, -3.0, 10.0, -10.0}) {
        Point<Real50> near = widened(q);
        near[k] *= 1 + Real50(units * 0x1p-53);
        exact = own.solved(near, 40, Real50(converged));
        if (exact) break;
      }
    }
    if (!exact) return fault(std::string(text) + "no motion there");
    const double error = distance(*exact, q);
    if (error > how_.bounds * bound) {
      std::snprintf(text + std::strlen(text), sizeof text - std::strlen(text),
                    "error %.3g, bound %.3g", error, how_.bounds * bound);
      fault(text);
    }
  }

  void searched(const Problem& problem) {
    SearchOptions options;
    options.min_stretch = min_stretch;
    options.max_stretch = max_stretch;
    // Of an anisotropic system two hundred times as many are allowed.
    options.max_boxes = c_.anisotropic ? 40 : 800;
    const double nu = std::stod(c_.nu);
    const SearchResult found = search(problem, nu, options);
    ++tally_.searches;
    for (const Equilibrium& each : found.solutions) {
      ++tally_.proven;
      solution("proven", each.q, each.error_bound, Real50(c_.nu));
      const Certificate certificate = certify(problem, each);
      if (!certificate.proven) continue;
      ++tally_.certified;
      solution("certified", each.q, certificate.error_bound, Real50(c_.nu));
    }
    if (found.status != SearchStatus::complete) {
      ++tally_.undecided;
      return;
    }
    if (found.solutions.empty()) ++tally_.none;
    from_many_starts(found.solutions, nu);
    const Equilibrium one = solve(problem, nu, cold());
    if (one.status == SolveStatus::solved) {
      solution("solved", one.q, one.error_bound, Real50(c_.nu));
    } else if (one.status == SolveStatus::none_exists && !found.solutions.empty()) {
      fault("said not to exist, and proven to: " + one.message);
    }
  }

  /// A solve's own search takes a second of an anisotropic body: of every fourth.
  SolveOptions cold() const {
    SolveOptions out;
    out.search = !c_.anisotropic || seed_ % 4 == 0;
    return out;
  }

  /// None is found that the list has not.
  void from_many_starts(const std::vector<Equilibrium>& list, double nu) {
    Random random(seed_ + 77);
    const OwnBalance<double> quick(c_, nu);
    const OwnBalance<Real50> own(c_, Real50(c_.nu));
    constexpr int starts = 40;
    for (int k = 0; k < starts; ++k) {
      const double spread = k % 4 == 0 ? 20.0 : 3.0;
      Point<double> q{0.0, random.log_uniform(1.0 / spread, spread),
                      random.log_uniform(1.0 / spread, spread),
                      random.log_uniform(1.0 / spread, spread)};
      if (c_.branch == 3 && c_.anisotropic)
        q[0] = random.uniform(-0.9, 0.9) * std::sqrt(q[1] * q[2]);
      const auto near = quick.solved(q, 60, 1e-9);
      if (!near) continue;
      const auto exact = own.solved(
          {Real50((*near)[0]), Real50((*near)[1]), Real50((*near)[2]), Real50((*near)[3])}, 12,
          Real50(converged));
      if (!exact || !in_box(*exact)) continue;
      const auto known = [&](const Equilibrium& each) { return distance(*exact, each.q) < 1e-6; };
      if (std::ranges::any_of(list, known)) continue;
      char text[160];
      std::snprintf(text, sizeof text,
                    "missed by a complete search: alpha = %.9g, xi = %.9g, zeta = %.9g, rho = %.9g",
                    (*exact)[0].convert_to<double>(), (*exact)[1].convert_to<double>(),
                    (*exact)[2].convert_to<double>(), (*exact)[3].convert_to<double>());
      return fault(text);
    }
  }

  /// Well inside, principal stretches too.
  static bool in_box(const Point<Real50>& q) {
    const double t = Real50(q[1] + q[2]).convert_to<double>();
    const double d = Real50(q[1] * q[2] - q[0] * q[0]).convert_to<double>();
    const double rho = q[3].convert_to<double>();
    const double largest = 0.5 * (t + std::sqrt(std::max(0.0, t * t - 4.0 * d)));
    const double margin = 1.01;
    return d / largest > margin * min_stretch && largest < max_stretch / margin &&
           rho > margin * min_stretch && rho < max_stretch / margin;
  }

  void followed(const Problem& problem) {
    const Equilibrium rest = solve(problem, 0.0, cold());
    if (rest.status != SolveStatus::solved) return;
    FollowOptions options;
    options.continuation.from = 0.0;
    options.continuation.to = 4.0;
    options.continuation.step.tolerance = 1e-6;
    options.max_points = 300;
    Rows out;
    AxisFamilyOptions family;
    family.spectrum = false;
    follow(axis_family(problem.on_part_of(rest.q), family), rest.q, 0.0, options, out);
    tally_.rows += static_cast<long>(out.rows.size());
    // At rest itself the principal stretches may be equal, where their own formulas are singular.
    constexpr double least = 0.05;
    std::optional<std::vector<bool>> signs;
    long number = 0;
    for (const Rows::Row& row : out.rows) {
      if (!(row.member.nu > least)) continue;
      const Evaluated<Real50> V = evaluated(*c_.energy, widened(row.member.q));
      if (!V.defined || margin(row.member.q) <= 0.0) fault("a row outside the domain");
      if (!std::isfinite(row.member.energy)) fault("a row without a finite energy");
      if (signs && *signs != V.positive) fault("a sheet passes a pole");
      signs = V.positive;
      if (number++ % 10 == 0 && row.event == EventType::none)
        solution("row", row.member.q, row.member.error_bound, Real50(row.member.nu));
    }
    if (out.rows.size() < 2 || out.rows.back().event != EventType::domain) return;
    ++tally_.domain_ends;
    const double last = margin(out.rows.back().member.q);
    const double before = margin(out.rows[out.rows.size() - 2].member.q);
    constexpr double small = 1e-4;
    if (last < small && last <= before) return;  // equal where a double resolves no more
    char text[160];
    std::snprintf(text, sizeof text, "an end `domain` %.3g from the border, the row before %.3g",
                  last, before);
    fault(text);
  }

  /// The least of all arguments that must be positive.
  double margin(const Stretch& q) const {
    const Point<Real50> at = widened(q);
    Real50 out = evaluated(*c_.energy, at).nearest;
    if (c_.domain) out = std::min(out, evaluated(*c_.domain, at).energy.value);
    return out.convert_to<double>();
  }

  const FormulaCase& c_;
  const Falsified& how_;
  FormulaTally& tally_;
  std::uint64_t seed_;
};

}  // namespace

FormulaTally& FormulaTally::operator+=(const FormulaTally& other) {
  for (const auto count :
       {&FormulaTally::cases, &FormulaTally::anisotropic, &FormulaTally::poles,
        &FormulaTally::refused, &FormulaTally::searches, &FormulaTally::undecided,
        &FormulaTally::proven, &FormulaTally::none, &FormulaTally::certified, &FormulaTally::rows,
        &FormulaTally::domain_ends})
    this->*count += other.*count;
  faults.insert(faults.end(), other.faults.begin(), other.faults.end());
  return *this;
}

FormulaTally judged_formulas(long count, std::uint64_t seed, const Falsified& how, int threads) {
  Random random(seed);
  std::vector<FormulaCase> cases;
  for (long k = 0; k < count; ++k) cases.push_back(random_formula_case(random));
  std::vector<FormulaTally> parts(static_cast<std::size_t>(threads));
  std::atomic<std::size_t> next = 0;
  const auto work = [&](FormulaTally& part) {
    for (std::size_t k = next++; k < cases.size(); k = next++) Judge(cases[k], how, k, part).run();
  };
  {
    std::vector<std::jthread> workers;
    for (FormulaTally& part : parts) workers.emplace_back(work, std::ref(part));
  }
  FormulaTally out;
  for (const FormulaTally& part : parts) out += part;
  return out;
}

std::string text_of(const FormulaTally& tally) {
  char out[400];
  std::snprintf(
      out, sizeof out,
      "%ld formulas (%ld anisotropic, %ld with poles, %ld refused): %ld searches, %ld "
      "undecided; %ld solutions proven, %ld certified, %ld times none; %ld rows, %ld ends "
      "`domain`; %zu untrue",
      tally.cases, tally.anisotropic, tally.poles, tally.refused, tally.searches, tally.undecided,
      tally.proven, tally.certified, tally.none, tally.rows, tally.domain_ends,
      tally.faults.size());
  return out;
}

}  // namespace stationary::stress
