// Frequencies along a piece as curves. The table orders the modes of a row by their size, and at rest there is one less:
// joined by their number they would be other curves. Along a curve a mode keeps its signature, and moves least.

import type { Table } from '../table/table';

const count = 5;
export const frequencies = ['im1', 'im2', 'im3', 'im4', 'im5'] as const;

interface Mode {
  frequency: number;
  krein: number;
}

/** Every choice of n of the numbers below m, each ascending. */
function choices(n: number, m: number): number[][] {
  if (n === 0) return [[]];
  const out: number[][] = [];
  for (let last = n - 1; last < m; ++last) for (const rest of choices(n - 1, last)) out.push([...rest, last]);
  return out;
}

/** Pairs as many as there can be of modes in ascending order, in order, so that together they move least. */
function nearestPairs(from: readonly number[], to: readonly number[], before: readonly Mode[], now: readonly Mode[]): [number, number][] {
  const swapped = from.length > to.length;
  const [few, many] = swapped ? [to, from] : [from, to];
  let best: [number, number][] = [];
  let least = Infinity;
  for (const chosen of choices(few.length, many.length)) {
    const pairs = few.map((each, k): [number, number] => (swapped ? [many[chosen[k]], each] : [each, many[chosen[k]]]));
    const moved = pairs.reduce((sum, [a, b]) => sum + Math.abs(before[a].frequency - now[b].frequency), 0);
    if (moved < least) [best, least] = [pairs, moved];
  }
  return best;
}

/**
 * Columns to draw in place of im1 … im5: in each one mode goes on from row to row; NaN where a row has no such mode. Tracks
 * that have no mode yet, or none in the row before, wait for one that no other takes.
 */
export function modeTracks(table: Table): Float64Array[] {
  const out = frequencies.map(() => new Float64Array(table.rows).fill(NaN));
  for (const piece of table.pieces) {
    const last: (Mode | null)[] = Array.from({ length: count }, () => null);
    for (let row = piece.first; row < piece.end; ++row) {
      const now: Mode[] = table.modes(row).map(({ im, krein }) => ({ frequency: im, krein: krein ?? 0 }));
      if (now.length === 0) continue; // an event's row without them
      const free = new Set(now.keys());
      const open = new Set(last.keys());
      const known = [...open].filter((track) => last[track] !== null).sort((a, b) => (last[a]?.frequency ?? 0) - (last[b]?.frequency ?? 0));
      const before = last.map((each) => each ?? { frequency: 0, krein: 0 });
      const take = (track: number, mode: number): void => {
        out[track][row] = now[mode].frequency;
        last[track] = now[mode].krein === 0 && now[mode].frequency > 0 ? { ...now[mode], krein: last[track]?.krein ?? 0 } : now[mode];
        open.delete(track);
        free.delete(mode);
      };
      const ascending = [...free].sort((a, b) => now[a].frequency - now[b].frequency);
      for (const sign of [1, -1, null]) {
        const takes = (mode: Mode): boolean => sign === null || mode.krein === sign;
        const from = known.filter((track) => open.has(track) && takes(before[track]));
        const to = ascending.filter((mode) => free.has(mode) && takes(now[mode]));
        for (const [track, mode] of nearestPairs(from, to, before, now)) take(track, mode);
      }
      const waiting = [...open];
      for (const mode of ascending.filter((each) => free.has(each))) take(waiting.shift() ?? 0, mode);
    }
  }
  return out;
}
