// Kernels over intervals and of conditioned numbers, which every solver comes by.
#include "lib/tape/kernel_value.hpp"

namespace stationary::expression {

Interval kernel_of(const KernelFunction<Interval>& f, KernelPart part, const Interval& a,
                   const Interval& y, const Interval& norm) {
  if (!a.bounded() || !y.bounded()) return Interval::entire();
  const Interval positive(std::max(y.lo, 0.0), std::max(y.hi, 0.0));
  const Interval root = sqrt(positive);
  const Interval range = hull(a - root, a + root);
  constexpr int terms = 18;
  std::array<Interval, coefficients_for(terms + 1) + 6> c;
  taylor_coefficients(f, range, coefficients_for(1), c.data());
  Interval out = series_coefficient(part, c.data(), 0);
  const auto narrowed = [&](const Interval& other) {
    if (!other.bounded()) return;
    out = out.bounded() ? common(out, other) : other;
  };
  const double radius = convergence_radius(f.function, a.mid());
  if (positive.hi < 0.0625 * radius * radius) {
    taylor_coefficients(f, range, coefficients_for(terms + 1), c.data());
    Interval sum = series_coefficient(part, c.data(), terms);
    taylor_coefficients(f, a, coefficients_for(terms), c.data());
    for (int j = terms - 1; j >= 0; --j)
      sum = sum * positive + series_coefficient(part, c.data(), j);
    narrowed(sum);
  } else if (positive.lo > 0.0) {
    const Interval larger = a.mid() > 0.0 ? a + root : a - root;
    const Interval smaller = norm / larger;
    narrowed(a.mid() > 0.0 ? kernel_at_ends(f, part, larger, smaller, root)
                           : kernel_at_ends(f, part, smaller, larger, root));
  }
  return out;
}

Interval odd_derivative(const KernelFunction<Interval>& f, int k, const Interval& a,
                        const Interval& y, const Interval& norm) {
  constexpr KernelPart parts[] = {KernelPart::odd, KernelPart::odd_y, KernelPart::odd_yy};
  if (k < 3) return kernel_of(f, parts[k], a, y, norm);
  if (!a.bounded() || !y.bounded()) return Interval::entire();
  const Interval positive(std::max(y.lo, 0.0), std::max(y.hi, 0.0));
  const Interval root = sqrt(positive);
  const Interval range = hull(a - root, a + root);
  constexpr int terms = 14;
  std::array<Interval, 2 * terms + 32> c;
  const auto term = [&](int j) {
    double weight = 1.0;
    for (int i = 1; i <= k; ++i) weight *= j + i;
    return weight * c[static_cast<std::size_t>(2 * (j + k) + 1)];
  };
  const auto count = [k](int j) { return 2 * (j + k) + 2; };
  taylor_coefficients(f, range, count(0), c.data());
  Interval out = term(0);
  const auto narrowed = [&](const Interval& other) {
    if (!other.bounded()) return;
    out = out.bounded() ? common(out, other) : other;
  };
  const double radius = convergence_radius(f.function, a.mid());
  if (positive.hi < 0.0625 * radius * radius) {
    taylor_coefficients(f, range, count(terms), c.data());
    Interval sum = term(terms);
    taylor_coefficients(f, a, count(terms - 1), c.data());
    for (int j = terms - 1; j >= 0; --j) sum = sum * positive + term(j);
    narrowed(sum);
  } else if (positive.lo > 0.0) {
    narrowed((0.5 * odd_derivative(f.differentiated(2), k - 2, a, y, norm) -
              (2.0 * k - 1.0) * odd_derivative(f, k - 1, a, y, norm)) /
             (2.0 * positive));
  }
  return out;
}

Conditioned kernel_of(const KernelFunction<Conditioned>& f, KernelPart part, const Conditioned& a,
                      const Conditioned& y, const Conditioned& norm) {
  const double p = f.function == Function::power ? f.exponent->value : 1.0;
  const KernelFunction<double> plain{f.function, f.derivatives, &p};
  const auto at = [&](const KernelFunction<double>& g, KernelPart which) {
    return kernel_of(g, which, a.value, y.value, norm.value);
  };
  const double slope_a = at(plain.differentiated(), part);
  // O_yyy is at most a twelfth of O_yy[f''] where the seventh derivative of f keeps its sign.
  const double slope_y =
      part == KernelPart::even    ? 0.5 * at(plain.differentiated(), KernelPart::odd)
      : part == KernelPart::odd   ? at(plain, KernelPart::odd_y)
      : part == KernelPart::odd_y ? at(plain, KernelPart::odd_yy)
                                  : 0.5 * at(plain.differentiated(2), KernelPart::odd_yy);
  const double value = at(plain, part);
  double condition = std::abs(slope_a) * a.condition + std::abs(slope_y) * y.condition;
  if (f.function == Function::power && f.exponent->condition > 0.0) {
    const double spread = std::abs(log(std::abs(a.value))) + std::abs(log(norm.value));
    condition +=
        (std::abs(value) * (1.0 + spread) + std::abs(slope_a * a.value)) * f.exponent->condition;
  }
  // Far from the circle a and y are not as independent as that: their ends say more.
  const double radius = convergence_radius(f.function, a.value);
  if (y.value >= 0.25 * radius * radius) {
    using std::sqrt;
    const Conditioned root = sqrt(y);
    const Conditioned larger = a.value > 0.0 ? a + root : a - root;
    const Conditioned smaller = norm / larger;
    const Conditioned by_ends = a.value > 0.0 ? kernel_at_ends(f, part, larger, smaller, root)
                                              : kernel_at_ends(f, part, smaller, larger, root);
    condition = std::min(condition, by_ends.condition);
  }
  return {value, condition};
}

}  // namespace stationary::expression
