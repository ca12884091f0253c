// Gathers the Lambdas of the blocks, each with its bound, and turns them into sorted modes and the
// verdict of spectrum.hpp.
//
// Whether two Lambda of one block can be told apart is asked here, of all of them, once: two that
// cannot may be a pair that has left the axis, unless both are imaginary and of one signature, or
// their block is a symmetric problem. The signature of a Lambda that is apart from zero and from
// all such others is certain: on the way to any other inputs within the bounds it cannot change.
#pragma once

#include <cmath>

#include "lib/number/elementary.hpp"
#include "lib/number/polynomial.hpp"
#include "lib/stability/spectrum.hpp"

namespace stationary {

inline int sign(double x) { return (x > 0.0) - (x < 0.0); }

/// Certainly positive for inputs uncertain by u.
inline bool positive(const Conditioned& x, double u) { return x.value > u * x.condition; }

/// Negative eigenvalues of [a b; b c] given its determinant.
inline int negatives_2(double a, double c, double det) {
  if (det < 0.0) return 1;
  if (det == 0.0) return a + c < 0.0 ? 1 : 0;
  return a + c < 0.0 ? 2 : 0;
}

/// A polynomial known through its conditioning: values and |change| <= u condition per coefficient.
template <int D>
struct UncertainPolynomial {
  Polynomial<double, D> value;
  Polynomial<double, D> spread;  ///< u condition

  UncertainPolynomial(const Polynomial<Conditioned, D>& p, double u) {
    for (std::size_t k = 0; k <= D; ++k) {
      value.c[k] = p.c[k].value;
      spread.c[k] = u * p.c[k].condition;
    }
  }
  /// Bound of a simple root's change: first order, corrected for curvature.
  double root_error(double root) const {
    const double slope = std::abs(value.slope(root));
    const double kappa = 0.5 * std::abs(value.curvature(root)) / slope;
    const double first = spread(std::abs(root)) / slope;
    double out = with_curvature(first, kappa);
    if (!(4.0 * kappa * first < 1.0)) out = std::fmin(out, any_root_error(root));
    return out + 0x1p-53 * std::abs(root);
  }
  /// Of a root however near others are: the matching distance of Ostrowski's theorem,
  /// (2 n - 1) (change of p / h)^(1/n), of n roots beside which the others make p = h (x - ...)^n.
  double any_root_error(double root) const {
    const double change = spread(std::abs(root));
    const double lead = std::abs(value.c[D]);
    if constexpr (D == 2) return 3.0 * std::sqrt(change / lead);
    if constexpr (D == 3) return 5.0 * cube_root(change / lead);
    if constexpr (D == 4) {
      // Of three, where they are near beside their distance from the fourth, h/lead.
      const double h = std::abs(4.0 * value.c[4] * root + value.c[3]);
      const double three = 5.0 * cube_root(2.0 * change / h);
      if (8.0 * three * lead < h) return three;
      return 7.0 * std::sqrt(std::sqrt(change / lead));
    }
  }
  double pair_error(double re, double im) const {
    // |p'| and |p''| at a complex root.
    const auto size_of = [&](std::size_t least, const auto& coefficient) {
      double at_re = 0.0;
      double at_im = 0.0;
      for (std::size_t k = D; k >= least; --k) {
        const double real =
            at_re * re - at_im * im + coefficient(static_cast<double>(k)) * value.c[k];
        at_im = at_re * im + at_im * re;
        at_re = real;
      }
      return hypotenuse(at_re, at_im);
    };
    const double slope = size_of(1, [](double k) { return k; });
    const double curvature = size_of(2, [](double k) { return k * (k - 1.0); });
    const double size = hypotenuse(re, im);
    return with_curvature(spread(size) / slope, 0.5 * curvature / slope) + 0x1p-53 * size;
  }
  /// Half the distance two roots around `mean` must keep to be told apart from a double root.
  double merging_distance(double mean) const {
    const double out = std::sqrt(2.0 * spread(std::abs(mean)) / std::abs(value.curvature(mean)));
    // Beside a third one the curvature vanishes.
    return D == 2 ? out : std::fmin(out, any_root_error(mean));
  }
};

/// Whether a Lambda can meet others of its block and leave the real axis with one of them.
enum class Axis { stays, may_leave };

class ModeCollector {
 public:
  /// unit: of rates, a power of two; what is given is in it.
  explicit ModeCollector(double unit = 1.0) : unit_(unit), unit2_(unit * unit) {}

  /// krein_if_imaginary: of the Lambda as it stands; 0 where even that is not known.
  void add_real(double lambda, double error, int krein_if_imaginary, Axis axis = Axis::stays) {
    add_real(lambda, error, krein_if_imaginary, axis, std::abs(lambda) > error);
  }
  /// has_sign: whether it is known not to be zero, which its own error need not say.
  void add_real(double lambda, double error, int krein_if_imaginary, Axis axis, bool has_sign) {
    const double rate = unit_ * std::sqrt(std::abs(lambda));
    Mode& m = next(axis, has_sign);
    m.lambda_re = unit2_ * lambda;
    m.lambda_error = unit2_ * error;
    if (lambda < 0.0) {
      m.im = rate;
      m.krein = krein_if_imaginary;
    } else if (lambda > 0.0) {
      m.re = rate;
    }
  }

  /// A conjugate pair of Lambda with im > 0: a quadruple of s, two modes; nothing is claimed of
  /// them where within the error they may be two real ones.
  void add_complex(double re, double im, double error) {
    const double size = hypotenuse(re, im);
    const double larger = std::sqrt(0.5 * (size + std::abs(re)));
    const double smaller = 0.5 * im / larger;
    const bool complex = 2.0 * error < im;  // apart from its conjugate, as in may_meet()
    for (int k = 0; k < 2; ++k) {
      Mode& m = next(Axis::may_leave, complex);
      m.re = unit_ * (re > 0.0 ? larger : smaller);
      m.im = unit_ * (re > 0.0 ? smaller : larger);
      m.lambda_re = unit2_ * re;
      m.lambda_im = unit2_ * im;
      m.lambda_error = unit2_ * error;
    }
  }

  void add_forced_zero() { next(Axis::stays, true).forced_zero = true; }

  /// The two roots of one quadratic factor. `collision_possible`: opposite signatures may meet
  /// here; krein(lambda) is the signature of a simple imaginary mode.
  template <int D, class S, class Krein>
  void add_pair(const RootPair<S>& pair, const UncertainPolynomial<D>& p, bool collision_possible,
                const Krein& krein) {
    const double mean = leading(pair.mean);
    const double separation = leading(pair.separation);
    const double merging = p.merging_distance(mean);
    const bool close = std::abs(separation) <= merging * merging;
    const Axis axis = collision_possible ? Axis::may_leave : Axis::stays;
    if (close && collision_possible) {
      const double error = merging + std::sqrt(std::abs(separation));
      if (separation < 0.0) {
        add_complex(mean, std::sqrt(-separation), error);
      } else {
        add_real(leading(pair.small), error, 0, axis);
        add_real(leading(pair.large), error, 0, axis);
      }
      return;
    }
    if (separation < 0.0 && collision_possible) {
      const double im = std::sqrt(-separation);
      add_complex(mean, im, p.pair_error(mean, im));
      return;
    }
    for (const S& root : {pair.small, pair.large}) {
      const double lambda = leading(root);
      // Close roots that cannot leave the axis are known as well as their double root is.
      const double error =
          close ? merging + std::sqrt(std::fmax(separation, 0.0)) : p.root_error(lambda);
      add_real(lambda, error, krein(root), axis);
    }
  }

  /// The roots of a cubic of (alpha, xi, zeta); forced: one of them is a symmetry's zero.
  template <class S, class Krein>
  void add_cubic(const Polynomial<S, 3>& p, const UncertainPolynomial<3>& uncertain, bool forced,
                 bool definite, const Krein& krein) {
    if (forced) {
      add_forced_zero();
      add_pair(quadratic_roots(p.c[2] / p.c[3], p.c[1] / p.c[3]), uncertain, !definite, krein);
      return;
    }
    const CubicRoots<S> roots = cubic_roots(p);
    const double single = leading(roots.single);
    add_real(single, uncertain.root_error(single), krein(roots.single),
             definite ? Axis::stays : Axis::may_leave);
    add_pair(roots.pair, uncertain, !definite, krein);
  }

  /// The modes added from here on belong to this block.
  void begin(Block block) { block_ = block; }
  void set_negative(int count) { negative_ = count; }
  /// E'' + c (P -+ |pi|)'' is definite for some c though E'' is not.
  void set_definite_with_momentum() { definite_with_momentum_ = true; }

  Spectrum finish() const {
    Spectrum out;
    out.negative = negative_;
    out.modes = static_cast<int>(count_);
    bool real = false;
    bool complex = false;
    bool undecided = false;
    bool all_positive = true;
    bool some_negative = false;
    double growth = 0.0;
    const std::array<std::size_t, 5> order = ascending();
    for (std::size_t k = 0; k < count_; ++k) {
      Mode& m = out.mode[k];
      m = modes_[order[k]];
      if (m.forced_zero) continue;
      if (m.re > growth) growth = m.re;
      if (grows_for_certain(m) && m.re > out.growth) out.growth = m.re;
      if (!decided_[order[k]] || may_meet_another(order[k])) {
        undecided = true;
        m.krein_open = m.im > 0.0 && m.re == 0.0;
        m.krein = 0;
      } else if (m.lambda_im > 0.0) {
        complex = true;
      } else if (m.lambda_re > 0.0) {
        real = true;
      } else {
        m.krein_open = m.krein == 0;
        all_positive = all_positive && m.krein > 0;
        some_negative = some_negative || m.krein < 0;
      }
    }
    if (real) {
      out.verdict = StabilityClass::unstable;
    } else if (undecided) {
      out.verdict = StabilityClass::marginal;
    } else if (complex) {
      out.verdict = StabilityClass::oscillatory;
    } else if (all_positive || definite_with_momentum_) {
      out.verdict = StabilityClass::stable;
    } else {
      out.verdict = some_negative ? StabilityClass::elliptic : StabilityClass::marginal;
    }
    if (out.verdict != StabilityClass::marginal) out.growth = growth;
    return out;
  }

 private:
  Mode& next(Axis axis, bool decided) {
    axis_[count_] = axis;
    decided_[count_] = decided;
    leaving_ = leaving_ || axis == Axis::may_leave;
    Mode& out = modes_[count_++];
    out.block = block_;
    return out;
  }

  /// By im, then re.
  std::array<std::size_t, 5> ascending() const {
    std::array<std::size_t, 5> out{};
    for (std::size_t k = 1; k < count_; ++k) {
      const Mode& m = modes_[k];
      std::size_t j = k;
      for (; j > 0; --j) {
        const Mode& other = modes_[out[j - 1]];
        if (!(m.im != other.im ? m.im < other.im : m.re < other.re)) break;
        out[j] = out[j - 1];
      }
      out[j] = k;
    }
    return out;
  }

  /// Lambda is off the negative axis, further than it may be wrong.
  static bool grows_for_certain(const Mode& m) {
    return m.lambda_re > m.lambda_error || m.lambda_im > 2.0 * m.lambda_error;
  }

  bool may_meet_another(std::size_t k) const {
    if (!leaving_ || axis_[k] == Axis::stays) return false;
    for (std::size_t j = 0; j < count_; ++j)
      if (j != k && axis_[j] == Axis::may_leave && may_meet(j, k)) return true;
    return false;
  }

  /// Of two that may leave: real ones that their bounds do not tell apart. The bounds are
  /// first-order: they hold where they are small against the distance.
  bool may_meet(std::size_t j, std::size_t k) const {
    const Mode& a = modes_[j];
    const Mode& b = modes_[k];
    if (a.block != b.block) return false;
    if (a.lambda_im > 0.0 || b.lambda_im > 0.0) return false;
    if (a.krein * b.krein > 0 && decided_[j] && decided_[k]) return false;
    const double error = std::fmax(a.lambda_error, b.lambda_error);
    return !(4.0 * error < std::abs(a.lambda_re - b.lambda_re));
  }

  const double unit_;
  const double unit2_;
  std::array<Mode, 5> modes_;
  std::array<Axis, 5> axis_{};
  std::array<bool, 5> decided_{};
  std::size_t count_ = 0;
  int negative_ = 0;
  bool leaving_ = false;  ///< any of them may leave the axis
  Block block_ = Block::even;
  bool definite_with_momentum_ = false;
};

}  // namespace stationary
