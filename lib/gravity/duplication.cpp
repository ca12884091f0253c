#include "lib/gravity/duplication.hpp"

#include "lib/gravity/self_energy.hpp"

namespace stationary {

#define STATIONARY_COMPILED(order, S) \
  template PowerSeries<S, order> integral_by_duplication<order>(const S&, const S&, const S&);
STATIONARY_DUPLICATIONS(STATIONARY_COMPILED)
#undef STATIONARY_COMPILED
STATIONARY_GRAVITY_BALANCES(template)

}  // namespace stationary
