// What the solves of a family (family.hpp) have in common: Newton's method at one value of its
// parameter, and the way there along it from another of its motions. Both end in the family's
// correction with an extended-precision residual; what is returned is recomputed in lib, and that
// decides.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "lib/body/inertia.hpp"
#include "lib/matrix/small_matrix.hpp"
#include "solver/family/follow_sheet.hpp"
#include "solver/newton/newton.hpp"
#include "solver/solve/at_values.hpp"
#include "solver/solve/counted_steps.hpp"
#include "solver/solve/curve_points.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

/// A family's equations at one p, as Newton's method takes them.
template <int N>
struct AtParameter {
  static constexpr int dimension = N;
  struct At {
    ReducedVector<N> g;
    SmallMatrix<N> jacobian;
  };
  const Family<N>& family;
  double p;

  At linearize(const ReducedVector<N>& x) const {
    const FamilyLinearization<N> at = family.linearize(x, p);
    return {at.g, {at.jacobian}};
  }
};

/// Keeps the two ends of a sheet, and its events of one type.
class EndSink final : public CurveSink {
 public:
  explicit EndSink(EventType kept = EventType::none) : kept_(kept) {}

  void row(const Member& member, EventType event) override {
    if (count_++ == 0) first_ = {member, event};
    last_ = {member, event};
    if (event == kept_ && event != EventType::none) events.push_back(member);
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

  std::vector<Member> events;

 private:
  EventType kept_;
  long count_ = 0;
  std::pair<Member, EventType> first_;
  std::pair<Member, EventType> last_;
};

class FamilySolve {
 public:
  FamilySolve(const Body& body, const Potential& potential, const SolveOptions& options)
      : body_(body), potential_(potential), options_(options) {}

 protected:
  bool stopped() const {
    return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  }

  /// An elastic rate of the body at rest, for a scale of nu.
  double rate(const Stretch& rest) const {
    const double stiffness = potential_.derivatives(rest).hessian.diagonal().maxCoeff();
    return std::sqrt(stiffness / std::min({body_.J1, body_.J2, body_.J3}));
  }

  FollowOptions range(double from, double to, const EventSet& events) const {
    FollowOptions out = curve_options(from, to, options_.stop);
    out.events = events;
    return out;
  }

  /// The events of one type on the sheet through the rest state, from nu = 0 far beyond `to`.
  std::vector<Member> events_from_rest(const AnyFamily& family, const Stretch& rest, double to,
                                       EventType type) {
    EndSink sink(type);
    const double end = std::max(10.0 * rate(rest), 2.0 * to);
    count(follow(family, rest, 0.0, range(0.0, end, EventSet::none().add(type)), sink));
    return sink.events;
  }

  template <int N>
  void by_newton(const Family<N>& family, ReducedVector<N> x, double p, Connection connection,
                 const std::string& how) {
    const NewtonResult found = newton(AtParameter<N>{family, p}, x);
    out_.counts.newton_steps += found.steps;
    out_.counts.jacobians += found.steps;
    ReducedVector<N> tail;
    Refined refined;
    if (found.converged) refined = family.refine_at(x, tail, p);
    out_.counts.extended_residuals += refined.steps;
    if (!refined.converged) return fail(how + " did not converge");
    adopt(family.member(x, tail, p, refined.error_bound), connection, how);
  }

  /// From a motion of the family at p to `to`, the limit of the range it is followed in.
  template <int N>
  void along(const Family<N>& family, const Stretch& q, double p, double to,
             const FollowOptions& how, const std::string& what) {
    EndSink ends;
    const FollowReport report = follow_family(family, q, p, how, ends);
    count(report);
    if (report.interrupted) {
      out_.status = SolveStatus::interrupted;
    } else if (!report.failure.empty()) {
      fail(what + ": " + report.failure);
    } else if (const Member* member = ends.at(to)) {
      adopt(*member, Connection::rest,
            "along " + what + " in " + counted_steps(report.counts.steps));
    } else if (report.out_of_points) {
      fail(what + " was given up after " + std::to_string(report.points) +
           " points, without coming to |nu| = " + text(to));
    } else {
      fail(what + " was followed " + ends.text() + ", without coming to |nu| = " + text(to));
    }
  }

  /// As along() to each of these |nu| of a range that has no motion yet, on the sheet followed once.
  /// limits(nu): the range that along() is given, nu one of its ends.
  template <int N, class Limits>
  void along_each(const Family<N>& family, const Stretch& q, double p, const Limits& limits,
                  const NumberRange& all, std::span<AtValue> at) {
    double least = p;
    double most = p;
    for (const double nu : {all.least(), std::clamp(p, all.least(), all.most()), all.most()}) {
      const auto [from, to] = limits(nu);
      least = std::min(least, from);
      most = std::max(most, to);
    }
    if (least == most) return;
    CoordinateRows<N> sink(family);
    count(follow_family(family, q, p, curve_options(least, most, options_.stop), sink));
    if (sink.rows().empty() || stopped()) return;
    CurvePoints<N> curve(family, sink.rows(), most);
    const std::size_t start = nearest<N>(curve.rows(), family.coordinates(q, p), p);
    for (AtValue& each : at) {
      if (stopped()) return;
      if (each.solved()) continue;
      const auto [from, to] = limits(each.value);
      const auto row = met<N>(curve.rows(), start, from, to, each.value);
      if (!row) continue;
      begin_anew();
      if (!at_place(family, curve.near(*row, each.value)))
        along(family, q, p, each.value, range(from, to, EventSet::none()), {});
      each.equilibrium = out_;
    }
  }

  void adopt(const Member& member, Connection connection, const std::string& how) {
    if (member.beyond_end()) {
      const bool normal = member.tilt_normal < 0.0;
      const double share = std::min(member.tilt_normal, member.tilt_in_plane);
      return fail(how + ": the balance there asks for " + (normal ? "nu3" : "nu1 or nu2") +
                  "^2 = " + text(share * member.nu * member.nu) +
                  " < 0, beyond an end of the tilted family");
    }
    out_.q = member.q;
    out_.nu = member.angular_velocity;
    out_.residual = member.residual;
    out_.compatibility = member.compatibility;
    out_.error_bound = member.error_bound;
    out_.connection = connection;
    out_.message = how;
    // Near a material axis compatibility is a difference of small products: of |pi| |nu| then.
    const Vector3<double> pi = locked_inertia(body_, out_.q) * out_.nu;
    const double mismatch = compatibility_residual(body_, out_.q, out_.nu).norm();
    const bool solved = out_.residual <= acceptable_residual &&
                        mismatch <= acceptable_residual * pi.norm() * out_.nu.norm();
    out_.status = solved ? SolveStatus::solved : SolveStatus::failed;
    if (!solved) out_.message += "; but the recomputed residual is no equilibrium's";
  }

  /// What was counted stays.
  void begin_anew() {
    const Counts counts = out_.counts;
    out_ = Equilibrium();
    out_.counts = counts;
  }

  void fail(const std::string& message) {
    out_.status = stopped() ? SolveStatus::interrupted : SolveStatus::not_found;
    out_.message = message;
  }
  void count(const FollowReport& report) {
    out_.counts.walk_steps += report.counts.steps;
    out_.counts.jacobians += report.counts.linearizations;
  }
  static std::string text(double x) {
    std::ostringstream out;
    out << x;
    return out.str();
  }

  const Body& body_;
  const Potential& potential_;
  const SolveOptions& options_;
  Equilibrium out_;

 private:
  template <int N>
  static std::size_t nearest(const std::vector<CurveRow<N>>& rows, const ReducedVector<N>& x,
                             double p) {
    const auto far = [&](const CurveRow<N>& row) {
      return std::abs(row.p - p) + ((row.x - x).array() / x.array()).abs().maxCoeff();
    };
    return static_cast<std::size_t>(std::ranges::min_element(rows, {}, far) - rows.begin());
  }

  /// The later of the two rows between which a walk from `start` comes to p, one end of the range
  /// that it stays in; against the parameter first, as along() prefers.
  template <int N>
  static std::optional<std::size_t> met(const std::vector<CurveRow<N>>& rows, std::size_t start,
                                        double from, double to, double p) {
    for (const bool back : {true, false}) {
      for (std::size_t k = start; back ? k > 0 : k + 1 < rows.size(); back ? --k : ++k) {
        const double next = rows[back ? k - 1 : k + 1].p;
        if (next > from && next < to) continue;
        if ((p == to && next >= to) || (p == from && next <= from)) return back ? k : k + 1;
        break;
      }
    }
    return std::nullopt;
  }

  /// The motion at a place of a curve; false where the correction leads elsewhere.
  template <int N>
  bool at_place(const Family<N>& family, const typename CurvePoints<N>::Near& near) {
    ReducedVector<N> x = near.x;
    ReducedVector<N> tail;
    const Refined refined = family.refine_at(x, tail, near.p);
    out_.counts.extended_residuals += refined.steps;
    if (!refined.converged) return false;
    const bool positive = family.linearize(x, near.p).jacobian.determinant() > 0.0;
    if (!CurvePoints<N>::stays(near, x, positive)) return false;
    adopt(family.member(x, tail, near.p, refined.error_bound), Connection::rest, {});
    return out_.status == SolveStatus::solved;
  }
};

/// At a solution, corrected once more in extended precision.
template <int N>
std::optional<Spectrum> family_spectrum(const Family<N>& family, const Equilibrium& equilibrium,
                                        double p) {
  ReducedVector<N> x = family.coordinates(equilibrium.q, p);
  ReducedVector<N> tail;
  const Refined refined = family.refine_at(x, tail, p);
  if (!refined.converged) return std::nullopt;
  return family.member(x, tail, p, equilibrium.error_bound).spectrum;
}

}  // namespace stationary
