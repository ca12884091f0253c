// One stationary ellipsoid as a row of the table: everything that follows from (q, nu) alone.
#pragma once

#include "solver/equilibrium.hpp"
#include "solver/table.hpp"

namespace stationary {

/// The columns fill_row() and the caller's branch, sheet and point make up, in order.
constexpr Column equilibrium_columns[] = {
    Column::branch, Column::sheet,  Column::point,    Column::nu1,           Column::nu2,
    Column::nu3,    Column::alpha,  Column::xi,       Column::zeta,          Column::rho,
    Column::lambda, Column::mu,     Column::angle,    Column::pi1,           Column::pi2,
    Column::pi3,    Column::energy, Column::residual, Column::compatibility, Column::error_bound};

/// Motion, stretch, principal stretches (no angle on the circle), momenta, energy and the errors
/// of a solved equilibrium; leaves the other columns as they are.
void fill_row(const Problem& problem, const Equilibrium& equilibrium, TableRow& row);

}  // namespace stationary
