#include "solver/program/rows/equilibrium_row.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "lib/balance/two_polar.hpp"
#include "lib/body/inertia.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

void fill_stretch(const Stretch& q, const ColumnSet& wanted, TableRow& row) {
  row[Column::alpha] = q.alpha;
  row[Column::xi] = q.xi;
  row[Column::zeta] = q.zeta;
  row[Column::rho] = q.rho;
  if (!wanted.has_any(Column::lambda, Column::angle)) return;
  const PrincipalStretches principal = principal_stretches(q);
  row[Column::lambda] = principal.lambda;
  row[Column::mu] = principal.mu;
  row[Column::angle] = principal.theta.value_or(std::numeric_limits<double>::quiet_NaN());
}

void fill_motion(const Vector3<double>& nu, TableRow& row) {
  row[Column::nu1] = nu[0];
  row[Column::nu2] = nu[1];
  row[Column::nu3] = nu[2];
}

void fill_momentum(const Vector3<double>& pi, TableRow& row) {
  row[Column::pi1] = pi[0];
  row[Column::pi2] = pi[1];
  row[Column::pi3] = pi[2];
}

/// pi = I nu.
void fill_rotation(const Body& body, const Stretch& q, const Vector3<double>& nu,
                   const ColumnSet& wanted, TableRow& row) {
  fill_motion(nu, row);
  if (wanted.has_any(Column::pi1, Column::pi3)) fill_momentum(locked_inertia(body, q) * nu, row);
}

/// At the moment theta = 0.
void fill_two_polar(const TwoPolarState& motion, TableRow& row) {
  fill_motion({0.0, 0.0, motion.rates.omega + motion.rates.theta_dot}, row);
  fill_momentum({0.0, 0.0, motion.momenta.s3}, row);
  row[Column::omega] = motion.rates.omega;
  row[Column::theta_dot] = motion.rates.theta_dot;
  row[Column::s3] = motion.momenta.s3;
  row[Column::p_theta] = motion.momenta.p_theta;
}

void fill_errors(const auto& solved, TableRow& row) {
  row[Column::residual] = solved.residual;
  row[Column::compatibility] = solved.compatibility;
  row[Column::error_bound] = solved.error_bound;
}

}  // namespace

std::vector<Column> equilibrium_columns(const RowParts& parts) {
  std::vector<Column> out;
  for (std::size_t k = 0; k < column_count; ++k) {
    const auto c = static_cast<Column>(k);
    if (((is_of_events(c) || c == Column::segment) && !parts.events) ||
        (needs_spectrum(c) && !parts.spectrum) || (is_two_polar(c) && !parts.two_polar) ||
        (is_certificate(c) && !parts.certificate) || (c == Column::status && !parts.map) ||
        (c == Column::sheet && parts.map) || (c == Column::pressure && !parts.pressure))
      continue;
    out.push_back(c);
  }
  return out;
}

void fill_row(std::string_view branch, const Body& body, const Potential& potential,
              const Equilibrium& equilibrium, const ColumnSet& wanted, TableRow& row) {
  const Stretch& q = equilibrium.q;
  const Vector3<double>& nu = equilibrium.nu;
  row.branch = branch;
  fill_stretch(q, wanted, row);
  fill_errors(equilibrium, row);
  if (wanted.has(Column::pressure)) row[Column::pressure] = pressure(body, potential, q, nu);
  if (const auto& two_polar = equilibrium.two_polar) {
    fill_two_polar(*two_polar, row);
    if (wanted.has(Column::energy))
      row[Column::energy] =
          two_polar_kinetic_energy(body.J1, diagonal(q), two_polar->rates) + potential.value(q);
    return;
  }
  fill_rotation(body, q, nu, wanted, row);
  if (wanted.has(Column::energy)) row[Column::energy] = energy(body, potential, q, nu);
}

namespace {

void empty_modes(int first, TableRow& row) {
  for (int k = first; k < mode_count; ++k)
    for (const ModePart part : {ModePart::re, ModePart::im, ModePart::krein})
      row[mode_column(k, part)] = std::numeric_limits<double>::quiet_NaN();
}

/// Of a row that had the spectrum of another member.
void empty_spectrum(TableRow& row) {
  row.stability = {};
  row[Column::growth] = row[Column::negative] = std::numeric_limits<double>::quiet_NaN();
  empty_modes(0, row);
}

}  // namespace

void fill_row(std::string_view branch, const Member& member, const ColumnSet& wanted,
              TableRow& row) {
  row.branch = branch;
  fill_stretch(member.q, wanted, row);
  if (member.two_polar) {
    fill_two_polar(*member.two_polar, row);
  } else {
    fill_rotation(member.body, member.q, member.angular_velocity, wanted, row);
  }
  row[Column::energy] = member.energy;
  row[Column::pressure] = member.pressure;
  fill_errors(member, row);
  row.parameter = member.parameter;
  if (member.spectrum) {
    fill_spectrum(*member.spectrum, row);
  } else {
    empty_spectrum(row);
  }
}

void tell_in(const MaterialCoordinates& coordinates, const ColumnSet& wanted, TableRow& row) {
  if (coordinates.are_own()) return;
  const Stretch q{row[Column::alpha], row[Column::xi], row[Column::zeta], row[Column::rho]};
  fill_stretch(coordinates.told(q), wanted, row);
  row[Column::error_bound] += 0x1p-51;  // the units' own rounding
}

double spin(std::string_view branch, const TableRow& row) {
  constexpr Column nu[] = {Column::nu1, Column::nu2, Column::nu3};
  if (const auto about = branch_from_name(branch)) return row[nu[axis(*about)]];
  return hypotenuse(row[nu[0]], row[nu[1]], row[nu[2]]);
}

namespace {

/// Of a Spectrum or a CellSpectrum.
void fill_from(const auto& spectrum, TableRow& row) {
  row.stability = name(spectrum.verdict);
  row[Column::growth] = spectrum.growth;
  row[Column::negative] = spectrum.negative;
  empty_modes(spectrum.modes, row);
  for (int k = 0; k < spectrum.modes; ++k) {
    const auto& mode = spectrum.mode[static_cast<std::size_t>(k)];
    row[mode_column(k, ModePart::re)] = mode.re;
    row[mode_column(k, ModePart::im)] = mode.im;
    row[mode_column(k, ModePart::krein)] =
        mode.krein_open ? std::numeric_limits<double>::quiet_NaN() : mode.krein;
  }
}

}  // namespace

void fill_spectrum(const Spectrum& spectrum, TableRow& row) { fill_from(spectrum, row); }
void fill_spectrum(const CellSpectrum& spectrum, TableRow& row) { fill_from(spectrum, row); }

RowProof prove_row(const Kind& kind, const Equilibrium& equilibrium,
                   const std::optional<Spectrum>& spectrum, TableRow& row) {
  const Certificate certificate = kind.certify(equilibrium);
  const bool assuming = !certificate.assuming.empty();
  RowProof out{certificate.proven, false, assuming, certificate.reason};
  if (out.proven) {
    row[Column::error_bound] = certificate.error_bound;
    out.class_proven =
        spectrum && kind.enclose(equilibrium, certificate, *spectrum).verdict == spectrum->verdict;
  }
  row.certified = proof_word(out.proven, assuming);
  row.class_certified = spectrum ? proof_word(out.class_proven, assuming) : std::string_view();
  return out;
}

std::optional<EventEnclosure> prove_event(const Kind& kind, const FamilyParameter& parameter,
                                          EventType event, const Member& member, TableRow& row) {
  std::optional<EventEnclosure> out = kind.enclose_event(parameter, event, member);
  if (!out) return out;
  row.certified = proof_word(out->proven, !out->assuming.empty());
  row[Column::error_bound] = out->proven ? out->error_bound : member.error_bound;
  return out;
}

}  // namespace stationary
