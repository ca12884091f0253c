// Gathers the Lambdas of the blocks, each with its bound, and turns them into sorted modes and the
// verdict of spectrum.hpp.
#pragma once

#include <cmath>
#include <utility>

#include "lib/polynomial.hpp"
#include "lib/spectrum.hpp"

namespace stationary {

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
    return with_curvature(spread(std::abs(root)) / slope, kappa) + 0x1p-53 * std::abs(root);
  }
  double pair_error(double re, double im) const {
    // |p'| at a complex root.
    double slope_re = 0.0;
    double slope_im = 0.0;
    for (std::size_t k = D; k > 0; --k) {
      const double real = slope_re * re - slope_im * im + static_cast<double>(k) * value.c[k];
      slope_im = slope_re * im + slope_im * re;
      slope_re = real;
    }
    const double size = std::hypot(re, im);
    return spread(size) / std::hypot(slope_re, slope_im) + 0x1p-53 * size;
  }
  /// Half the distance two roots around `mean` must keep to be told apart from a double root.
  double merging_distance(double mean) const {
    return std::sqrt(2.0 * spread(std::abs(mean)) / std::abs(value.curvature(mean)));
  }
};

class ModeCollector {
 public:
  void add_real(double lambda, double error, int krein_if_imaginary) {
    Mode m;
    m.lambda_re = lambda;
    m.lambda_error = error;
    m.re = lambda > 0.0 ? std::sqrt(lambda) : 0.0;
    m.im = lambda < 0.0 ? std::sqrt(-lambda) : 0.0;
    const bool decided = std::abs(lambda) > error;
    m.krein = lambda < 0.0 && decided ? krein_if_imaginary : 0;
    push(m);
    if (!decided) {
      undecided_ = true;
    } else if (lambda > 0.0) {
      real_ = true;
    } else {
      definite_ = definite_ && krein_if_imaginary > 0;
    }
  }

  /// A conjugate pair of Lambda with im > 0: a quadruple of s, two modes.
  void add_complex(double re, double im, double error) {
    Mode m;
    m.lambda_re = re;
    m.lambda_im = im;
    m.lambda_error = error;
    const double size = std::hypot(re, im);
    if (re > 0.0) {
      m.re = std::sqrt(0.5 * (size + re));
      m.im = 0.5 * im / m.re;
    } else {
      m.im = std::sqrt(0.5 * (size - re));
      m.re = 0.5 * im / m.im;
    }
    push(m);
    push(m);
    complex_ = true;
  }

  /// A pair that may be real or complex: two modes, nothing claimed.
  void add_undecided(double re, double im, double error) {
    const bool claimed = complex_;
    add_complex(re, im, error);
    complex_ = claimed;
    undecided_ = true;
  }

  void add_forced_zero() {
    Mode m;
    m.forced_zero = true;
    push(m);
  }

  /// The two roots of one quadratic factor. `collision_possible`: opposite signatures may meet
  /// here; krein(lambda) is the signature of a simple imaginary mode.
  template <int D, class S, class Krein>
  void add_pair(const RootPair<S>& pair, const UncertainPolynomial<D>& p, bool collision_possible,
                const Krein& krein) {
    const double mean = leading(pair.mean);
    const double separation = leading(pair.separation);
    const double merging = p.merging_distance(mean);
    const bool close = std::abs(separation) <= merging * merging;
    if (close && collision_possible) {
      const double error = merging + std::sqrt(std::abs(separation));
      if (separation < 0.0) {
        add_undecided(mean, std::sqrt(-separation), error);
      } else {
        add_real(leading(pair.small), error, 0);
        add_real(leading(pair.large), error, 0);
      }
      undecided_ = true;
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
      add_real(lambda, error, krein(root));
    }
  }

  /// The modes added from here on belong to this block.
  void begin(Block block) { block_ = block; }
  void set_negative(int count) { negative_ = count; }
  /// E'' + c (P -+ |pi|)'' is definite for some c though E'' is not.
  void set_definite_with_momentum() { definite_with_momentum_ = true; }

  Spectrum finish() const {
    Spectrum out;
    out.modes = count_;
    out.mode = modes_;
    const auto before = [](const Mode& a, const Mode& b) {
      return a.im != b.im ? a.im < b.im : a.re < b.re;
    };
    for (std::size_t k = 1; k < index(count_); ++k)
      for (std::size_t j = k; j > 0 && before(out.mode[j], out.mode[j - 1]); --j)
        std::swap(out.mode[j], out.mode[j - 1]);
    out.negative = negative_;
    if (real_) {
      out.verdict = StabilityClass::unstable;
    } else if (undecided_) {
      out.verdict = StabilityClass::marginal;
    } else if (complex_) {
      out.verdict = StabilityClass::oscillatory;
    } else {
      out.verdict =
          definite_ || definite_with_momentum_ ? StabilityClass::stable : StabilityClass::elliptic;
    }
    if (real_ || out.verdict == StabilityClass::oscillatory)
      for (int k = 0; k < count_; ++k) out.growth = std::fmax(out.growth, modes_[index(k)].re);
    return out;
  }

 private:
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
  void push(const Mode& m) {
    modes_[index(count_)] = m;
    modes_[index(count_++)].block = block_;
  }

  std::array<Mode, 5> modes_;
  Block block_ = Block::even;
  int count_ = 0;
  int negative_ = 0;
  bool real_ = false;
  bool complex_ = false;
  bool undecided_ = false;
  bool definite_ = true;
  bool definite_with_momentum_ = false;
};

}  // namespace stationary
