// Signatures in the odd block of (i), Lambda an eigenvalue of -P Q1 (linearization.hpp): the sign of x^T Q1 x,
//
//   Q1 x = m P^-1 x,  m = -Lambda > 0:   that of P or Q1 where one of them is definite,
//
// else one of each. Then adj(Q1 - m P^-1) = r x x^T, r of one sign at both m, and x^T P^-1 x = -f'(m)/r of
// f = det(Q1 - m P^-1): of the m nearer to zero the sign is that of -r.
#pragma once

namespace stationary {

/// P has a positive direction. Q1: sign of its diagonal, which is one where det_Q1 >= 0. middle: half-way between
/// the two Lambda; r(): the sign of r, of the diagonal of Q1 - m P^-1 there.
template <class R>
int odd_signature(double det_P, double det_Q1, int Q1, double lambda, double middle, const R& r) {
  if (det_P > 0.0) return 1;
  if (det_Q1 >= 0.0) return Q1;
  return lambda > middle ? -r() : r();
}

}  // namespace stationary
