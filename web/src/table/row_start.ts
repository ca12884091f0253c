// A row as a case file that goes on from there or, where it is no place to start from, from one beside it on its sheet.

import type { CaseData } from './payload';
import { isLength, rowMotion } from './row_motion';
import type { Table } from './table';
import { caseOfRow, entry, quoted } from './toml';

export interface RowStart {
  /** The row that the case is of. */
  row: number;
  /** null: there is no case to go on from. */
  toml: string | null;
  /** Whether the row has an S to start at. */
  hasStart: boolean;
  /** A sentence on what is not as it should be; empty: nothing. */
  note: string;
}

/** Whether a two-polar motion is on the circle, where the program takes no start: its balance is singular there. */
function isRoundTwoPolar(table: Table, row: number): boolean {
  return rowMotion(table, row).branch === 'two-polar' && table.text('xi', row) !== '' && table.text('xi', row) === table.text('zeta', row);
}

/** S of a row in its exact texts, alpha first; null: the row has none to start at. */
function startOf(table: Table, row: number): string[] | null {
  if (isRoundTwoPolar(table, row)) return null;
  const start = ['alpha', 'xi', 'zeta', 'rho'].map((name) => table.text(name, row));
  return start.every((each) => each !== '') ? start : null;
}

/** The range of |nu| where an atlas has one of nu, of either sign; as it is where that is of another number. */
function lengths(range: CaseData): CaseData {
  const [from, to] = [range['from'], range['to']];
  if ((range['parameter'] ?? 'nu') !== 'nu' || typeof from !== 'number' || typeof to !== 'number') return {};
  const sizes = [Math.abs(from), Math.abs(to)];
  return { from: from <= 0 && to >= 0 ? 0 : Math.min(...sizes), to: Math.max(...sizes) };
}

/** What the metadata say of the case, with the row's numbers, as much of its motion as is known, and its S as the start.
 * bare: without a start and a range. */
export function rowAsToml(table: Table, row: number, bare = false): string {
  const { given, left } = caseOfRow(table, row);
  const lines = [`# row ${row + 1} of ${table.file.replace(/[\u0000-\u001f\u007f]/g, '?')}`];
  for (const key of left) lines.push(`# with ${key} = ${table.text(key, row)}`);
  if (typeof given['title'] === 'string') lines.push(`title = ${quoted(given['title'])}`);
  for (const part of ['body', 'potential', 'gravity']) {
    const section = given[part];
    if (typeof section !== 'object' || Array.isArray(section)) continue;
    lines.push('', `[${part}]`);
    for (const [key, value] of Object.entries(section)) lines.push(entry(key, value));
  }
  const motion = rowMotion(table, row, given);
  lines.push('', '[motion]', ...motion.entries.map(([key, value]) => `${key} = ${value}`));
  if (bare) return lines.join('\n') + '\n';
  const start = startOf(table, row);
  if (start) lines.push('', '[solve]', `start = [${start.join(', ')}]`);
  const range = given['continuation'];
  if (typeof range === 'object' && !Array.isArray(range)) {
    lines.push('', '[continuation]');
    const ofMotion = isLength(motion.branch) ? { ...range, ...lengths(range) } : range;
    for (const key of ['parameter', 'from', 'to']) if (Object.hasOwn(ofMotion, key)) lines.push(entry(key, ofMotion[key]));
  }
  return lines.join('\n') + '\n';
}

/** Why a row is no place to start from, as `continue --from` has it; empty: it is one. */
function obstacle(table: Table, row: number): string {
  const event = table.text('event', row);
  const { branch } = rowMotion(table, row);
  if (event === 'fold-nu' || event === 'fold-parameter') return 'This row is a fold';
  if (['ellipse', 'ellipse-23', 'ellipse-13', 'shear'].includes(event)) return 'Sheets meet at this row';
  if (event === 'escape' || event === 'collapse') return 'Stretches end at this row';
  if (isLength(branch) && (event === 'tilt' || event === 'oblique' || hasMaterialAxis(table, row))) return 'The axis has come to a material one at this row';
  return hasNoDirection(table, row) ? 'The axis has no direction at this row, where ν = 0' : '';
}

/** Whether all components of nu are told, and one of them alone is not 0. */
function hasMaterialAxis(table: Table, row: number): boolean {
  const nu = ['nu1', 'nu2', 'nu3'].map((name) => table.value(name, row));
  return nu.every(Number.isFinite) && nu.filter((each) => each !== 0).length === 1;
}

/** The program takes no such motion. */
function hasNoDirection(table: Table, row: number): boolean {
  const { branch, entries } = rowMotion(table, row);
  return isLength(branch) && entries.some(([key, value]) => key === 'nu' && !(Number(value) > 0));
}

function isStart(table: Table, row: number): boolean {
  return obstacle(table, row) === '' && startOf(table, row) !== null && rowMotion(table, row).unknown.length === 0;
}

/** The nearest row of the sheet to start from, those before it first; null: there is none. */
function beside(table: Table, row: number): number | null {
  // The cells of a map are no sheet, and every row of an event's curve is that event.
  if (table.kind !== 'curve') return null;
  const { first, end } = table.pieces[table.piece(row)];
  for (let apart = 1; row - apart >= first || row + apart < end; ++apart) {
    for (const other of [row - apart, row + apart]) if (other >= first && other < end && isStart(table, other)) return other;
  }
  return null;
}

export function rowStart(table: Table, row: number): RowStart {
  const { unknown } = rowMotion(table, row);
  if (unknown.length > 0) {
    const note = `Neither the table nor its case tells the motion of this row (${unknown.join(', ')}), so that there is no case to go on from.`;
    return { row, toml: null, hasStart: false, note };
  }
  const why = obstacle(table, row);
  if (why !== '') {
    const other = beside(table, row);
    if (other !== null) {
      const note = `${why}, so that solving need not come back to it: the case starts at row ${other + 1}, the nearest of its sheet to start from.`;
      return { row: other, toml: rowAsToml(table, other), hasStart: true, note };
    }
    if (hasNoDirection(table, row)) return { row, toml: null, hasStart: false, note: `${why}, so that there is no case to go on from.` };
  }
  const hasStart = startOf(table, row) !== null;
  const status = table.text('status', row);
  const note =
    why !== '' ? `${why}, so that solving need not come back to it, and no row of its sheet is a better start.`
    : !hasStart && status !== '' && status !== 'solved' ? `This cell has no motion to start from (${status}): the case has its numbers and no start.`
    : isRoundTwoPolar(table, row) ? 'The body is round at this row, where a two-polar motion has no start: the case has its numbers, and solving it may come to an ellipse.'
    : !hasStart ? 'The table does not hold S of this row: the case has its numbers and no start.'
    : table.metadata?.case ? ''
    : 'The table came without metadata: the body and the potential are missing in this case.';
  return { row, toml: rowAsToml(table, row), hasStart, note };
}
