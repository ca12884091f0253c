// The stationary ellipsoid of a case at its nu, or every one of them, or the two-polar motion at its
// rates or momenta, and the spectrum there; with proofs if the case asks for them.
#pragma once

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"

namespace stationary::cli {

/// target: null for no table. Throws InputError before anything is computed.
Outcome solve_case(const Case& input, TableTarget* target, const Run& run);

}  // namespace stationary::cli
