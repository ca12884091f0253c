#include "lib/tape/tape_run.hpp"

namespace stationary::expression {

template void compute_constants(const Coefficients&, const double*, double*);
template void compute_constants(const Coefficients&, const DoubleDouble*, DoubleDouble*);
template void compute_constants(const Coefficients&, const Interval*, Interval*);
template void compute_constants(const Coefficients&, const Conditioned*, Conditioned*);
template void compute_constants(const Coefficients&, const PerParameter*, PerParameter*);
template void compute_constants(const Coefficients&, const Dual<double, 5>*, Dual<double, 5>*);
template void compute_constants(const Coefficients&, const Dual<Interval, 4>*, Dual<Interval, 4>*);

template void run(const Program&, const double*, const double*, double*);
template void run(const Program&, const double*, const DoubleDouble*, DoubleDouble*);
template void run(const Program&, const double*, const Interval*, Interval*);
template void run(const Program&, const double*, const Conditioned*, Conditioned*);
template void run(const Program&, const double*, const PerParameter*, PerParameter*);
template void run(const Program&, const double*, const Dual<double, 5>*, Dual<double, 5>*);
template void run(const Program&, const double*, const Dual<Interval, 4>*, Dual<Interval, 4>*);
template void run(const Program&, const double*, const Dual<Interval, 3>*, Dual<Interval, 3>*);

}  // namespace stationary::expression
