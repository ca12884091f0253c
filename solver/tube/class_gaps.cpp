#include "solver/tube/class_gaps.hpp"

#include <algorithm>
#include <deque>
#include <utility>

namespace stationary {
namespace {

/// A piece of the curves of one factor.
struct FactorPiece {
  const ProvenCurves* curves;
  CurvePiece piece;
};
using Together = std::vector<FactorPiece>;

class Gaps {
 public:
  Gaps(const ClassOver& class_over, double nu_end, long most, const std::atomic<bool>* stop)
      : class_over_(class_over), nu_end_(nu_end), most_(most), stop_(stop) {}

  /// Every choice of one tube of each factor.
  void begin(const std::vector<std::vector<std::unique_ptr<ProvenCurves>>>& factors,
             const Together& chosen = {}) {
    if (chosen.size() == factors.size()) {
      add(chosen);
      return;
    }
    for (const auto& curves : factors[chosen.size()]) {
      for (std::size_t k = 0; k < curves->tubes(); ++k) {
        const double h = curves->half_length(k);
        Together more = chosen;
        more.push_back({curves.get(), curves->piece(k, {-h, h})});
        if (common_q(more)) begin(factors, more);
      }
    }
  }

  ClassGaps run() {
    while (!queue_.empty()) {
      if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) {
        out_.interrupted = true;
        break;
      }
      Together next = std::move(queue_.front());
      queue_.pop_front();
      examine(std::move(next));
    }
    out_.gaps = merged(std::move(out_.gaps));
    return std::move(out_);
  }

 private:
  static std::optional<Interval> common_q(const Together& all) {
    Interval out = all.front().piece.q();
    for (const FactorPiece& each : all) {
      if (each.piece.within == Within::none || each.piece.q().apart_from(out)) return std::nullopt;
      out = common(out, each.piece.q());
    }
    return out;
  }
  void add(Together together) {
    if (common_q(together)) queue_.push_back(std::move(together));
  }

  void examine(Together together) {
    const Interval q = *common_q(together);
    // What has no part in it of one piece says nothing of the others.
    for (FactorPiece& each : together) each.piece = each.curves->trimmed(each.piece, q);
    if (out_.arcs >= most_) {
      out_.gaps.push_back(q);
      return;
    }
    ++out_.arcs;
    if (class_over_(arc_of(together, q))) return;
    const std::optional<std::size_t> widest = widest_of(together);
    if (!widest) {
      out_.gaps.push_back(q);
      return;
    }
    const FactorPiece& split = together[*widest];
    const Interval s = split.piece.s;
    const double middle = s.mid();
    for (const Interval& half : {Interval(s.lo, middle), Interval(middle, s.hi)}) {
      Together halved = together;
      halved[*widest].piece = split.curves->piece(split.piece.tube, half);
      add(std::move(halved));
    }
  }

  /// The widest that is worth halving.
  static std::optional<std::size_t> widest_of(const Together& together) {
    std::optional<std::size_t> out;
    for (std::size_t k = 0; k < together.size(); ++k)
      if (!is_narrow(together[k]) && (!out || together[k].piece.width > together[*out].piece.width))
        out = k;
    return out;
  }
  /// In q, relative, for near rest nu is small; or hardly wider than at one point.
  static bool is_narrow(const FactorPiece& member) {
    constexpr double narrow = 1e-13;
    const CurvePiece& piece = member.piece;
    if (piece.q().hi - piece.q().lo <= narrow * piece.q().hi) return true;
    if (piece.is_point()) return true;
    constexpr double small = 1e-6;
    return piece.width < small && piece.width <= 2.0 * member.curves->middle_of(piece).width;
  }

  /// The motions of the pieces together, at these q.
  MotionArc arc_of(const Together& together, const Interval& q) const {
    for (std::size_t leader = 0; leader < together.size(); ++leader)
      if (const auto out = arc_led_by(leader, together, q)) return *out;
    PlacedMotions all;
    for (const FactorPiece& each : together) each.curves->place(each.piece, Interval(0.0), all);
    return {.over = motions(all, nu_of(q, nu_end_)), .at = {}, .stretch_slope = {}, .nu_slope = {}};
  }

  /// Along u, s = middle + h u of one of the pieces; of the others s is a function of q. Nothing where
  /// one of these is not.
  std::optional<MotionArc> arc_led_by(std::size_t leader, const Together& together,
                                      const Interval& q) const {
    const FactorPiece& first = together[leader];
    const CurvePiece middle = first.curves->middle_of(first.piece);
    // A tube runs on beyond the end of the range, where nu_of() would take the motion's nu for that at the end.
    if (!middle.q().within({0.0, 1.0})) return std::nullopt;
    const double h =
        std::max(above(first.piece.s.hi - middle.s.lo), above(middle.s.hi - first.piece.s.lo));
    const Interval q_slope = first.piece.q_slope() * Interval(h);
    PlacedMotions over;
    PlacedMotions at;
    for (std::size_t k = 0; k < together.size(); ++k) {
      const auto& [curves, piece] = together[k];
      if (k == leader) {
        curves->place(piece, Interval(h), over);
        curves->place(middle, Interval(0.0), at);
        continue;
      }
      const auto there = curves->crossed(piece, middle.q());
      if (!there) return std::nullopt;
      curves->place(piece, q_slope / piece.q_slope(), over);
      curves->place(*there, Interval(0.0), at);
    }
    MotionArc out;
    out.over = motions(over, nu_of(q, nu_end_));
    out.at = motions(at, nu_of(middle.q(), nu_end_));
    out.stretch_slope = {over.xi.slope[0], over.zeta.slope[0], over.rho.slope[0]};
    // nu - nu_0 = nu_end^2 (q - q_0)/(nu + nu_0)
    out.nu_slope = square(Interval(nu_end_)) * q_slope / (out.over.nu + out.at.nu);
    out.has_slopes = over.has_slopes && out.nu_slope.bounded();
    return out;
  }
  static MotionBox motions(const PlacedMotions& of, const Interval& nu) {
    return {{of.xi.value, of.zeta.value, of.rho.value, of.alpha.value},
            nu,
            of.circle,
            {of.axis[0].value, of.axis[1].value}};
  }

  const ClassOver& class_over_;
  double nu_end_;
  long most_;
  const std::atomic<bool>* stop_;
  std::deque<Together> queue_;
  ClassGaps out_;
};

}  // namespace

ClassGaps class_gaps(const std::vector<std::vector<std::unique_ptr<ProvenCurves>>>& factors,
                     const ClassOver& class_over, double nu_end, long most,
                     const std::atomic<bool>* stop) {
  Gaps out(class_over, nu_end, most, stop);
  out.begin(factors);
  return out.run();
}

}  // namespace stationary
