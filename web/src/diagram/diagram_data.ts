// The lines of a diagram: each piece cut where the class changes, neighbours sharing the point at the border. A located
// event belongs to both its sides, whatever its own class: on the border that is marginal. So does a row at rest, whose
// class is of another leaf. Between two such rows none has the class of the curve: it is that of the metadata's segments.

import type { State } from '../table/state';
import type { Table } from '../table/table';

export interface Line {
  piece: number;
  verdict: string;
  first: number;
  /** Included. */
  last: number;
}

function isBorder(table: Table, row: number): boolean {
  return table.mark(row) !== '' || (table.value('spin', row) === 0 && table.text('branch', row) !== 'two-polar');
}

export function classLines(table: Table): Line[] {
  const out: Line[] = [];
  const told = new Map((table.metadata?.segments ?? []).map((each) => [`${each.sheet}.${each.segment}`, each.class]));
  table.pieces.forEach((piece, k) => {
    if (piece.end - piece.first === 1) {
      out.push({ piece: k, verdict: table.text('class', piece.first), first: piece.first, last: piece.first });
      return;
    }
    for (let row = piece.first; row + 1 < piece.end; ++row) {
      const here = isBorder(table, row);
      const after = isBorder(table, row + 1);
      const own = table.text('class', row);
      const next = table.text('class', row + 1);
      const before = out.length > 0 && out[out.length - 1].piece === k ? out[out.length - 1].verdict : own;
      const between = told.get(`${table.text('sheet', row + 1)}.${table.text('segment', row + 1)}`) ?? (['', 'marginal'].includes(next) ? before : next);
      const verdict = !here ? own : !after ? next : between;
      const last = out[out.length - 1];
      if (last && last.piece === k && last.verdict === verdict && last.last === row) last.last = row + 1;
      else out.push({ piece: k, verdict, first: row, last: row + 1 });
    }
  });
  return out;
}

/** Whether a row is drawn as the page stands. */
export function isShown(table: Table, state: State, row: number): boolean {
  return !state.hidden.has(table.pieces[table.piece(row)].key) && !state.hiddenClasses.has(table.text('class', row));
}

export interface Range {
  low: number;
  high: number;
}

/** Beyond it, and below its inverse, differences that axes take cannot be represented. */
const largest = 1e250;

/** What the shown rows cover, of those taken, with a margin; of a logarithmic axis only what is positive. */
export function rangeOf(table: Table, state: State, names: readonly string[], logarithmic: boolean, takes: (row: number) => boolean): Range {
  let low = Infinity;
  let high = -Infinity;
  for (const name of names) {
    const column = table.column(name);
    for (let row = 0; row < table.rows; ++row) {
      const value = column[row];
      if (!(Math.abs(value) < largest) || (logarithmic && !(value > 1 / largest)) || state.hidden.has(table.pieces[table.piece(row)].key) || !takes(row)) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  if (low > high) return logarithmic ? { low: 0.1, high: 10 } : { low: 0, high: 1 };
  if (logarithmic) {
    const factor = Math.max(1.05, (high / low) ** 0.05);
    return { low: low / factor, high: high * factor };
  }
  const margin = high - low > 1 / largest ? 0.05 * (high - low) : Math.max(0.5 * Math.abs(high), 1e-3);
  return { low: low - margin, high: high + margin };
}

export type Point = readonly [number, number];

/** The part of a segment that lies in a box from low to high; null: none does. */
export function within(low: Point, high: Point, from: Point, to: Point): [Point, Point] | null {
  let [first, last] = [0, 1];
  for (const k of [0, 1] as const) {
    const step = to[k] - from[k];
    if (step === 0 && !(from[k] >= low[k] && from[k] <= high[k])) return null;
    if (step === 0) continue;
    const [enter, leave] = [low[k], high[k]].map((edge) => (edge - from[k]) / step).sort((a, b) => a - b);
    first = Math.max(first, enter);
    last = Math.min(last, leave);
  }
  if (first > last) return null;
  const at = (share: number): Point => [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
  return [first === 0 ? from : at(first), last === 1 ? to : at(last)];
}
