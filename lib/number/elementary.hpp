// Elementary functions of a double, the same bits on every processor: from + - * / and sqrt, which
// are rounded everywhere alike, where C libraries differ in the last digit among themselves and, by
// whether the processor fuses a product and a sum, from one x86-64 to another.
//
// The part of an argument that a table or a multiple of pi/2 takes away is taken without an error:
// exp, log, pow and tanh are within 0.53 units in the last place of the exact
// value (exp within 0.8 where it is subnormal), atan within 0.75, sin and cos within 0.8, tan within 0.9, log1p within
// 1.3, asin and acos within 2.
// hypotenuse, cube_root and log10 (of a normal x below 2^1022) are rounded from extended precision. Special values are those of
// <cmath>, but sin, cos and tan have none beyond 2^30 (NaN).
//
// Their attributes say that they depend on their arguments alone, as the compiler knows of the C
// library's: a call twice made is made once, and what surrounds it is inlined as before.
//
// Of templates too: log(x) without std:: is this one for a double, and the number's own otherwise.
#pragma once

#include <cmath>
#include <complex>

namespace stationary {

[[gnu::const]] double exp(double x) noexcept;
[[gnu::const]] double log(double x) noexcept;
[[gnu::const]] double log1p(double x) noexcept;  ///< log(1 + x)
[[gnu::const]] double log10(double x) noexcept;
[[gnu::const]] double pow(double x, double p) noexcept;
[[gnu::const]] double sin(double x) noexcept;
[[gnu::const]] double cos(double x) noexcept;
[[gnu::const]] double tan(double x) noexcept;
[[gnu::const]] double tanh(double x) noexcept;
[[gnu::const]] double asin(double x) noexcept;
[[gnu::const]] double acos(double x) noexcept;
[[gnu::const]] double atan(double x) noexcept;
[[gnu::const]] double atan2(double y, double x) noexcept;
[[gnu::const]] double hypotenuse(double x, double y,
                                 double z = 0.0) noexcept;  ///< sqrt(x^2 + y^2 + z^2)
[[gnu::const]] double cube_root(double x) noexcept;

/// |z| within an ulp, z / w, and the square root with a real part that is not negative: those of
/// the standard library come from the C library and the compiler's run-time.
inline double modulus(const std::complex<double>& z) noexcept {
  const double square = z.real() * z.real() + z.imag() * z.imag();
  if (0x1p-900 < square && square < 0x1p1000) return std::sqrt(square);
  return hypotenuse(z.real(), z.imag());
}
inline double modulus(double x) { return x < 0.0 ? -x : x; }
[[gnu::pure]] std::complex<double> quotient(const std::complex<double>& z,
                                            const std::complex<double>& w) noexcept;
[[gnu::pure]] std::complex<double> square_root(const std::complex<double>& z) noexcept;
/// Of finite numbers, the bits of operator*, which asks of each product whether it is NaN.
inline std::complex<double> product(const std::complex<double>& z, const std::complex<double>& w) {
  return {z.real() * w.real() - z.imag() * w.imag(), z.real() * w.imag() + z.imag() * w.real()};
}
inline double product(double x, double y) { return x * y; }

}  // namespace stationary
