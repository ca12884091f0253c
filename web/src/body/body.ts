// The body of a row: S, its principal axes, how it turns, and what is said of it in words.

import { diagonal, norm, unit, type Matrix, type Vector } from './matrix';
import { shown } from '../table/quantities';
import type { Table } from '../table/table';

export interface Body {
  S: Matrix;
  /** Directions of lambda, mu and rho in the body. */
  axes: readonly [Vector, Vector, Vector];
  stretches: Vector;
  nu: Vector;
  momentum: Vector;
  /** In radians per time: of the shape in space about `axis`, and of the material through the shape about axis 3. */
  turning: number;
  flow: number;
  axis: Vector;
  /** Semi-axes of the undeformed body whose inertia is J, of geometric mean 1; null: J is not known. */
  reference: Vector | null;
}

/** Null where the row has no S: no solution, or columns left out. */
export function bodyOf(table: Table, row: number): Body | null {
  const [alpha, xi, zeta, rho] = ['alpha', 'xi', 'zeta', 'rho'].map((name) => table.value(name, row));
  let [lambda, mu] = ['lambda', 'mu'].map((name) => table.value(name, row));
  let angle = table.value('angle', row);
  let S: Matrix;
  const shear = Number.isFinite(alpha) ? alpha : 0;
  if ([xi, zeta, rho].every((each) => each > 0)) {
    S = [xi, shear, 0, shear, zeta, 0, 0, 0, rho];
    const half = (xi + zeta) / 2;
    const apart = Math.hypot((xi - zeta) / 2, shear);
    if (!(lambda > 0)) lambda = half + apart;
    if (!(mu > 0)) mu = half - apart;
    if (!Number.isFinite(angle)) angle = apart > 0 ? Math.atan2(2 * shear, xi - zeta) / 2 : 0;
  } else if ([lambda, mu, rho].every((each) => each > 0)) {
    S = diagonal(lambda, mu, rho);
    angle = 0;
  } else {
    return null;
  }
  const vector = (names: readonly string[]): Vector => {
    const v = names.map((name) => table.value(name, row));
    return v.every(Number.isFinite) ? [v[0], v[1], v[2]] : [0, 0, 0];
  };
  const nu = vector(['nu1', 'nu2', 'nu3']);
  const twoPolar = table.text('branch', row) === 'two-polar' && Number.isFinite(table.value('theta_dot', row));
  const J = table.inertia(row);
  const mean = J ? (J[0] * J[1] * J[2]) ** (1 / 6) : 1;
  return {
    S,
    axes: [[Math.cos(angle), Math.sin(angle), 0], [-Math.sin(angle), Math.cos(angle), 0], [0, 0, 1]],
    stretches: [lambda, mu, rho],
    nu,
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
  const spin = body.turning === 0 && body.flow === 0 ? 'at rest' : `turning about the upright axis, |ν| = ${shown(norm(body.nu))}`;
  return `Ellipsoid with principal stretches λ = ${lambda}, μ = ${mu}, ϱ = ${rho}, ${spin}.`;
}
