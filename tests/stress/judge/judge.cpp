#include "tests/stress/judge/judge.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/family/follow_sheet.hpp"
#include "solver/proof/certify.hpp"
#include "solver/search/search.hpp"
#include "tests/support/numbers/wide_spectrum.hpp"

namespace stationary::stress {
namespace {

using testing::Number50;
using testing::SolvedMotion;
using testing::WideMotion;

/// The first one is kept.
void fault(const std::string& what, const std::string& text, Outcome& out) {
  if (out.fault.empty()) out.fault = what + ": " + text;
}

double units_off(double x, const Number50& exact) {
  const double unit = std::ldexp(1.0, std::ilogb(x) - 52);
  return abs(Number50((Number50(x) - exact) / unit)).convert_to<double>();
}

std::string class_name(StabilityClass verdict) { return std::string(name(verdict)); }

bool finite(const Equilibrium& at) {
  return std::isfinite(at.q.xi) && std::isfinite(at.q.zeta) && std::isfinite(at.q.rho) &&
         std::isfinite(at.error_bound) && std::isfinite(at.residual) &&
         std::isfinite(at.compatibility);
}

bool finite(const Spectrum& spectrum) {
  return std::ranges::all_of(testing::modes(spectrum), [](const Mode& m) {
    return std::isfinite(m.re) && std::isfinite(m.im) && std::isfinite(m.lambda_re) &&
           std::isfinite(m.lambda_im) && !std::isnan(m.lambda_error);
  });
}

/// Largest |change of Lambda| over its bound. Modes known within less than their distance leave no
/// choice which is which; of the others the pairing that suits the bounds best.
double mode_over_bound(const std::vector<Mode>& found,
                       const std::vector<testing::WideLambda>& exact) {
  std::vector<std::size_t> pairing(found.size());
  std::iota(pairing.begin(), pairing.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    double worst = 0.0;
    for (std::size_t k = 0; k < found.size(); ++k) {
      const double off = testing::distance(found[k], exact[pairing[k]]);
      if (off > 0.0) worst = std::max(worst, off / found[k].lambda_error);
    }
    least = std::min(least, worst);
  } while (least > 1.0 && std::next_permutation(pairing.begin(), pairing.end()));
  return least;
}

class LastRow final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override {
    last = member;
    end = event;
  }
  Member last;
  EventType end = EventType::none;
};

/// Where continuation comes to from rest; nothing where it does not reach nu.
std::optional<Member> followed_from_rest(const HardCase& c) {
  const Equilibrium rest = solve(c.problem, 0.0);
  if (rest.status != SolveStatus::solved) return std::nullopt;
  FollowOptions options;
  options.continuation.from = 0.0;
  options.continuation.to = std::abs(c.nu);
  options.max_points = 20000;
  LastRow sink;
  follow(axis_family(c.problem, {.nu = 0.0, .parameter = {}, .spectrum = false}), rest.q, 0.0,
         options, sink);
  if (sink.end != EventType::limit) return std::nullopt;
  return sink.last;
}

/// Farther apart than rounding nu, and where the last row has it, may take them.
bool apart(const Member& followed, const Equilibrium& at, double nu) {
  const double off = std::max(std::abs(std::log(followed.q.xi / at.q.xi)),
                              std::abs(std::log(followed.q.zeta / at.q.zeta)));
  const double short_of = std::abs(followed.parameter / nu) - 1.0;
  return off > 1e-6 + at.error_bound * (1e3 + std::abs(short_of) / 0x1p-53);
}

class Judgement {
 public:
  explicit Judgement(const HardCase& c) : c_(c) {}

  Outcome of_solved(Equilibrium at) {
    if (!finite(at)) {
      out_.not_finite = true;
      fault("a number of the answer is not finite");
      return out_;
    }
    const SolvedMotion motion{c_.problem, std::move(at), c_.text};
    WideMotion wide;
    try {
      wide = testing::wide_motion(motion);
    } catch (const std::exception& error) {
      out_.error = out_.units = std::numeric_limits<double>::infinity();
      fault(error.what());
      return out_;
    }
    const Stretch& q = motion.at.q;
    judge_stretch({wide.state.xi, wide.state.zeta, wide.state.rho}, {q.xi, q.zeta, q.rho},
                  motion.at.error_bound, c_.text, out_);
    judge_spectrum(motion, wide);
    judge_connection(motion.at);
    return out_;
  }

  Outcome of_absence(SolveStatus status) {
    const SearchResult all = search(c_.problem, c_.nu);
    out_.overlooked = status == SolveStatus::not_found && !all.solutions.empty();
    out_.wrong_absence = status == SolveStatus::none_exists && !all.solutions.empty();
    if (out_.wrong_absence) fault("said not to exist, and proven to");
    return out_;
  }

 private:
  void fault(const std::string& what) { stress::fault(what, c_.text, out_); }

  void judge_spectrum(const SolvedMotion& motion, const WideMotion& wide) {
    const Spectrum spectrum = motion.blocks();
    if (!finite(spectrum)) {
      out_.not_finite = true;
      fault("a number of the spectrum is not finite");
      return;
    }
    const auto found = testing::by_lambda(spectrum);
    if (found.size() != wide.lambdas.size()) {
      fault("modes are missing");
      out_.wrong_class = true;
      return;
    }
    out_.mode_over_bound = mode_over_bound(found, wide.lambdas);
    if (!(out_.mode_over_bound <= 1.0)) fault("an eigenvalue's error is above its bound");
    const StabilityClass exact = testing::wide_verdict(motion, wide).verdict;
    if (spectrum.verdict != StabilityClass::marginal && spectrum.verdict != exact) {
      out_.wrong_class = true;
      fault("said to be " + class_name(spectrum.verdict) + ", is " + class_name(exact));
    }
    const Certificate certificate = certify(motion.problem, motion.at);
    judge_by_proof(
        certificate, spectrum,
        [&] { return enclose_spectrum(motion.problem, motion.at, certificate, spectrum); }, c_.text,
        out_);
    if (out_.proven_class && *out_.proven_class != exact) {
      out_.wrong_proof = true;
      fault("proven to be " + class_name(*out_.proven_class) + ", is " + class_name(exact));
    }
  }

  void judge_connection(const Equilibrium& at) {
    if (at.connection != Connection::rest || c_.nu == 0.0) return;
    const auto followed = followed_from_rest(c_);
    if (followed && apart(*followed, at, c_.nu)) {
      out_.wrong_sheet = true;
      fault("said to be connected to rest, and is not");
    }
  }

  const HardCase& c_;
  Outcome out_;
};

}  // namespace

long work(const Counts& counts) {
  return counts.residuals + counts.jacobians + counts.extended_residuals + counts.walk_steps;
}

void judge_stretch(const std::array<Number50, 3>& exact, const std::array<double, 3>& x,
                   double error_bound, const std::string& text, Outcome& out) {
  for (std::size_t k = 0; k < 3; ++k) out.units = std::max(out.units, units_off(x[k], exact[k]));
  out.error = testing::relative_error({0.0, x[0], x[1], x[2]}, exact);
  out.error_bound = error_bound;
  out.exact = exact;
  if (!(out.error <= error_bound)) fault("the error is above its bound", text, out);
}

void judge_by_proof(const Certificate& certificate, const Spectrum& spectrum,
                    const std::function<SpectrumEnclosure()>& enclose, const std::string& text,
                    Outcome& out) {
  out.marginal = spectrum.verdict == StabilityClass::marginal;
  out.certified = certificate.proven;
  if (!out.certified) return;
  if (!(out.error <= certificate.error_bound)) {
    out.wrong_proof = true;
    fault("the error is above its proven bound", text, out);
  }
  const SpectrumEnclosure proof = enclose();
  if (proof.verdict && !out.marginal && *proof.verdict != spectrum.verdict) {
    out.wrong_class = true;
    fault("said to be " + class_name(spectrum.verdict) + ", proven to be " +
              class_name(*proof.verdict),
          text, out);
  }
  out.proven_class = proof.verdict;
}

Outcome judged(const HardCase& c) {
  Equilibrium at = solve(c.problem, c.nu, c.options);
  const SolveStatus status = at.status;
  const Counts counts = at.counts;
  Judgement judgement(c);
  Outcome out = status == SolveStatus::solved ? judgement.of_solved(std::move(at))
                                              : judgement.of_absence(status);
  out.status = status;
  out.work = work(counts);
  return out;
}

}  // namespace stationary::stress
