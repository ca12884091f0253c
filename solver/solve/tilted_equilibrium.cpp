#include "solver/solve/tilted_equilibrium.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "solver/family/follow_sheet.hpp"
#include "solver/newton/newton.hpp"

namespace stationary {
namespace {

/// A family's equations at one p, as Newton's method takes them.
struct AtParameter {
  static constexpr int dimension = 2;
  const Family<2>& family;
  double p;
  FamilyLinearization<2> linearize(const ReducedVector<2>& x) const {
    return family.linearize(x, p);
  }
};

/// A point of a sheet where its axis may leave its own in the plane.
struct TiltPoint {
  Branch branch;
  double nu;
  Stretch q;
};

/// Keeps the tilts into a plane.
class TiltSink final : public CurveSink {
 public:
  TiltSink(Branch branch, TiltPlane plane, std::vector<TiltPoint>& out)
      : branch_(branch), own_(axis(in_plane_branch(plane))), out_(&out) {}

  void row(const Member& member, EventType event) override {
    if (event != EventType::tilt) return;
    // (iii) tilts into either plane: this is the one whose inertias are equal.
    const auto I = locked_inertia(member.body, member.q);
    if (std::abs(I(own_, own_) - I(2, 2)) <= 1e-9 * I(2, 2))
      out_->push_back({branch_, member.nu, member.q});
  }

 private:
  Branch branch_;
  int own_;
  std::vector<TiltPoint>* out_;
};

/// Keeps the two ends.
class EndSink final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override {
    if (count_++ == 0) first_ = {member, event};
    last_ = {member, event};
  }
  /// The end that is the limit of the range at p.
  const Member* at(double p) const {
    for (const auto* end : {&first_, &last_})
      if (end->second == EventType::limit && end->first.parameter == p) return &end->first;
    return nullptr;
  }
  std::string text() const {
    std::ostringstream out;
    out << "from |nu| = " << first_.first.parameter << " (" << name(first_.second) << ") to "
        << last_.first.parameter << " (" << name(last_.second) << ")";
    return out.str();
  }

 private:
  long count_ = 0;
  std::pair<Member, EventType> first_;
  std::pair<Member, EventType> last_;
};

class TiltedSolve {
 public:
  TiltedSolve(const Body& body, const Potential& potential, const TiltedRotation& motion,
              const SolveOptions& options)
      : body_(body),
        potential_(potential),
        motion_(motion),
        options_(options),
        family_(tilted_family(body, potential, motion.plane, false)) {}

  Equilibrium run() {
    if (options_.start) {
      from_start(unknowns<2>(*options_.start));
    } else {
      from_rest();
    }
    return out_;
  }

 private:
  void from_start(ReducedVector<2> x) {
    const NewtonResult found = newton(AtParameter{*family_, motion_.nu}, x);
    out_.counts.newton_steps += found.steps;
    out_.counts.jacobians += found.steps;
    ReducedVector<2> tail;
    Refined refined;
    if (found.converged) refined = family_->refine_at(x, tail, motion_.nu);
    out_.counts.extended_residuals += refined.steps;
    if (!refined.converged) {
      out_.status = SolveStatus::not_found;
      out_.message = "Newton from the given start did not converge";
      return;
    }
    adopt(family_->member(x, tail, motion_.nu, refined.error_bound), Connection::given_start,
          "Newton from the given start");
  }

  void from_rest() {
    const std::vector<TiltPoint> points = tilt_points();
    std::ostringstream failure;
    for (const TiltPoint& point : points) {
      if (stopped()) break;
      std::ostringstream origin;
      origin << "the tilt of branch (" << name(point.branch) << ") at nu = " << point.nu;
      const auto member = along_family(point, origin.str(), failure);
      if (!member) continue;
      adopt(*member, Connection::rest,
            "from rest to " + origin.str() + ", then along the tilted family");
      return;
    }
    if (stopped()) {
      out_.status = SolveStatus::interrupted;
      return;
    }
    out_.status = SolveStatus::not_found;
    out_.message = points.empty()
                       ? "no sheet through the rest state tilts in the plane " +
                             std::string(name(motion_.plane)) + "; solve.start may lead to another"
                       : failure.str() + "; solve.start may lead to another";
  }

  /// The tilts into the plane on the sheets through the rest state.
  std::vector<TiltPoint> tilt_points() {
    std::vector<TiltPoint> out;
    for (const Branch branch : {in_plane_branch(motion_.plane), Branch::iii}) {
      const Problem problem(body_, potential_, branch);
      const Equilibrium rest = solve(problem, 0.0);
      out_.counts += rest.counts;
      if (rest.status != SolveStatus::solved) continue;
      TiltSink sink(branch, motion_.plane, out);
      count(follow(axis_family(problem, {.nu = 0.0, .parameter = {}, .spectrum = false}), rest.q,
                   0.0, range(0.0, std::max(10.0 * rate(rest.q), 2.0 * motion_.nu)), sink));
    }
    return out;
  }

  /// An elastic rate of the body at rest, for a scale of nu.
  double rate(const Stretch& rest) const {
    const double stiffness = potential_.derivatives(rest).hessian.diagonal().maxCoeff();
    return std::sqrt(stiffness / std::min({body_.J1, body_.J2, body_.J3}));
  }

  /// The family's member at |nu|, followed to from its beginning at a tilt.
  std::optional<Member> along_family(const TiltPoint& point, const std::string& origin,
                                     std::ostringstream& failure) {
    if (!failure.str().empty()) failure << "; ";
    const std::optional<Member> start = just_inside(*family_, point.q, point.nu);
    if (!start) {
      failure << "no tilted family was found at " << origin;
      return std::nullopt;
    }
    const double p = motion_.nu;
    const bool ahead = start->nu < p;
    EndSink ends;
    count(follow(AnyFamily(tilted_family(body_, potential_, motion_.plane, false)), start->q,
                 start->nu, ahead ? range(0.0, p) : range(p, 2.0 * point.nu + p), ends));
    if (const Member* member = ends.at(p)) return *member;
    failure << "the tilted family that begins at " << origin << " was followed " << ends.text()
            << ", without coming to |nu| = " << p;
    return std::nullopt;
  }

  void adopt(const Member& member, Connection connection, const std::string& how) {
    if (member.beyond_end()) {
      std::ostringstream text;
      text << how << ": the balance there asks for "
           << (member.tilt_normal < 0.0 ? "nu3" : "nu1 or nu2")
           << "^2 = " << std::min(member.tilt_normal, member.tilt_in_plane) * member.nu * member.nu
           << " < 0, beyond an end of the tilted family";
      out_.status = SolveStatus::not_found;
      out_.message = text.str();
      return;
    }

    out_.q = member.q;
    out_.nu = member.angular_velocity;
    out_.residual = member.residual;
    out_.compatibility = member.compatibility;
    out_.error_bound = member.error_bound;
    out_.connection = connection;
    out_.message = how;
    out_.status = out_.residual <= acceptable_residual ? SolveStatus::solved : SolveStatus::failed;
  }

  FollowOptions range(double from, double to) const {
    FollowOptions out;
    out.continuation.from = from;
    out.continuation.to = to;
    out.continuation.step.tolerance = 1e-7;
    out.stop = options_.stop;
    return out;
  }
  void count(const FollowReport& report) {
    out_.counts.walk_steps += report.counts.steps;
    out_.counts.jacobians += report.counts.linearizations;
  }
  bool stopped() const {
    return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  }

  Body body_;
  Potential potential_;
  TiltedRotation motion_;
  SolveOptions options_;
  std::unique_ptr<Family<2>> family_;
  Equilibrium out_;
};

}  // namespace

Equilibrium solve_tilted(const Body& body, const Potential& potential, const TiltedRotation& motion,
                         const SolveOptions& options) {
  if (!(motion.nu > 0.0 && std::isfinite(motion.nu)))
    throw std::invalid_argument("|nu| finite and > 0");
  if (options.start) {
    require_positive_definite(*options.start);
    if (options.start->alpha != 0.0)
      throw std::invalid_argument("alpha = 0 in the start: the potential is isotropic");
  }
  return TiltedSolve(body, potential, motion, options).run();
}

std::optional<Spectrum> tilted_stability(const Body& body, const Potential& potential,
                                         const TiltedRotation& motion,
                                         const Equilibrium& equilibrium) {
  const auto family = tilted_family(body, potential, motion.plane, true);
  ReducedVector<2> x = unknowns<2>(equilibrium.q);
  ReducedVector<2> tail;
  const Refined refined = family->refine_at(x, tail, motion.nu);
  if (!refined.converged) return std::nullopt;
  return family->member(x, tail, motion.nu, equilibrium.error_bound).spectrum;
}

}  // namespace stationary
