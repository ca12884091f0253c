// All motions with alpha != 0 of an isotropic body (sheared_balance.hpp) at one nu.
#pragma once

#include "solver/family/sheared_family.hpp"
#include "solver/search/search.hpp"

namespace stationary {

/// Those with alpha > 0: the others are mirror images. nu: |nu|, about axis 3 of either sign.
template <int N>
SearchResult search_sheared(const ShearedEquations<N>& equations, double nu,
                            const SearchOptions& options);

extern template SearchResult search_sheared<3>(const ShearedEquations<3>&, double,
                                               const SearchOptions&);
extern template SearchResult search_sheared<4>(const ShearedEquations<4>&, double,
                                               const SearchOptions&);

}  // namespace stationary
