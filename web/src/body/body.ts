// The body of a row: S, its principal axes, how it turns, and what is said of it in words.

import { norm, unit, type Matrix, type Vector } from './matrix';
import { shown } from '../table/quantities';
import { rowMotion } from '../table/row_motion';
import type { Table } from '../table/table';

export interface Body {
  S: Matrix;
  /** Directions of lambda, mu and rho in the body. */
  axes: readonly [Vector, Vector, Vector];
  stretches: Vector;
  nu: Vector;
  /** False: neither the row nor its case says how it spins, and nu is 0 here. */
  spinIsTold: boolean;
  momentum: Vector;
  /** In radians per time: of the shape in space about `axis`, and of the material through the shape about axis 3. */
  turning: number;
  flow: number;
  axis: Vector;
  /** Semi-axes of the undeformed body whose inertia is J, of geometric mean 1; null: J is not known. */
  reference: Vector | null;
}

/** nu, about a material axis from its own column or the case; null: it is not told. */
function spinOf(table: Table, row: number): Vector | null {
  const nu = ['nu1', 'nu2', 'nu3'].map((name) => table.value(name, row));
  if (nu.every(Number.isFinite)) return [nu[0], nu[1], nu[2]];
  const { branch, entries } = rowMotion(table, row);
  const axis = ['i', 'ii', 'iii'].indexOf(branch);
  if (axis >= 0) {
    const own = Number(entries.find(([key]) => key === 'nu')?.[1] ?? NaN);
    return Number.isFinite(own) ? [axis === 0 ? own : 0, axis === 1 ? own : 0, axis === 2 ? own : 0] : null;
  }
  const rates = table.value('omega', row) + table.value('theta_dot', row);
  return branch === 'two-polar' && Number.isFinite(rates) ? [0, 0, rates] : null;
}

/** Null where the row has no S: no solution, or columns left out. */
export function bodyOf(table: Table, row: number): Body | null {
  const [alpha, xi, zeta, rho] = ['alpha', 'xi', 'zeta', 'rho'].map((name) => table.value(name, row));
  let [lambda, mu] = ['lambda', 'mu'].map((name) => table.value(name, row));
  let angle = table.value('angle', row);
  let S: Matrix;
  // At (lambda, mu) turned by the angle; on the circle there is none.
  const turned = lambda > 0 && mu > 0 && table.has('angle');
  if (turned && !Number.isFinite(angle)) angle = 0;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const shear = Number.isFinite(alpha) ? alpha : turned && Math.abs(angle) !== Math.PI / 2 ? (lambda - mu) * c * s : 0;
  if ([xi, zeta, rho].every((each) => each > 0)) {
    S = [xi, shear, 0, shear, zeta, 0, 0, 0, rho];
    const half = (xi + zeta) / 2;
    const apart = Math.hypot((xi - zeta) / 2, shear);
    if (!(lambda > 0)) lambda = half + apart;
    if (!(mu > 0)) mu = half - apart;
    if (!Number.isFinite(angle)) angle = apart > 0 ? Math.atan2(2 * shear, xi - zeta) / 2 : 0;
  } else if (turned && rho > 0) {
    S = [lambda * c * c + mu * s * s, shear, 0, shear, lambda * s * s + mu * c * c, 0, 0, 0, rho];
  } else {
    return null;
  }
  const vector = (names: readonly string[]): Vector => {
    const v = names.map((name) => table.value(name, row));
    return v.every(Number.isFinite) ? [v[0], v[1], v[2]] : [0, 0, 0];
  };
  const spin = spinOf(table, row);
  const nu: Vector = spin ?? [0, 0, 0];
  const twoPolar = table.text('branch', row) === 'two-polar' && Number.isFinite(table.value('theta_dot', row));
  const J = table.inertia(row);
  const mean = J ? (J[0] * J[1] * J[2]) ** (1 / 6) : 1;
  return {
    S,
    axes: [[Math.cos(angle), Math.sin(angle), 0], [-Math.sin(angle), Math.cos(angle), 0], [0, 0, 1]],
    stretches: [lambda, mu, rho],
    nu,
    spinIsTold: spin !== null,
    momentum: vector(['pi1', 'pi2', 'pi3']),
    // nu is minus the usual angular velocity, as in the paper.
    turning: twoPolar ? -table.value('omega', row) : -norm(nu),
    flow: twoPolar ? -table.value('theta_dot', row) : 0,
    axis: twoPolar || norm(nu) === 0 ? [0, 0, 1] : unit(nu),
    reference: J ? [Math.sqrt(J[0]) / mean, Math.sqrt(J[1]) / mean, Math.sqrt(J[2]) / mean] : null,
  };
}

export function inWords(body: Body): string {
  const [lambda, mu, rho] = body.stretches.map(shown);
  const spin =
    !body.spinIsTold ? 'how it turns not told by the table'
    : body.turning === 0 && body.flow === 0 ? 'at rest'
    : body.turning === 0 ? `its shape at rest, the material turning through it, |ν| = ${shown(norm(body.nu))}`
    : `turning about the upright axis, |ν| = ${shown(norm(body.nu))}`;
  return `Ellipsoid with principal stretches λ = ${lambda}, μ = ${mu}, ϱ = ${rho}, ${spin}.`;
}
