#include "lib/gravity/duplication.hpp"

namespace stationary {

#define STATIONARY_DUPLICATION(order, S) \
  template PowerSeries<S, order> integral_by_duplication<order>(const S&, const S&, const S&);
STATIONARY_DUPLICATION(1, double)
STATIONARY_DUPLICATION(2, double)
STATIONARY_DUPLICATION(3, double)
STATIONARY_DUPLICATION(0, DoubleDouble)
STATIONARY_DUPLICATION(1, DoubleDouble)
STATIONARY_DUPLICATION(2, DoubleDouble)
STATIONARY_DUPLICATION(1, Interval)
STATIONARY_DUPLICATION(2, Interval)
STATIONARY_DUPLICATION(3, Interval)
#undef STATIONARY_DUPLICATION

}  // namespace stationary
