// Values of the kernels of symmetric_kernel.hpp, in any number type.
//
// With c_j the Taylor coefficients of f^(k) at a,
//   E = sum c_2j y^j,   O = sum c_(2j+1) y^j,   O_y = sum (j+1) c_(2j+3) y^j,   ...
// where y is below a quarter of the squared radius of convergence; elsewhere from the values at
// a +- sqrt y and
//   O_y = (E[f'] - O)/(2 y),   O_yy = (O[f'']/2 - 3 O_y)/(2 y),   ...,
// where that loses a digit or two.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "lib/expression/symmetric_kernel.hpp"
#include "lib/number/double_double_functions.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/first_order_bound_functions.hpp"
#include "lib/number/interval_functions.hpp"
#include "lib/number/number.hpp"
#include "lib/number/odd_reciprocal.hpp"
#include "lib/number/taylor.hpp"

namespace stationary::expression {

/// Packs and pairs of them; whoever evaluates in these includes simd_pack_functions.hpp.
template <class R>
concept Packed = requires {
  typename R::Register;
}
|| requires { typename decltype(R::hi)::Register; };

/// f^(derivatives) in R, f with its exponent if it is a power.
template <class R>
struct KernelFunction {
  Function function;
  int derivatives;
  const R* exponent;

  KernelFunction differentiated(int times = 1) const {
    return {function, derivatives + times, exponent};
  }
};

/// 1/k in R, from a table where R is one of the solver's own types, as odd_reciprocal().
template <class R>
R whole_reciprocal(int k) {
  if constexpr (std::is_same_v<R, double> || std::is_same_v<R, DoubleDouble>) {
    static constexpr auto table = [] {
      std::array<R, 192> out{};
      for (std::size_t i = 1; i < out.size(); ++i) out[i] = R(1.0) / R(static_cast<double>(i));
      return out;
    }();
    return table[static_cast<std::size_t>(k)];
  } else {
    return R(1.0) / R(static_cast<double>(k));
  }
}

/// c[0 .. count): Taylor coefficients of f itself at a, then of f^(derivatives).
template <class R>
void taylor_coefficients(const KernelFunction<R>& f, const R& a, int count, R* c) {
  const int all = count + f.derivatives;
  const auto whole = [](int j) { return static_cast<double>(j); };
  switch (f.function) {
    case Function::power: {
      c[0] = pow(a, *f.exponent);
      const R inverse = R(1.0) / a;
      for (int j = 0; j + 1 < all; ++j)
        c[j + 1] = c[j] * ((*f.exponent - whole(j)) * inverse) * whole_reciprocal<R>(j + 1);
      break;
    }
    case Function::log: {
      c[0] = log(a);
      const R inverse = R(1.0) / a;
      R power = inverse;
      for (int j = 1; j < all; ++j) {
        c[j] = power / R(whole(j));
        power = -(power * inverse);
      }
      break;
    }
    case Function::exp:
      c[0] = exp(a);
      for (int j = 1; j < all; ++j) c[j] = c[j - 1] * whole_reciprocal<R>(j);
      break;
    case Function::sin:
    case Function::cos: {
      R even = f.function == Function::sin ? sin(a) : cos(a);
      R odd = f.function == Function::sin ? cos(a) : -sin(a);
      R factorial(1.0);
      for (int j = 0; j < all; ++j) {
        if (j > 0) factorial = factorial * R(whole(j));
        c[j] = (j % 2 == 0 ? even : odd) / factorial;
        if (j % 2 == 0) even = -even;
        if (j % 2 == 1) odd = -odd;
      }
      break;
    }
    case Function::tan:
    case Function::tanh: {
      // T' = 1 + T^2 or 1 - T^2.
      const bool plain = f.function == Function::tan;
      c[0] = plain ? tan(a) : tanh(a);
      for (int j = 0; j + 1 < all; ++j) {
        R square_j = c[0] * c[j];
        for (int i = 1; i <= j; ++i) square_j = square_j + c[i] * c[j - i];
        if (!plain) square_j = -square_j;
        if (j == 0) square_j = square_j + 1.0;
        c[j + 1] = square_j / R(whole(j + 1));
      }
      break;
    }
    case Function::atan: {
      // Its slope g: (1 + a^2 + 2 a h + h^2) g = 1; kept in c[j + 1] until divided by j + 1.
      c[0] = atan(a);
      const R q = R(1.0) / (square(a) + 1.0);
      for (int j = 0; j + 1 < all; ++j) {
        if (j == 0) {
          c[1] = q;
        } else {
          R g = 2.0 * (a * c[j]);
          if (j > 1) g = g + c[j - 1];
          c[j + 1] = -(g * q);
        }
      }
      for (int j = 2; j < all; ++j) c[j] = c[j] / R(whole(j));
      break;
    }
    case Function::sqrt:
    case Function::abs:
      for (int j = 0; j < all; ++j) c[j] = poison<R>();
  }
  for (int k = 0; k < f.derivatives; ++k)
    for (int j = 0; j + 1 < all - k; ++j) c[j] = c[j + 1] * whole(j + 1);
}

/// The series' coefficient of y^j, from those of Taylor.
template <class R>
R series_coefficient(KernelPart part, const R* c, int j) {
  const auto at = static_cast<std::size_t>(j);
  switch (part) {
    case KernelPart::even:
      return c[2 * at];
    case KernelPart::odd:
      return c[2 * at + 1];
    case KernelPart::odd_y:
      return static_cast<double>(j + 1) * c[2 * at + 3];
    default:
      return static_cast<double>((j + 1) * (j + 2)) * c[2 * at + 5];
  }
}

/// Taylor coefficients it takes for y^0 ... y^(count - 1).
constexpr int coefficients_for(int count) { return 2 * count + 4; }

/// The distance from a to the nearest singularity of f in the plane; for an entire f, as far as its
/// terms fall quickly.
inline double convergence_radius(Function f, double a) {
  constexpr double half_pi = 1.5707963267948966;
  switch (f) {
    case Function::power:
    case Function::log:
      return std::abs(a);
    case Function::tan:
      return half_pi - std::abs(std::remainder(a, 2.0 * half_pi));
    case Function::tanh:
      return hypotenuse(a, half_pi);
    case Function::atan:
      return hypotenuse(a, 1.0);
    default:
      return 2.0;
  }
}

/// f^(derivatives)(x).
template <class R>
R kernel_function_value(const KernelFunction<R>& f, const R& x) {
  std::array<R, 12> c;
  taylor_coefficients(f, x, 1, c.data());
  return c[0];
}

/// At the ends x, z = a +- sqrt y, root = sqrt y.
template <class R>
R kernel_at_ends(const KernelFunction<R>& f, KernelPart part, const R& x, const R& z,
                 const R& root) {
  switch (part) {
    case KernelPart::even:
      return 0.5 * (kernel_function_value(f, x) + kernel_function_value(f, z));
    case KernelPart::odd:
      return 0.5 * (kernel_function_value(f, x) - kernel_function_value(f, z)) / root;
    case KernelPart::odd_y:
      return 0.5 *
             (kernel_at_ends(f.differentiated(), KernelPart::even, x, z, root) -
              kernel_at_ends(f, KernelPart::odd, x, z, root)) /
             square(root);
    default:
      return 0.5 *
             (0.5 * kernel_at_ends(f.differentiated(2), KernelPart::odd, x, z, root) -
              3.0 * kernel_at_ends(f, KernelPart::odd_y, x, z, root)) /
             square(root);
  }
}

/// How many terms of a power series in x it takes for the precision of R; ratio is near |x|. Where x
/// is 0 its derivatives need not be.
template <class R>
int series_length(double ratio, int most) {
  constexpr bool plain = !requires(const R& x) { x.value; }
  &&!requires(const R& x) { x.v; };
  if (!(ratio > 0.0)) return plain ? 1 : std::min(most, 4);
  return std::min(
      most,
      static_cast<int>((significand_bits<R>() + 6) * double_double_log_two.hi / -log(ratio)) + 4);
}

/// The odd part of log and its y-derivatives, x = y/a^2 < 1/4:
///   O = sum x^j/(2j+1)/a,  O_y = sum (j+1) x^j/(2j+3)/a^3,  O_yy = sum (j+1)(j+2) x^j/(2j+5)/a^5.
template <class R>
R log_series(KernelPart part, const R& a, const R& y, double ratio) {
  const R inverse = R(1.0) / a;
  const R inverse2 = inverse * inverse;
  const R x = y * inverse2;
  const int shift = part == KernelPart::odd ? 0 : part == KernelPart::odd_y ? 1 : 2;
  R sum(0.0);
  for (int j = series_length<R>(ratio, 120) - 1; j >= 0; --j) {
    const double weight = shift == 0 ? 1.0 : shift == 1 ? j + 1.0 : (j + 1.0) * (j + 2.0);
    sum = sum * x + weight * odd_reciprocal<R>(j + shift);
  }
  sum = sum * inverse;
  for (int k = 0; k < shift; ++k) sum = sum * inverse2;
  return sum;
}

/// The same from one logarithm, norm = a^2 - y: E[f'] = a/norm and O[f''] = 2 a/norm^2.
template <class R>
R log_at_ends(KernelPart part, const R& a, const R& y, const R& norm) {
  using std::sqrt;
  const R root = sqrt(y);
  const R end = a + root;
  const R odd = 0.5 * log(end * end / norm) / root;
  if (part == KernelPart::odd) return odd;
  const R mean = a / norm;
  const R odd_y = 0.5 * (mean - odd) / y;
  if (part == KernelPart::odd_y) return odd_y;
  return 0.5 * (mean / norm - 3.0 * odd_y) / y;
}

/// Numbers that stand for a point, dual numbers included.
template <class R>
R kernel_of(const KernelFunction<R>& f, KernelPart part, const R& a, const R& y, const R& norm) {
  using std::sqrt;
  constexpr int bits = significand_bits<R>();
  constexpr int most = bits / 2 + 12;
  const double radius = convergence_radius(f.function, leading(a));
  const double ratio = leading(y) / (radius * radius);
  if (f.function == Function::log && f.derivatives == 0 && part != KernelPart::even) {
    // A wide number has digits to lose, and its series is long.
    return ratio < (bits > 64 ? 0x1p-6 : 0.25) ? log_series(part, a, y, ratio)
                                               : log_at_ends(part, a, y, norm);
  }
  if (ratio < 0.25) {
    const int terms = series_length<R>(ratio, most);
    // Room for the derivatives of f that are taken away.
    std::array<R, coefficients_for(most) + 6> c;
    taylor_coefficients(f, a, coefficients_for(terms), c.data());
    R sum = series_coefficient(part, c.data(), terms - 1);
    for (int j = terms - 2; j >= 0; --j) sum = sum * y + series_coefficient(part, c.data(), j);
    return sum;
  }
  // The end farther from zero first: the other one follows from the product of both.
  const R root = sqrt(y);
  if (leading(a) > 0.0) {
    const R x = a + root;
    return kernel_at_ends(f, part, x, R(norm / x), root);
  }
  const R z = a - root;
  return kernel_at_ends(f, part, R(norm / z), z, root);
}

/// Over intervals: a sum to y^(M - 1) and the term of y^M with its coefficient anywhere between
/// a - sqrt y and a + sqrt y (E, O and the y-derivatives of O are means of f, f', f''', ... over
/// that range with positive weights, so the remainder is Lagrange's), or from the ends.
Interval kernel_of(const KernelFunction<Interval>& f, KernelPart part, const Interval& a,
                   const Interval& y, const Interval& norm);

/// The k-th y-derivative of O: sum (j + 1) ... (j + k) c_(2 j + 2 k + 1) y^j, from k = 3 on by that
/// sum and its rest as above, or by O^(k) = (O^(k - 2)[f'']/2 - (2 k - 1) O^(k - 1))/(2 y).
Interval odd_derivative(const KernelFunction<Interval>& f, int k, const Interval& a,
                        const Interval& y, const Interval& norm);

/// Taylor numbers over intervals: by all partial derivatives in a and y up to their order.
template <int order>
Taylor<Interval, order> kernel_of(const KernelFunction<Taylor<Interval, order>>& f, KernelPart part,
                                  const Taylor<Interval, order>& a,
                                  const Taylor<Interval, order>& y,
                                  const Taylor<Interval, order>& norm) {
  using Along = Taylor<Interval, order>;
  const Interval p = f.function == Function::power ? f.exponent->value : Interval(1.0);
  const KernelFunction<Interval> g{f.function, f.derivatives, &p};
  // E_y = O[f']/2.
  const auto slope = [&](int in_a, int in_y) {
    const auto of = g.differentiated(in_a);
    const auto odd = [&](const KernelFunction<Interval>& each, int k) {
      return odd_derivative(each, k, a.value, y.value, norm.value);
    };
    if (part != KernelPart::even) return odd(of, static_cast<int>(part) - 1 + in_y);
    return in_y == 0 ? kernel_of(of, part, a.value, y.value, norm.value)
                     : 0.5 * odd(of.differentiated(), in_y - 1);
  };
  const auto whole = [](int k) { return Along(Interval(static_cast<double>(k))); };
  Along change_a = a;
  Along change_y = y;
  change_a.value = change_y.value = Interval(0.0);
  Along out(slope(0, 0));
  Along powers_a(Interval(1.0));  // change_a^i/i!
  for (int i = 0; i <= order; ++i) {
    Along powers = powers_a;
    for (int j = 0; i + j <= order; ++j) {
      if (i + j > 0) out = out + Along(slope(i, j)) * powers;
      powers = powers * change_y / whole(j + 1);
    }
    powers_a = powers_a * change_a / whole(i + 1);
  }
  if (f.function == Function::power) {
    int moved = 1;  // the first order that a change of the exponent has a part in
    while (moved <= order && (*f.exponent)[moved].lo == 0.0 && (*f.exponent)[moved].hi == 0.0)
      ++moved;
    for (; moved <= order; ++moved) out[moved] = Interval::entire();
  }
  return out;
}

/// What a change of a, y and the exponent does, each by its derivative.
Conditioned kernel_of(const KernelFunction<Conditioned>& f, KernelPart part, const Conditioned& a,
                      const Conditioned& y, const Conditioned& norm);

/// The value of a kernel node: index as in symmetric_kernel.hpp, exponent that of a power.
template <class R>
R kernel_value(Function function, int index, const R& a, const R& y, const R& norm,
               const R* exponent) {
  const KernelPart part = kernel_part(index);
  const int derivatives = kernel_derivatives(index);
  if constexpr (Packed<R>) {
    const R p = function == Function::power ? *exponent : R(1.0);
    return lane_by_lane(
        [&](const auto& a1, const auto& y1, const auto& norm1, const auto& p1) {
          using T = std::remove_cvref_t<decltype(a1)>;
          return kernel_of(KernelFunction<T>{function, derivatives, &p1}, part, a1, y1, norm1);
        },
        a, y, norm, p);
  } else if constexpr (requires {
                         a.value.lo;
                         a.slope;
                       }) {
    // Dual numbers over intervals: the chain rule.
    using T = std::remove_cvref_t<decltype(a.value)>;
    const T p = function == Function::power ? exponent->value : T(1.0);
    const KernelFunction<T> f{function, derivatives, &p};
    const auto at = [&](const KernelFunction<T>& g, KernelPart which) {
      return kernel_of(g, which, a.value, y.value, norm.value);
    };
    const T slope_a = at(f.differentiated(), part);
    const T slope_y = part == KernelPart::even    ? 0.5 * at(f.differentiated(), KernelPart::odd)
                      : part == KernelPart::odd   ? at(f, KernelPart::odd_y)
                      : part == KernelPart::odd_y ? at(f, KernelPart::odd_yy)
                                                  : T::entire();
    R out(at(f, part));
    for (std::size_t k = 0; k < out.slope.size(); ++k) {
      out.slope[k] = slope_a * a.slope[k] + slope_y * y.slope[k];
      if (function == Function::power) {
        const T& of_exponent = exponent->slope[k];
        if (!(of_exponent.lo == 0.0 && of_exponent.hi == 0.0)) out.slope[k] = T::entire();
      }
    }
    return out;
  } else {
    return kernel_of(KernelFunction<R>{function, derivatives, exponent}, part, a, y, norm);
  }
}

}  // namespace stationary::expression
