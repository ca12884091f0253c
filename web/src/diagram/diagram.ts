// The diagram: curves on a canvas, axes and zoom by d3, the keys, and what the pointer is at.

import { axisBottom, axisLeft, type Axis } from 'd3-axis';
import { scaleLinear, scaleLog, type NumberValue, type ScaleContinuousNumeric } from 'd3-scale';
import { select } from 'd3-selection';
import { zoom, zoomIdentity, type D3ZoomEvent } from 'd3-zoom';
import { classStyle, drawEvent, isEnd } from '../table/classes';
import { classLines, isShown, rangeOf, within, type Line, type Point } from './diagram_data';
import { byId, fitCanvas, styleValue } from '../dom';
import { HeatMap } from './heat_map';
import { apart } from './label_places';
import { meaning, withUnit } from '../table/quantities';
import { isZoom, narrowest, type State } from '../table/state';
import type { Table } from '../table/table';
import { frequencies, modeTracks } from './mode_tracks';
import { linearTicks } from './ticks';

type Scale = ScaleContinuousNumeric<number, number>;

const margin = { left: 76, right: 30, top: 34, bottom: 46 };
/** Of the pointer from a point, in pixels, at most. */
const reach = 40;
export const sheetColours = ['--sheet-1', '--sheet-2', '--sheet-3', '--sheet-4', '--sheet-5', '--sheet-6', '--sheet-7', '--sheet-8'];

export interface DiagramEvents {
  hovered(row: number | null, quantity: string, x: number, y: number): void;
  chosen(row: number): void;
  zoomed(): void;
  key(event: KeyboardEvent): void;
}

export class Diagram {
  private readonly host = byId('plot');
  private readonly canvas = byId<HTMLCanvasElement>('curves');
  private readonly xAxis = select<SVGGElement, unknown>('#axis-x');
  private readonly yAxis = select<SVGGElement, unknown>('#axis-y');
  private readonly behaviour = zoom<HTMLElement, unknown>();
  private readonly target;
  private table: Table | null = null;
  private state: State | null = null;
  private overlay: readonly Table[] = [];
  private lines: readonly Line[] = [];
  private heat: HeatMap | null = null;
  private tracks: readonly Float64Array[] | null = null;
  private base: { x: Scale; y: Scale } = { x: scaleLinear(), y: scaleLinear() };
  private x: Scale = scaleLinear();
  private y: Scale = scaleLinear();
  private hover: { row: number; quantity: string } | null = null;
  /** While the view is laid out anew. */
  private resetting = false;

  constructor(private readonly events: DiagramEvents) {
    this.target = select(this.host);
    this.behaviour.on('zoom', (event: D3ZoomEvent<HTMLElement, unknown>) => this.onZoom(event));
    this.target.call(this.behaviour);
    this.host.addEventListener('pointermove', (event) => this.onMove(event));
    this.host.addEventListener('pointerleave', () => this.setHover(null, 0, 0));
    this.host.addEventListener('click', (event) => this.onClick(event));
    this.host.addEventListener('keydown', (event) => this.events.key(event));
    new ResizeObserver(() => this.rescale()).observe(this.host);
  }

  /** Another table, other axes or other curves: all is drawn anew. overlay: curves of events on a map. */
  show(table: Table, state: State, overlay: readonly Table[]): void {
    if (table !== this.table) {
      this.lines = classLines(table);
      this.tracks = null;
      this.heat = table.kind === 'map' ? new HeatMap(table) : null;
    }
    this.table = table;
    this.state = state;
    this.overlay = overlay;
    this.hover = null;
    this.events.hovered(null, '', 0, 0);
    this.rescale();
  }

  zoomBy(factor: number): void {
    this.behaviour.scaleBy(this.target, factor);
  }

  /** The names that the vertical axis measures. */
  private ordinates(): readonly string[] {
    if (!this.table || !this.state) return [];
    return this.table.kind === 'map' ? [this.table.parameters[1]] : this.state.y;
  }

  private rescale(): void {
    const { table, state } = this;
    if (!table || !state) return;
    const { width, height } = fitCanvas(this.canvas);
    const logX = this.heat?.x.logarithmic ?? false;
    const most = shownMomenta(table, state);
    const takes = (row: number): boolean => !(table.value(state.x, row) > most);
    const logY = this.heat ? this.heat.y.logarithmic : state.logarithmic;
    const rx = this.heat ? this.heat.x : rangeOf(table, state, [state.x], false, takes);
    const ry = this.heat ? this.heat.y : rangeOf(table, state, this.ordinates(), logY, takes);
    const [x0, x1, y0, y1] = state.zoom ?? [rx.low, rx.high, ry.low, ry.high];
    const make = (log: boolean): Scale => (log ? scaleLog() : scaleLinear());
    this.base = {
      x: make(logX && x0 > 0).domain([x0, x1]).range([margin.left, width - margin.right]),
      y: make(logY && y0 > 0).domain([y0, y1]).range([height - margin.bottom, margin.top]),
    };
    this.x = this.base.x;
    this.y = this.base.y;
    const closest = (low: number, high: number): number => (high - low) / (narrowest * Math.max(Math.abs(low), Math.abs(high)));
    this.behaviour.scaleExtent([most < Infinity ? 1e-7 : 0.2, Math.max(1, Math.min(1e7, closest(x0, x1), closest(y0, y1)))]);
    this.resetting = true;
    this.behaviour.transform(this.target, zoomIdentity);
    this.resetting = false;
    this.draw();
  }

  private onZoom(event: D3ZoomEvent<HTMLElement, unknown>): void {
    if (!this.state || this.resetting) return;
    const x = event.transform.rescaleX(this.base.x as never) as Scale;
    const y = event.transform.rescaleY(this.base.y as never) as Scale;
    const [x0, x1] = x.domain();
    const [y0, y1] = y.domain();
    if (!isZoom([x0, x1, y0, y1])) return;
    this.x = x;
    this.y = y;
    this.state.zoom = [x0, x1, y0, y1];
    this.events.zoomed();
    this.draw();
  }

  private colour(piece: number, quantity: number, verdict: string): string {
    if (this.state?.colour === 'sheet') return styleValue(sheetColours[piece % sheetColours.length]);
    if (this.state?.colour === 'quantity') return styleValue(sheetColours[quantity % sheetColours.length]);
    return styleValue(classStyle(verdict).colour);
  }

  draw(): void {
    const { table, state } = this;
    const context = this.canvas.getContext('2d');
    if (!table || !state || !context) return;
    const { width, height, ratio } = fitCanvas(this.canvas);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.save();
    context.beginPath();
    context.rect(margin.left, margin.top, width - margin.left - margin.right, height - margin.top - margin.bottom);
    context.clip();
    if (this.heat) {
      this.heat.draw(context, state, this.x, this.y);
      for (const curves of this.overlay) this.drawOverlay(context, curves);
    } else {
      this.drawCurves(context, table, state);
    }
    context.restore();
    if (!this.heat) {
      this.drawMarks(context, table, state);
      this.nameCurves(context, table, state, width);
      if (table.kind === 'events') this.nameEvents(context, table, table.column(state.x), table.column(state.y[0]));
    }
    this.drawChosen(context, table, state, width, height);
    this.drawAxes(width, height);
  }

  /** What the line of a quantity goes through: where all frequencies are shown, those of one mode. */
  private drawn(table: Table, state: State, name: string): Float64Array {
    const mode = frequencies.indexOf(name as (typeof frequencies)[number]);
    const all = frequencies.filter((each) => table.has(each));
    if (mode < 0 || !all.every((each) => state.y.includes(each))) return table.column(name);
    this.tracks ??= modeTracks(table);
    return this.tracks[mode];
  }

  private drawCurves(context: CanvasRenderingContext2D, table: Table, state: State): void {
    const xs = table.column(state.x);
    // Dashes of what a zoom leaves out take seconds: lines are cut a little beyond the diagram's edge.
    const { width, height } = fitCanvas(this.canvas);
    const [low, high]: Point[] = [[-50, -50], [width + 50, height + 50]];
    state.y.forEach((name, q) => {
      const ys = this.drawn(table, state, name);
      for (const line of this.lines) {
        if (state.hidden.has(table.pieces[line.piece].key) || state.hiddenClasses.has(line.verdict)) continue;
        const style = classStyle(line.verdict);
        context.strokeStyle = this.colour(line.piece, q, line.verdict);
        context.lineWidth = style.width;
        context.setLineDash([...style.dash]);
        context.lineJoin = 'round';
        context.beginPath();
        let before: Point | null = null;
        let pen: Point | null = null;
        for (let row = line.first; row <= line.last; ++row) {
          const at: Point = [this.x(xs[row]), this.y(ys[row])];
          if (at.every(Number.isFinite)) {
            const part: [Point, Point] | null = before && within(low, high, before, at);
            if (part) {
              if (part[0] !== pen) context.moveTo(...part[0]);
              context.lineTo(...part[1]);
              pen = part[1];
            }
            before = at;
          } else if (table.mark(row) === '') {
            before = null; // an event's row without the value is passed over
          }
        }
        context.stroke();
        if (line.first === line.last) {
          context.setLineDash([]);
          context.fillStyle = context.strokeStyle;
          context.beginPath();
          context.arc(this.x(xs[line.first]), this.y(ys[line.first]), 3.5, 0, 2 * Math.PI);
          context.fill();
        }
      }
    });
  }

  /** Curves of events over the same two parameters. */
  private drawOverlay(context: CanvasRenderingContext2D, curves: Table): void {
    if (!this.table) return;
    const [xs, ys] = [curves.column(this.table.parameters[0]), curves.column(this.table.parameters[1])];
    context.strokeStyle = styleValue('--ink');
    context.lineWidth = 2;
    context.setLineDash([]);
    for (const piece of curves.pieces) {
      context.beginPath();
      for (let row = piece.first; row < piece.end; ++row) {
        if (row === piece.first) context.moveTo(this.x(xs[row]), this.y(ys[row]));
        else context.lineTo(this.x(xs[row]), this.y(ys[row]));
      }
      context.stroke();
    }
    this.nameEvents(context, curves, xs, ys);
  }

  /** Of curves of events, each at its middle. */
  private nameEvents(context: CanvasRenderingContext2D, curves: Table, xs: Float64Array, ys: Float64Array): void {
    for (const piece of curves.pieces) {
      const middle = Math.floor((piece.first + piece.end) / 2);
      this.write(context, curves.text('event', middle), this.x(xs[middle]), this.y(ys[middle]) - 10, 'center');
    }
  }

  private drawMarks(context: CanvasRenderingContext2D, table: Table, state: State): void {
    const { width, height } = fitCanvas(this.canvas);
    const [ink, paper] = [styleValue('--ink'), styleValue('--paper')];
    const labels: { name: string; x: number }[] = [];
    for (let row = 0; row < table.rows; ++row) {
      const event = table.mark(row);
      if (event === '' || state.hidden.has(table.pieces[table.piece(row)].key)) continue;
      const px = this.x(table.value(state.x, row));
      if (!(px >= margin.left && px <= width - margin.right)) continue;
      let seen = false;
      for (const name of state.y) {
        const py = this.y(table.value(name, row));
        if (!(py >= margin.top && py <= height - margin.bottom)) continue;
        drawEvent(context, event, px, py, ink, paper);
        seen = true;
      }
      if (seen && !isEnd(event)) labels.push({ name: event, x: px });
    }
    labels.sort((a, b) => a.x - b.x);
    let free = margin.left - 20;
    context.font = '12px system-ui, sans-serif';
    for (const { name, x } of labels) {
      const wide = context.measureText(name).width;
      const from = Math.min(Math.max(x - wide / 2, 4), width - wide - 4);
      if (from < free) continue;
      free = from + wide + 10;
      context.setLineDash([1, 3]);
      context.lineWidth = 1;
      context.strokeStyle = styleValue('--faint');
      context.beginPath();
      context.moveTo(x, margin.top - 8);
      context.lineTo(x, height - margin.bottom);
      context.stroke();
      this.write(context, name, from, margin.top - 14, 'left');
    }
  }

  private write(context: CanvasRenderingContext2D, text: string, x: number, y: number, align: CanvasTextAlign): void {
    context.font = '12px system-ui, sans-serif';
    context.textAlign = align;
    context.textBaseline = 'middle';
    context.setLineDash([]);
    context.lineWidth = 4;
    context.strokeStyle = styleValue('--paper');
    context.strokeText(text, x, y);
    context.fillStyle = styleValue('--ink');
    context.fillText(text, x, y);
  }

  /** Each curve's symbol where the curve is farthest right. */
  private nameCurves(context: CanvasRenderingContext2D, table: Table, state: State, width: number): void {
    if (state.y.length < 2) return;
    const labels: { name: string; x: number; y: number }[] = [];
    for (const name of state.y) {
      let best: { x: number; y: number } | null = null;
      for (let row = 0; row < table.rows; ++row) {
        if (!isShown(table, state, row)) continue;
        const [x, y] = [this.x(table.value(state.x, row)), this.y(table.value(name, row))];
        if (!(x >= margin.left && x <= width - margin.right) || !(y >= margin.top && y <= this.y.range()[0])) continue;
        if (!best || x > best.x) best = { x, y };
      }
      if (best) labels.push({ name, ...best });
    }
    context.font = 'italic 15px system-ui, sans-serif';
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    context.fillStyle = styleValue('--ink');
    // Those whose curves end beside each other.
    const wide = 40;
    labels.sort((a, b) => b.x - a.x);
    while (labels.length > 0) {
      const beside = labels.splice(0, labels.filter(({ x }) => labels[0].x - x < wide).length);
      const places = apart(beside.map(({ y }) => y), 14);
      beside.forEach(({ name, x }, k) => context.fillText(meaning(name).symbol, Math.min(x + 8, width - 28), places[k]));
    }
  }

  private drawChosen(context: CanvasRenderingContext2D, table: Table, state: State, width: number, height: number): void {
    const ring = (row: number, radius: number, colour: string, names: readonly string[]): void => {
      context.setLineDash([]);
      for (const name of names) {
        const [px, py] = [this.x(table.value(state.x, row)), this.y(table.value(name, row))];
        if (!(px >= margin.left - 1 && px <= width - margin.right + 1 && py >= margin.top - 1 && py <= height - margin.bottom + 1)) continue;
        context.beginPath();
        context.arc(px, py, radius, 0, 2 * Math.PI);
        context.lineWidth = 4;
        context.strokeStyle = styleValue('--paper');
        context.stroke();
        context.lineWidth = 2;
        context.strokeStyle = colour;
        context.stroke();
      }
    };
    if (state.row !== null) ring(state.row, 8, styleValue('--accent'), this.ordinates());
    if (this.hover) ring(this.hover.row, 6, styleValue('--ink'), [this.hover.quantity]);
  }

  private drawAxes(width: number, height: number): void {
    const ticksX = Math.max(3, Math.floor(width / 95));
    const ticksY = Math.max(3, Math.floor(height / 60));
    this.xAxis.attr('transform', `translate(0,${height - margin.bottom})`);
    const [axisX, axisY] = [ticked(axisBottom(this.x), this.x, ticksX, 6), ticked(axisLeft(this.y), this.y, ticksY, 4)];
    this.xAxis.call(axisX.axis.tickSizeInner(-(height - margin.bottom - margin.top)).tickSizeOuter(0).tickPadding(8));
    this.yAxis.attr('transform', `translate(${margin.left},0)`);
    this.yAxis.call(axisY.axis.tickSizeInner(-(width - margin.left - margin.right)).tickSizeOuter(0).tickPadding(8));
    const name = (name: string): string => (name === 'spin' && this.table ? spinSymbol(this.table) : withUnit(name));
    const measured = (text: string, { less }: { less: number }): string => (less === 0 ? text : `${text}, less ${String(less).replace('-', '−')}`);
    select('#name-x').attr('x', (margin.left + width - margin.right) / 2).attr('y', height - 8).text(measured(name(this.state?.x ?? ''), axisX));
    const ordinates = this.ordinates();
    const mid = (margin.top + height - margin.bottom) / 2;
    select('#name-y').attr('transform', `translate(12,${mid}) rotate(-90)`).text(measured(ordinateName(ordinates, name), axisY));
  }

  /** The nearest point of a curve, or the cell. */
  private nearest(px: number, py: number): { row: number; quantity: string } | null {
    const { table, state } = this;
    if (!table || !state) return null;
    if (this.heat) {
      const row = this.heat.rowAt(this.x.invert(px), this.y.invert(py));
      return row === null ? null : { row, quantity: table.parameters[1] };
    }
    let best: { row: number; quantity: string } | null = null;
    let least = reach * reach;
    const xs = table.column(state.x);
    for (const quantity of state.y) {
      const ys = table.column(quantity);
      for (let row = 0; row < table.rows; ++row) {
        const dx = this.x(xs[row]) - px;
        if (!(Math.abs(dx) < reach)) continue;
        const dy = this.y(ys[row]) - py;
        const distance = dx * dx + dy * dy;
        if (distance < least && isShown(table, state, row)) {
          least = distance;
          best = { row, quantity };
        }
      }
    }
    return best;
  }

  private at(event: MouseEvent): [number, number] {
    const box = this.host.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private onMove(event: PointerEvent): void {
    const [px, py] = this.at(event);
    this.setHover(event.buttons === 0 ? this.nearest(px, py) : null, px, py);
  }

  private setHover(hover: { row: number; quantity: string } | null, px: number, py: number): void {
    const moved = hover?.row !== this.hover?.row || hover?.quantity !== this.hover?.quantity;
    this.hover = hover;
    this.events.hovered(hover?.row ?? null, hover?.quantity ?? '', px, py);
    if (moved) this.draw();
  }

  private onClick(event: MouseEvent): void {
    const found = this.nearest(...this.at(event));
    if (found) this.events.chosen(found.row);
  }
}

/**
 * What a diagram against |π| shows at first, where a sheet that escapes would press all others into a corner: the
 * momenta of the events, and of half of the rows. Infinite: all.
 */
function shownMomenta(table: Table, state: State): number {
  const sizes = table.column('|pi|').filter((each) => each >= 0).sort();
  const most = sizes[sizes.length - 1];
  if (state.x !== '|pi|' || !(most > 0)) return Infinity;
  let out = sizes[sizes.length >> 1];
  for (let row = 0; row < table.rows; ++row) if (table.mark(row) !== '' && !isEnd(table.mark(row))) out = Math.max(out, 1.2 * table.value('|pi|', row));
  return out < 0.1 * most ? out : Infinity;
}

/** "λ, μ, ϱ"; "Im s (1/T)" of all modes. */
function ordinateName(names: readonly string[], name: (each: string) => string): string {
  if (names.length > 1 && names.every((each) => /^im[1-5]$/.test(each))) return 'Im s (1/T)';
  return names.map((each, k) => (k + 1 < names.length ? meaning(each).symbol : name(each))).join(', ');
}

const raised: Record<string, string> = { '-': '⁻', '0': '⁰', '1': '¹', '2': '²', '3': '³', '4': '⁴', '5': '⁵', '6': '⁶', '7': '⁷', '8': '⁸', '9': '⁹' };

/** Of a logarithmic axis over some decades the powers of ten, over fewer 1, 2, 5 of each; else as of a linear one. */
function ticked(axis: Axis<NumberValue>, scale: Scale, count: number, most: number): { axis: Axis<NumberValue>; less: number } {
  const [low, high] = scale.domain().map(Math.log10);
  if (!('base' in scale) || high - low < 0.7) {
    const [from, to] = scale.domain();
    const { values, text, less } = linearTicks(from, to, count, most);
    return { axis: axis.tickValues(values).tickFormat((value) => text(Number(value))), less };
  }
  if (high - low < 2.5) {
    const values = [];
    for (let k = Math.floor(low); k <= high; ++k) for (const each of [1, 2, 5]) if (each * 10 ** k >= 10 ** low && each * 10 ** k <= 10 ** high) values.push(each * 10 ** k);
    const text = (value: number): string => (value < 1e5 && value > 9e-5 ? String(Number(value.toPrecision(3))) : value.toExponential(0).replace('e+', 'e').replace('-', '−'));
    return { axis: axis.tickValues(values).tickFormat((value) => text(Number(value))), less: 0 };
  }
  const step = Math.max(1, Math.ceil((high - low) / count));
  const powers: number[] = [];
  for (let k = Math.ceil(low / step) * step; k <= high; k += step) powers.push(10 ** k);
  const text = (value: NumberValue): string => {
    const power = Math.round(Math.log10(Number(value)));
    return Math.abs(power) <= 2 ? String(Number(value)) : '10' + [...String(power)].map((each) => raised[each]).join('');
  };
  return { axis: axis.tickValues(powers).tickFormat(text), less: 0 };
}

/** nu1 of a table of (i), nu of one of several axes, omega of a two-polar one. */
export function spinSymbol(table: Table): string {
  const branches = new Set(table.pieces.map((piece) => piece.branch));
  const only = branches.size === 1 ? [...branches][0] : '';
  const name = { i: 'nu1', ii: 'nu2', iii: 'nu3', 'two-polar': 'omega' }[only] ?? 'nu';
  return branches.size > 1 && branches.has('two-polar') ? 'ν, ω (1/T)' : withUnit(name);
}
