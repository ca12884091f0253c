// What the page shows, and the same as the address's fragment, so that a view can be sent. A fragment comes from outside:
// only what names something of these tables is taken from it.

import { isEnd } from './classes';
import type { Table } from './table';

export type ColourBy = 'class' | 'sheet' | 'quantity';
export const colourings: readonly ColourBy[] = ['class', 'sheet', 'quantity'];

export interface State {
  table: number;
  x: string;
  /** Drawn together; of a map one, its colour. */
  y: string[];
  row: number | null;
  hidden: Set<string>;
  hiddenClasses: Set<string>;
  colour: ColourBy;
  logarithmic: boolean;
  /** x0, x1, y0, y1; null: all. */
  zoom: [number, number, number, number] | null;
}

export interface Preset {
  id: string;
  label: string;
  x: string | null;
  y: readonly string[];
}

export const presets: readonly Preset[] = [
  { id: 'stretches', label: 'Stretches', x: null, y: ['lambda', 'mu', 'rho'] },
  { id: 'frequencies', label: 'Frequencies', x: null, y: ['im1', 'im2', 'im3', 'im4', 'im5'] },
  { id: 'growth', label: 'Growth', x: null, y: ['growth'] },
  { id: 'energy-momentum', label: 'Energy–momentum', x: '|pi|', y: ['energy'] },
];

export function available(table: Table, preset: Preset): boolean {
  return table.kind === 'curve' && preset.y.some((name) => table.quantities.includes(name)) && (preset.x === null || table.quantities.includes(preset.x));
}

/** Columns that a map shows by colour. */
export function mapQuantities(table: Table): string[] {
  const numbers = table.quantities.filter((name) => !table.parameters.includes(name) && name !== 'point' && name !== 'sheet');
  return [...(table.has('class') ? ['class'] : []), ...(table.has('status') ? ['status'] : []), ...numbers];
}

/** Logarithmic where stretches differ by more than a factor of 30. */
export function prefersLogarithm(table: Table, names: readonly string[]): boolean {
  if (table.kind !== 'curve' || !names.every((name) => ['lambda', 'mu', 'rho', 'xi', 'zeta'].includes(name))) return false;
  let [low, high] = [Infinity, 0];
  for (const name of names) {
    for (const value of table.column(name)) {
      if (!(value > 0)) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  return high > 30 * low;
}

export function firstState(tables: readonly Table[], index = 0): State {
  const table = tables[index];
  const out: State = {
    table: index,
    x: table.parameter,
    y: [],
    row: firstRow(table),
    hidden: new Set(),
    hiddenClasses: new Set(),
    colour: 'class',
    logarithmic: false,
    zoom: null,
  };
  if (table.kind === 'curve' && table.pieces.length === table.rows && table.parameters.length === 0 && table.has('mu')) {
    // Solutions at one spin: each a point of its own.
    out.x = 'lambda';
    out.y = ['mu'];
  } else if (table.kind === 'curve') {
    const preset = presets.find((each) => available(table, each));
    out.y = preset ? preset.y.filter((name) => table.quantities.includes(name)) : table.quantities.slice(1, 2);
  } else {
    out.x = table.parameters[0];
    out.y = table.kind === 'map' ? mapQuantities(table).slice(0, 1) : [table.parameters[1]];
  }
  out.logarithmic = prefersLogarithm(table, out.y);
  return out;
}

/** The first bifurcation that has a body and a spectrum, for there is most to see; else the middle of the first piece. */
function firstRow(table: Table): number | null {
  for (let row = 0; row < table.rows; ++row) {
    const event = table.mark(row);
    if (event !== '' && !isEnd(event) && table.value('xi', row) > 0 && table.modes(row).length > 0) return row;
  }
  if (table.pieces.length === 0) return null;
  const { first, end } = table.pieces[0];
  for (let k = 0; k < end - first; ++k) {
    const row = first + ((Math.floor((end - first) / 2) + k) % (end - first));
    if (Number.isFinite(table.value('xi', row))) return row;
  }
  return Math.floor((first + end) / 2);
}

/** Least width of what a zoom shows, of the size of its numbers, beyond which their last digits would show. */
export const narrowest = 1e-12;

/** Whether a zoom can be drawn: its numbers and the differences that axes take of them can be represented. */
export function isZoom(zoom: readonly number[]): boolean {
  if (zoom.length !== 4) return false;
  return [[zoom[0], zoom[1]], [zoom[2], zoom[3]]].every(([low, high]) => {
    const size = Math.max(Math.abs(low), Math.abs(high));
    const width = high - low;
    return size < 1e250 && width > 1e-250 && width >= narrowest * size;
  });
}

/** To a millionth of what an axis shows, or to the last digit. */
function zoomText([low, high]: readonly [number, number]): string {
  const digits = Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / (high - low))) + 7;
  return [low, high].map((each) => Number(each.toPrecision(Math.min(Math.max(digits, 7), 17)))).join();
}

/** The word of an address for rows without a class. */
const noClass = 'none';

export function toFragment(state: State, tables: readonly Table[]): string {
  const start = firstState(tables, state.table);
  const out = new URLSearchParams();
  if (state.table !== 0) out.set('table', String(state.table + 1));
  if (state.x !== start.x) out.set('x', state.x);
  if (state.y.join() !== start.y.join()) out.set('y', state.y.join());
  if (state.row !== null && state.row !== start.row) out.set('row', String(state.row + 1));
  if (state.hidden.size > 0) out.set('hide', [...state.hidden].join());
  if (state.hiddenClasses.size > 0) out.set('without', [...state.hiddenClasses].map((name) => name || noClass).join());
  if (state.colour !== 'class') out.set('colour', state.colour);
  if (state.logarithmic !== prefersLogarithm(tables[state.table], state.y)) out.set('log', state.logarithmic ? '1' : '0');
  if (state.zoom) out.set('zoom', `${zoomText([state.zoom[0], state.zoom[1]])},${zoomText([state.zoom[2], state.zoom[3]])}`);
  return out.toString();
}

export function fromFragment(fragment: string, tables: readonly Table[]): State {
  const given = new URLSearchParams(fragment.replace(/^#/, ''));
  const number = (name: string): number => Number(given.get(name) ?? NaN);
  const list = (name: string): string[] => (given.get(name) ?? '').split(',').filter((each) => each !== '');
  const index = given.has('table') ? number('table') - 1 : 0;
  // What was computed in a page is in no other.
  if (!Object.hasOwn(tables, index)) return firstState(tables);
  const state = firstState(tables, index);
  const table = tables[state.table];
  const x = given.get('x');
  if (table.kind === 'curve' && x !== null && table.quantities.includes(x)) state.x = x;
  const allowed = table.kind === 'map' ? mapQuantities(table) : table.quantities;
  const y = list('y').filter((name) => allowed.includes(name));
  if (y.length > 0 && table.kind !== 'events') state.y = table.kind === 'map' ? y.slice(0, 1) : y;
  const row = number('row') - 1;
  if (Number.isInteger(row) && row >= 0 && row < table.rows) state.row = row;
  const keys = new Set(table.pieces.map((piece) => piece.key));
  state.hidden = new Set(list('hide').filter((key) => keys.has(key)));
  const classes = ['stable', 'elliptic', 'unstable', 'oscillatory', 'marginal', ''];
  state.hiddenClasses = new Set(list('without').map((name) => (name === noClass ? '' : name)).filter((name) => classes.includes(name)));
  state.colour = colourings.find((each) => each === given.get('colour')) ?? 'class';
  state.logarithmic = given.has('log') ? given.get('log') === '1' : prefersLogarithm(table, state.y);
  const zoom = list('zoom').map(Number);
  if (isZoom(zoom)) state.zoom = [zoom[0], zoom[1], zoom[2], zoom[3]];
  return state;
}
