// A map over two parameters: each cell a colour, of a number on a scale, of a class or a status by kind. Classes have a
// hatching of their own beside the colour.

import type { ScaleContinuousNumeric } from 'd3-scale';
import { classStyles } from '../table/classes';
import { styleValue } from '../dom';
import type { State } from '../table/state';
import type { Table } from '../table/table';

type Scale = ScaleContinuousNumeric<number, number>;

interface Axis {
  values: readonly number[];
  logarithmic: boolean;
  low: number;
  high: number;
}

/** Dark to light, even to the eye (viridis, at nine places). */
const ramp = ['#440154', '#472d7b', '#3b528b', '#2c728e', '#21918c', '#28ae80', '#5ec962', '#addc30', '#fde725'];
export const statuses: Record<string, string> = { solved: '--stable', 'none-exists': '--none', 'not-found': '--marginal', failed: '--unstable' };

function rgb(colour: string): [number, number, number] {
  const value = parseInt(colour.replace('#', ''), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

export function rampColour(share: number): string {
  const at = Math.min(Math.max(share, 0), 1) * (ramp.length - 1);
  const k = Math.min(Math.floor(at), ramp.length - 2);
  const [a, b] = [rgb(ramp[k]), rgb(ramp[k + 1])];
  return '#' + a.map((each, c) => Math.round(each + (b[c] - each) * (at - k)).toString(16).padStart(2, '0')).join('');
}

/** With the values between that an even grid has and these rows have not; as it is where that is no grid. */
function filled(sorted: number[]): number[] {
  const first = sorted[0];
  const gaps = sorted.slice(1).map((each, k) => each - sorted[k]);
  const step = Math.min(...gaps);
  const places = sorted.map((each) => (each - first) / step);
  const last = places[places.length - 1];
  const ratios = sorted.slice(1).map((each, k) => each / sorted[k]);
  const even = first > 0 && ratios.every((each) => Math.abs(each - ratios[0]) <= 1e-6 * ratios[0]);
  const isGrid = !even && sorted.length > 2 && last < 4 * sorted.length && places.every((each) => Math.abs(each - Math.round(each)) < 1e-6 * last);
  if (!isGrid || Math.round(last) === sorted.length - 1) return sorted;
  const known = new Map(places.map((each, k) => [Math.round(each), sorted[k]]));
  return Array.from({ length: Math.round(last) + 1 }, (_, k) => known.get(k) ?? first + k * step);
}

function axisOf(values: Float64Array): Axis {
  const sorted = filled([...new Set(values)].filter(Number.isFinite).sort((a, b) => a - b));
  const [first, last] = [sorted[0] ?? 0, sorted[sorted.length - 1] ?? 1];
  const n = Math.max(sorted.length - 1, 1);
  const step = (last - first) / n;
  const even = sorted.every((each, k) => Math.abs(each - first - k * step) <= 1e-6 * Math.abs(step));
  if (!even && first > 0) {
    const half = Math.sqrt((last / first) ** (1 / n));
    return { values: sorted, logarithmic: true, low: first / half, high: last * half };
  }
  const half = step > 0 ? step / 2 : 0.5;
  return { values: sorted, logarithmic: false, low: first - half, high: last + half };
}

function nearestPlace(axis: Axis, value: number): number | null {
  if (!(value >= axis.low && value <= axis.high)) return null;
  const size = axis.values.length;
  const share = axis.logarithmic ? Math.log(value / axis.low) / Math.log(axis.high / axis.low) : (value - axis.low) / (axis.high - axis.low);
  return Math.min(Math.floor(share * size), size - 1);
}

export class HeatMap {
  readonly x: Axis;
  readonly y: Axis;
  /** By place, x fastest; -1: no such row. */
  private readonly rows: Int32Array;
  private painted: { quantity: string; dark: string; image: HTMLCanvasElement; masks: readonly { kind: string; image: HTMLCanvasElement }[] } | null = null;

  constructor(private readonly table: Table) {
    const [px, py] = [table.column(table.parameters[0]), table.column(table.parameters[1])];
    this.x = axisOf(px);
    this.y = axisOf(py);
    const placeX = new Map(this.x.values.map((value, k) => [value, k]));
    const placeY = new Map(this.y.values.map((value, k) => [value, k]));
    this.rows = new Int32Array(this.x.values.length * this.y.values.length).fill(-1);
    for (let row = 0; row < table.rows; ++row) {
      const [i, j] = [placeX.get(px[row]), placeY.get(py[row])];
      if (i !== undefined && j !== undefined) this.rows[j * this.x.values.length + i] = row;
    }
  }

  rowAt(x: number, y: number): number | null {
    const [i, j] = [nearestPlace(this.x, x), nearestPlace(this.y, y)];
    if (i === null || j === null) return null;
    const row = this.rows[j * this.x.values.length + i];
    return row >= 0 ? row : null;
  }

  /** The row beside another, by steps of the grid. */
  beside(row: number, dx: number, dy: number): number {
    const width = this.x.values.length;
    const place = this.rows.indexOf(row);
    const i = (place % width) + dx;
    const j = Math.floor(place / width) + dy;
    if (i < 0 || j < 0 || i >= width || j >= this.y.values.length) return row;
    const found = this.rows[j * width + i];
    return found >= 0 ? found : row;
  }

  /** Of a number what its colours stand for, and whether cells lie beyond. */
  static range(table: Table, quantity: string): { low: number; high: number; below: boolean; above: boolean } {
    const finite = table.column(quantity).filter((each) => Number.isFinite(each)).sort();
    // A few cells beside an asymptote shall not take all of the scale.
    const at = (share: number): number => finite[Math.floor(share * (finite.length - 1))] ?? 0;
    const inner = [at(0.005), at(0.995)];
    const [low, high] = inner[0] < inner[1] ? inner : [at(0), at(1)];
    return { low, high, below: at(0) < low, above: at(1) > high };
  }

  draw(context: CanvasRenderingContext2D, state: State, x: Scale, y: Scale): void {
    const quantity = state.y[0] ?? 'class';
    const dark = styleValue('--paper');
    if (!this.painted || this.painted.quantity !== quantity || this.painted.dark !== dark) this.painted = this.paint(quantity, dark);
    const box = [x(this.x.low), y(this.y.high), x(this.x.high) - x(this.x.low), y(this.y.low) - y(this.y.high)] as const;
    context.imageSmoothingEnabled = false;
    context.drawImage(this.painted.image, ...box);
    for (const { kind, image } of this.painted.masks) {
      const hatch = hatching(kind);
      if (!hatch) continue;
      const layer = document.createElement('canvas');
      layer.width = context.canvas.width;
      layer.height = context.canvas.height;
      const on = layer.getContext('2d');
      if (!on) continue;
      on.setTransform(context.getTransform());
      on.imageSmoothingEnabled = false;
      on.drawImage(image, ...box);
      on.globalCompositeOperation = 'source-in';
      on.fillStyle = on.createPattern(hatch, 'repeat') ?? 'transparent';
      on.fillRect(0, 0, layer.width, layer.height);
      context.save();
      context.resetTransform();
      context.drawImage(layer, 0, 0);
      context.restore();
    }
  }

  private paint(quantity: string, dark: string): NonNullable<HeatMap['painted']> {
    const [width, height] = [this.x.values.length, this.y.values.length];
    const blank = (): { image: HTMLCanvasElement; data: ImageData } => {
      const image = document.createElement('canvas');
      image.width = width;
      image.height = height;
      return { image, data: new ImageData(width, height) };
    };
    const whole = blank();
    const masks = new Map<string, { image: HTMLCanvasElement; data: ImageData }>();
    const range = HeatMap.range(this.table, quantity);
    const byWord = quantity === 'class' || quantity === 'status';
    const none = rgb(styleValue('--none'));
    this.rows.forEach((row, place) => {
      // Pixels go down, the axis up.
      const pixel = 4 * ((height - 1 - Math.floor(place / width)) * width + (place % width));
      if (row < 0) return;
      let colour = none;
      if (byWord) {
        const word = this.table.text(quantity, row);
        const style = quantity === 'class' ? classStyles.find((each) => each.name === word && word !== '')?.colour : statuses[word];
        if (style) colour = rgb(styleValue(style));
        if (quantity === 'class' && word !== '') {
          const mask = masks.get(word) ?? blank();
          masks.set(word, mask);
          mask.data.data.set([0, 0, 0, 255], pixel);
        }
      } else {
        const value = this.table.value(quantity, row);
        if (Number.isFinite(value)) colour = rgb(rampColour(range.high > range.low ? (value - range.low) / (range.high - range.low) : 0.5));
      }
      whole.data.data.set([...colour, 255], pixel);
    });
    whole.image.getContext('2d')?.putImageData(whole.data, 0, 0);
    for (const mask of masks.values()) mask.image.getContext('2d')?.putImageData(mask.data, 0, 0);
    return { quantity, dark, image: whole.image, masks: [...masks].map(([kind, mask]) => ({ kind, image: mask.image })) };
  }
}

/** A tile of a class's hatching; none for stable. */
export function hatching(kind: string): HTMLCanvasElement | null {
  if (kind === 'stable') return null;
  const tile = document.createElement('canvas');
  tile.width = tile.height = 12;
  const on = tile.getContext('2d');
  if (!on) return null;
  on.strokeStyle = on.fillStyle = 'rgba(255, 255, 255, 0.42)';
  on.lineWidth = 1.4;
  const line = (x0: number, y0: number, x1: number, y1: number): void => {
    on.beginPath();
    on.moveTo(x0, y0);
    on.lineTo(x1, y1);
    on.stroke();
  };
  if (kind === 'elliptic') {
    on.beginPath();
    on.arc(6, 6, 1.3, 0, 2 * Math.PI);
    on.fill();
  }
  if (kind === 'unstable' || kind === 'oscillatory') {
    line(-3, 15, 15, -3);
    line(-9, 9, 9, -9);
    line(3, 21, 21, 3);
  }
  if (kind === 'oscillatory') line(-3, -3, 15, 15);
  if (kind === 'marginal') line(0, 6, 12, 6);
  return tile;
}
