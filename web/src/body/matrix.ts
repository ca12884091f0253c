// Vectors and 3 by 3 matrices (row by row) of the body's view.

export type Vector = readonly [number, number, number];
export type Matrix = readonly [number, number, number, number, number, number, number, number, number];

export const identity: Matrix = [1, 0, 0, 0, 1, 0, 0, 0, 1];
export const diagonal = (a: number, b: number, c: number): Matrix => [a, 0, 0, 0, b, 0, 0, 0, c];
export const norm = (v: Vector): number => Math.hypot(...v);
export const scaled = (v: Vector, by: number): Vector => [v[0] * by, v[1] * by, v[2] * by];
export const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export function unit(v: Vector): Vector {
  const size = norm(v);
  return size > 0 ? scaled(v, 1 / size) : [0, 0, 1];
}

export const sum = (a: Matrix, b: Matrix): Matrix => a.map((each, k) => each + b[k]) as unknown as Matrix;

export function product(a: Matrix, b: Matrix): Matrix {
  const out = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  for (let i = 0; i < 3; ++i) for (let j = 0; j < 3; ++j) for (let k = 0; k < 3; ++k) out[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  return out as unknown as Matrix;
}

export function applied(m: Matrix, v: Vector): Vector {
  return [m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2], m[6] * v[0] + m[7] * v[1] + m[8] * v[2]];
}

export const transposed = (m: Matrix): Matrix => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];

/** Of rows. */
export const rows = (a: Vector, b: Vector, c: Vector): Matrix => [...a, ...b, ...c];

export function inverse(m: Matrix): Matrix {
  const [a, b, c]: Vector[] = [[m[0], m[1], m[2]], [m[3], m[4], m[5]], [m[6], m[7], m[8]]];
  const bc = cross(b, c);
  const determinant = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
  return transposed(rows(scaled(bc, 1 / determinant), scaled(cross(c, a), 1 / determinant), scaled(cross(a, b), 1 / determinant)));
}

/** About axis 3, in the usual sense. */
export function aboutThird(angle: number): Matrix {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c, -s, 0, s, c, 0, 0, 0, 1];
}

/** A rotation that takes the direction to axis 3. */
export function upright(direction: Vector): Matrix {
  const third = unit(direction);
  const beside: Vector = Math.abs(third[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const second = unit(cross(third, beside));
  return rows(cross(second, third), second, third);
}
