// The motion of a row: its own cells, the columns that are varied, and for the rest what the metadata's case says.

import type { CaseData, CaseValue } from './payload';
import type { Table } from './table';
import { caseOfRow, get, number, quoted } from './toml';

export interface RowMotion {
  branch: string;
  /** Of [motion], each value as TOML has it. */
  entries: [string, string][];
  /** What the table does not tell of it. */
  unknown: string[];
}

const axes = ['i', 'ii', 'iii'];
const branches = [...axes, 'tilted', 'oblique', 'two-polar'];

/** Whether nu is the length of a vector, which must not vanish. */
export const isLength = (branch: string): boolean => branch === 'tilted' || branch === 'oblique';

/** Whether a key of the case is what a family was followed in, so that the case has it of no row. */
function isFollowed(table: Table, key: string): boolean {
  const { command, case: given } = table.metadata ?? {};
  if (command !== undefined && command !== 'continue' && command !== 'atlas') return false;
  return get(given ?? {}, 'continuation.parameter') === key;
}

/** A number of the motion, under the key that columns and ranges have for it; null: nothing tells it. */
function motionNumber(table: Table, row: number, key: string, cell: string, own: CaseData | null, given: CaseData): string | null {
  if (cell !== '') return cell;
  if (table.text(key, row) !== '') return table.text(key, row);
  const ratio = table.parameters.find((each) => each.startsWith(`${key}/`));
  if (ratio !== undefined) {
    const second = ratio.slice(key.length + 1);
    const unit = table.has(second) ? table.value(second, row) : get(given, second);
    const value = table.value(ratio, row) * (typeof unit === 'number' ? unit : NaN);
    return Number.isFinite(value) ? number(value) : null;
  }
  const kept = isFollowed(table, key) ? undefined : own?.[key === 'nu' ? 'nu' : key.slice('motion.'.length)];
  return typeof kept === 'number' ? number(kept) : null;
}

/** The case's plane where the sheet's axes lie in it, else the one that they show; null: no row shows one. */
function planeOf(table: Table, row: number, own: CaseValue | undefined): string | null {
  // The axis of a sheet's end may lie in both planes. A map's cells have no sheet in common.
  const { first, end } = table.kind === 'map' ? { first: row, end: row + 1 } : table.pieces[table.piece(row)];
  const leaves = (name: string): boolean => table.has(name) && table.column(name).subarray(first, end).some((each) => Math.abs(each) > 0);
  const [one, two] = [leaves('nu1'), leaves('nu2')];
  if (typeof own === 'string' && (!one || own.includes('1')) && (!two || own.includes('2'))) return own;
  return one && two ? '123' : one ? '13' : two ? '23' : null;
}

/** given: the metadata's case with the row's other numbers. */
export function rowMotion(table: Table, row: number, given = caseOfRow(table, row).given): RowMotion {
  const motion = given['motion'];
  const ofCase = typeof motion === 'object' && !Array.isArray(motion) ? motion : null;
  // An atlas has sheets of other branches than its case's.
  const told = table.text('branch', row) || (table.metadata?.command === 'atlas' ? '' : ofCase?.['branch']);
  const branch = branches.find((each) => each === told) ?? '';
  if (branch === '') return { branch, entries: [], unknown: ['branch'] };
  const own = ofCase?.['branch'] === branch ? ofCase : null;
  const out: RowMotion = { branch, entries: [['branch', quoted(branch)]], unknown: [] };
  const add = (name: string, key: string, cell: string): void => {
    const value = motionNumber(table, row, key, cell, own, given);
    if (value === null) out.unknown.push(name);
    else out.entries.push([name, value]);
  };
  if (branch === 'two-polar') {
    const byMomenta = own ? Object.hasOwn(own, 's3') : table.has('s3') && !table.has('omega');
    for (const name of byMomenta ? ['s3', 'p_theta'] : ['omega', 'theta_dot']) add(name, `motion.${name}`, table.text(name, row));
    return out;
  }
  const plane = branch === 'tilted' ? planeOf(table, row, own?.['plane']) : null;
  if (plane !== null) out.entries.push(['plane', quoted(plane)]);
  if (branch === 'oblique' && typeof own?.['axis'] === 'string') out.entries.push(['axis', quoted(own['axis'])]);
  const length = table.value('|nu|', row);
  if (isLength(branch)) add('nu', 'nu', Number.isFinite(length) ? number(length) : '');
  else add('nu', 'nu', table.text(`nu${axes.indexOf(branch) + 1}`, row));
  return out;
}
