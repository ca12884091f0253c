// One stationary ellipsoid as a row of the table: everything that follows from its equilibrium, and
// from its spectrum where that was computed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/material/material_coordinates.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/batch_spectrum/batch_spectrum.hpp"
#include "solver/kind/kind.hpp"
#include "solver/motion/family.hpp"
#include "solver/program/table/table.hpp"

namespace stationary {

/// What a table's rows carry beside the motion, its stretches and their errors.
struct RowParts {
  bool two_polar = false;
  bool events = false;
  bool spectrum = false;
  bool certificate = false;
  bool map = false;       ///< a map's cells, which have a status and no sheet
  bool pressure = false;  ///< of a held volume
};

/// The columns fill_row(), fill_spectrum(), prove_row() and the caller's sheet, point and
/// event make up, in order.
std::vector<Column> equilibrium_columns(const RowParts& parts);

/// Motion, stretch, principal stretches (no angle on the circle), momenta, energy and the errors
/// of a solved equilibrium; leaves the other columns as they are, and so those of principal
/// stretches, momenta and energy of which none is wanted. A two-polar motion is taken at the moment
/// theta = 0: S = diag(lambda, mu, rho), nu3 = omega + theta' (the paper's L^-1 L'), pi3 = s3.
void fill_row(std::string_view branch, const Body& body, const Potential& potential,
              const Equilibrium& equilibrium, const ColumnSet& wanted, TableRow& row);

/// Likewise of a member of a family, its parameter and its spectrum, whose columns are empty where it was not
/// computed.
void fill_row(std::string_view branch, const Member& member, const ColumnSet& wanted,
              TableRow& row);

/// The stretches of a filled row in other material coordinates.
void tell_in(const MaterialCoordinates& coordinates, const ColumnSet& wanted, TableRow& row);

/// nu along a branch's axis, |nu| of a tilted motion; NaN where its columns are.
double spin(std::string_view branch, const TableRow& row);

/// class ... krein5; modes that do not exist, or were not computed, stay empty, and so does a
/// signature that is not certain.
void fill_spectrum(const Spectrum& spectrum, TableRow& row);
void fill_spectrum(const CellSpectrum& spectrum, TableRow& row);

/// What the columns `certified` and `class_certified` say.
struct RowProof {
  bool proven = false;
  bool class_proven = false;
  bool assuming = false;  ///< what the certificate takes for granted
  std::string reason;     ///< why nothing is proven
};

/// Proves what the row says of the equilibrium: certified, with the proven error_bound where there
/// is one, and class_certified where there is a spectrum.
RowProof prove_row(const Kind& kind, const Equilibrium& equilibrium,
                   const std::optional<Spectrum>& spectrum, TableRow& row);

/// Proves that the event is there, by equations of its own: nothing where it has none. What the row
/// says of it: certified, with the proven error_bound where there is one, else the member's.
std::optional<EventEnclosure> prove_event(const Kind& kind, const FamilyParameter& parameter,
                                          EventType event, const Member& member, TableRow& row);

}  // namespace stationary
