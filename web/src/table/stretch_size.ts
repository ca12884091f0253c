// What the error bound of a row, relative in each unknown, is a part of: the size that an error of a stretch is told by.

import type { Table } from './table';

const stretches = ['alpha', 'xi', 'zeta', 'rho', 'lambda', 'mu'];

/** NaN of what is no stretch, and where the row does not tell it. alpha's bound is relative to the root of xi zeta, and
 * where alpha is not 0 a principal stretch moves with all three: by the squares of its direction's components. */
export function stretchSize(table: Table, name: string, row: number): number {
  if (!stretches.includes(name)) return NaN;
  const value = (of: string): number => table.value(of, row);
  if (name === 'alpha') return Math.sqrt(value('xi') * value('zeta'));
  const alpha = table.has('alpha') ? value('alpha') : NaN;
  if ((name !== 'lambda' && name !== 'mu') || alpha === 0) return Math.abs(value(name));
  const [c, s] = [Math.abs(Math.cos(value('angle'))), Math.abs(Math.sin(value('angle')))];
  const [a, b] = name === 'lambda' ? [c, s] : [s, c];
  return (Math.sqrt(value('xi')) * a + Math.sqrt(value('zeta')) * b) ** 2;
}
