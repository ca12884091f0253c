// The events inside one step of a curve, each located.
//
// Where a test function f (event.hpp) changes sign over the step, f = 0 and G = 0 are solved
// together: a bracketing root finder (TOMS 748) on f along the arc, the bordered corrector bringing
// each of its points onto the curve, and from there the event's own equations in extended
// precision, which say what it is known to. Where f does not change sign but a parabola through the
// last three points dips towards zero inside the step, its extremum is sought on the curve: two
// zeros in one step are found so. What remains of the change in the number of negative directions
// is reported as unexplained.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "solver/curve.hpp"

namespace stationary {

struct Event {
  EventType type = EventType::none;
  Member member;      ///< error_bound: of the event's q
  double before = 0;  ///< bracket of the parameter, ascending
  double after = 0;
  bool located = false;  ///< else only bracketed: the member is the bracket's middle
};

template <int N>
class EventSearch {
 public:
  explicit EventSearch(const Curve<N>& curve) : curve_(&curve) {}

  /// Events between two points an arc apart, in order along it. earlier: the point before `from`
  /// and its distance, if there is one. starts: the curve starts at `from`, and functions that
  /// vanish there are none of this step's.
  std::vector<Event> run(const CurvePoint<N>& from, const CurvePoint<N>& to, const Arc<N>& arc,
                         const TestValues* earlier, double earlier_length, bool starts) {
    from_ = &from;
    to_ = &to;
    arc_ = &arc;
    found_.clear();
    for (std::size_t k = 0; k < TestValues::crossings; ++k) {
      const double a = from.tests.value[k];
      const double b = to.tests.value[k];
      if (!curve_->context().seeks(k)) continue;
      if (std::isnan(a) || std::isnan(b) || (starts && a == 0.0)) continue;
      // At rest a round body's inertias are equal: where the curve ends that is no event.
      if (to.member.nu == 0.0 && std::abs(b) <= 0x1p-50) continue;
      if ((a < 0.0) != (b < 0.0)) {
        locate(k, {0.0, a}, {1.0, b});
      } else if (k == TestValues::fold && curve_->family().along_nu()) {
        fold_dip();
      } else if (earlier != nullptr) {
        dip(k, earlier->value[k], earlier_length);
      }
    }
    if (curve_->context().seeks(TestValues::crossings))
      find_crossings(from.tests, to.tests, earlier, earlier_length);
    // A curve that starts where its parameter passes J1 = J2 starts at that event (follow.cpp).
    const bool at_event = starts && from.tests.value[TestValues::turn] == 0.0;
    if (curve_->context().sought.has(EventType::unexplained) && !at_event) explain_negative();
    std::ranges::sort(found_, {}, &Found::u);
    std::vector<Event> out;
    out.reserve(found_.size());
    for (Found& each : found_) out.push_back(std::move(each.event));
    return out;
  }

  /// Points evaluated so far.
  long evaluations() const { return evaluations_; }

 private:
  struct Found {
    double u;
    Event event;
  };
  struct Sample {
    double u;
    double value;
  };

  /// The completed point at u; false where the corrector fails.
  bool evaluate(double u, CurvePoint<N>& out) {
    ++evaluations_;
    const Corrected<N> corrected = curve_->at(from_->arc, *arc_, u);
    if (corrected.status != CorrectorStatus::converged) return false;
    out = curve_->complete(corrected.point);
    // The arc's own direction, as the two ends have it.
    if (out.arc.tangent.dot(arc_->direction(u)) < 0.0) return false;
    return true;
  }

  double value(std::size_t k, double u, double otherwise) {
    CurvePoint<N> point;
    if (!evaluate(u, point)) return otherwise;
    const double f = point.tests.value[k];
    return std::isnan(f) ? otherwise : f;
  }

  void locate(std::size_t k, Sample a, Sample b) {
    std::uintmax_t evaluations = 80;
    const auto f = [&](double u) { return value(k, u, a.value); };
    const auto close = [](double low, double high) { return high - low <= 0x1p-48; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, a.u, b.u, a.value, b.value, close, evaluations);
    add(k, low, high);
  }

  void add(std::size_t k, double low, double high) {
    CurvePoint<N> point;
    for (const double u : {0.5 * (low + high), low, high}) {
      if (!evaluate(u, point) || point.member.beyond_end()) continue;
      const EventType type = event_type(k, curve_->context(), point.tests);
      if (type == EventType::none) return;
      constexpr double reach = 0.02;  // of the step
      if (auto known = curve_->event_at(type, point.member, reach * arc_->length + 1e-9);
          known && !known->member.beyond_end()) {
        ++evaluations_;
        found_.push_back({u, {type, std::move(known->member), known->before, known->after, true}});
        return;
      }
      const double along = 0.5 * (high - low) + noise(k, u, point) / std::abs(slope(k, u));
      if (!(along < 0.5)) {  // nowhere in the step is the sign of f certain
        low = 0.0;
        high = 1.0;
        break;
      }
      Found out{u, {type, point.member, 0.0, 0.0, true}};
      const double own = curve_->corrector().curve_error(point.arc);
      out.event.member.error_bound = 2.0 * (along * arc_->length + own);
      std::tie(out.event.before, out.event.after) = around(u - along, u + along);
      found_.push_back(std::move(out));
      return;
    }
    // Known to be there, and no more.
    const EventType type = event_type(k, curve_->context(), from_->tests);
    if (type == EventType::none) return;
    const auto [before, after] = around(0.0, 1.0);
    found_.push_back({0.5 * (low + high), {type, from_->member, before, after, false}});
  }

  /// What the parameter is between at the ends of a part of the arc.
  std::pair<double, double> around(double low, double high) const {
    const double a = parameter(low);
    const double b = parameter(high);
    constexpr double rounding = 0x1p-50;
    return {bracket_of(std::min(a, b), rounding * std::abs(a))[0],
            bracket_of(std::max(a, b), rounding * std::abs(b))[1]};
  }

  /// Of the curve itself; the arc's where the corrector fails.
  double parameter(double u) const {
    const Corrected<N> corrected = curve_->at(from_->arc, *arc_, u);
    if (corrected.status == CorrectorStatus::converged) return corrected.point.p;
    return from_->arc.p + curve_->corrector().scale() * arc_->at(u)[N];
  }

  /// Of function k along the arc.
  double slope(std::size_t k, double u) {
    constexpr double apart = 1e-3;
    return (value(k, u + apart, 0.0) - value(k, u - apart, 0.0)) / (2.0 * apart);
  }

  /// What function k is known to at u: what the point's errors make of it, and those of the
  /// Lambdas. Where two collide their own errors are roots of what their square's is: beside it.
  double noise(std::size_t k, double u, const CurvePoint<N>& point) {
    constexpr double errors = 32.0;
    constexpr double apart = 1e-3;
    const double own = errors * curve_->corrector().curve_error(point.arc);
    if (k < TestValues::collision) return own;
    if (k > TestValues::collision) return std::max(own, mode_noise(point.member));
    CurvePoint<N> beside;
    if (!evaluate(u + apart, beside) && !evaluate(u - apart, beside)) return own;
    const double root = std::sqrt(std::abs(beside.tests.value[k]));
    return std::max(own, 2.0 * root * mode_noise(beside.member));
  }

  /// The largest relative error of a Lambda that no symmetry forces.
  static double mode_noise(const Member& at) {
    double out = 0.0;
    for (int i = 0; at.spectrum && i < at.spectrum->modes; ++i) {
      const Mode& mode = at.spectrum->mode[static_cast<std::size_t>(i)];
      const double size = std::hypot(mode.lambda_re, mode.lambda_im);
      if (!mode.forced_zero && size > 0.0) out = std::max(out, mode.lambda_error / size);
    }
    return out;
  }

  /// Two zeros of function k inside the step? f at the earlier point, and its distance.
  void dip(std::size_t k, double earlier, double earlier_length) {
    const double a = from_->tests.value[k];
    const double b = to_->tests.value[k];
    if (std::isnan(earlier) || (earlier < 0.0) != (a < 0.0)) return;
    // Newton's form through (-l, earlier), (0, a), (1, b), in units of the arc.
    const double l = earlier_length / arc_->length;
    const double d01 = b - a;
    const double d10 = (a - earlier) / l;
    const double curvature = (d01 - d10) / (1.0 + l);
    if (may_touch_zero({a, d01 - curvature, curvature}, b)) search_dip(k, a, b);
  }

  /// Two turns of the parameter inside the step? Its slopes at both ends and what it gained.
  void fold_dip() {
    const double a = arc_->length * arc_->from[N];
    const double b = arc_->length * arc_->to[N];
    const double gain = arc_->chord[N];
    const Parabola slope{a, 6.0 * gain - 4.0 * a - 2.0 * b, 3.0 * (a + b) - 6.0 * gain};
    if (!may_touch_zero(slope, b)) return;
    constexpr std::size_t k = TestValues::fold;
    search_dip(k, from_->tests.value[k], to_->tests.value[k]);
  }

  /// a + u (slope + u curvature), 0 <= u <= 1
  struct Parabola {
    double a;
    double slope;
    double curvature;
  };

  /// Whether it comes near zero between its ends; b is what it should be at 1.
  static bool may_touch_zero(const Parabola& f, double b) {
    if (f.curvature * f.a <= 0.0) return false;  // bends away from zero
    const double vertex = -0.5 * f.slope / f.curvature;
    if (!(vertex > -0.1 && vertex < 1.1)) return false;
    const double least = f.a + vertex * (f.slope + vertex * f.curvature);
    return least * f.a <= 0.0 || std::abs(least) <= 0.3 * std::min(std::abs(f.a), std::abs(b));
  }

  void search_dip(std::size_t k, double a, double b) {
    const double sign = a < 0.0 ? -1.0 : 1.0;
    std::uintmax_t evaluations = 25;
    const auto [u, f] = boost::math::tools::brent_find_minima(
        [&](double s) { return sign * value(k, s, a); }, 0.0, 1.0, 20, evaluations);
    if (!(f < 0.0)) return;
    locate(k, {0.0, a}, {u, sign * f});
    locate(k, {u, sign * f}, {1.0, b});
  }

  /// Crossings of different blocks: over stretches of the step where each block keeps its numbers
  /// of real and of negative Lambda.
  void find_crossings(const TestValues& from, const TestValues& to, const TestValues* earlier,
                      double earlier_length) {
    // A pair may touch zero and come back: then its signature is another, in the same composition.
    if (from.composition == to.composition && found_.empty()) {
      crossings_between({0.0, from}, {1.0, to});
      if (earlier != nullptr && earlier->composition == from.composition) {
        for (std::size_t k = TestValues::crossings; k < TestValues::count; ++k)
          if ((from.value[k] < 0.0) == (to.value[k] < 0.0) && is_opposite(from, k))
            dip(k, earlier->value[k], earlier_length);
      }
      return;
    }
    std::vector<double> borders;
    for (const Found& each : found_) borders.push_back(each.u);
    std::ranges::sort(borders);
    borders.insert(borders.begin(), 0.0);  // the ends too: at rest the spin's own pair is missing
    borders.push_back(1.0);
    constexpr double aside = 1e-6;
    for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
      const double begin = borders[k] + aside;
      const double end = borders[k + 1] - aside;
      CurvePoint<N> first;
      CurvePoint<N> last;
      if (begin < end && evaluate(begin, first) && evaluate(end, last))
        crossings_between({begin, first.tests}, {end, last.tests});
    }
  }

  struct Tested {
    double u;
    TestValues tests;
  };

  static bool is_opposite(const TestValues& tests, std::size_t k) {
    return (tests.opposite >> static_cast<unsigned>(k - TestValues::crossings)) & 1U;
  }

  void crossings_between(const Tested& a, const Tested& b) {
    if (a.tests.composition != b.tests.composition) return;
    for (std::size_t k = TestValues::crossings; k < TestValues::count; ++k) {
      const double fa = a.tests.value[k];
      const double fb = b.tests.value[k];
      if (std::isnan(fa) || std::isnan(fb) || (fa < 0.0) == (fb < 0.0)) continue;
      if (is_opposite(a.tests, k) || is_opposite(b.tests, k)) locate(k, {a.u, fa}, {b.u, fb});
    }
  }

  /// Whether the located events account for the change of `negative`; else brackets the change.
  void explain_negative() {
    if (!from_->member.spectrum || !to_->member.spectrum) return;
    // A circle's count is that of (iii), which its ellipses at other rates do not change.
    if (curve_->context().two_polar && curve_->context().circle) return;
    const Spectrum& a = *from_->member.spectrum;
    const Spectrum& b = *to_->member.spectrum;
    if (a.modes != b.modes || a.negative == b.negative) return;
    if constexpr (N >=
                  4) {  // spectra of the whole problem: what their bounds leave open is no event
      if (a.verdict == StabilityClass::marginal || b.verdict == StabilityClass::marginal) return;
    }
    int most = 0;
    bool exchange = false;
    for (const Found& each : found_) {
      most += negative_change(each.event.type, curve_->context());
      // J1 = J2: the direction conjugate to the symmetry may change its sign there.
      exchange = exchange || each.event.type == EventType::inertia_exchange;
    }
    const int change = std::abs(a.negative - b.negative);
    if (change <= most && (most - change) % 2 == 0) return;
    if (exchange && curve_->context().material_symmetry) return;
    double low = 0.0;
    double high = 1.0;
    CurvePoint<N> middle = *to_;
    for (int k = 0; k < 50; ++k) {
      const double u = 0.5 * (low + high);
      if (!evaluate(u, middle)) break;
      (middle.member.spectrum->negative == a.negative ? low : high) = u;
    }
    const auto [before, after] = around(low, high);
    found_.push_back(
        {0.5 * (low + high), {EventType::unexplained, middle.member, before, after, false}});
  }

  const Curve<N>* curve_;
  const CurvePoint<N>* from_ = nullptr;
  const CurvePoint<N>* to_ = nullptr;
  const Arc<N>* arc_ = nullptr;
  std::vector<Found> found_;
  long evaluations_ = 0;
};

}  // namespace stationary
