// Of a complete atlas: of how many motions each class is, proven for every ν. A strip for each kind of motion, in which each
// motion is a band in its class's colour and hatching, and the intervals as a table.

import { scaleLinear } from 'd3-scale';
import { classStyle, classStyles } from '../table/classes';
import { byId, element, fitCanvas, styleValue } from '../dom';
import { hatching } from './heat_map';
import type { ProvenInterval } from '../table/payload';
import { shown } from '../table/quantities';
import type { Table } from '../table/table';

const band = 13;
const mark = 6;

/** The kind of motion that an interval tells of. */
const kindName = ({ branch, plane }: ProvenInterval): string => {
  if (plane !== undefined) return `${branch}, plane ${plane}`;
  return /^i+$/.test(branch) ? `branch (${branch})` : branch;
};
const ends = ({ from, to }: ProvenInterval): string => `${shown(Number(from.toPrecision(12)))} … ${shown(Number(to.toPrecision(12)))}`;

/** The classes of its motions, one entry each; null: not decided. */
function motions(interval: ProvenInterval): string[] | null {
  if (interval.status !== 'proven') return null;
  return classStyles.flatMap(({ name }) => Array.from({ length: interval.sheets?.[name] ?? 0 }, () => name));
}

function inWords(interval: ProvenInterval): string {
  const found = motions(interval);
  if (found === null) return [interval.reason ?? 'not decided', ...(interval.events ?? [])].join(': ');
  const counts = Object.entries(interval.sheets ?? {}).map(([name, count]) => `${count} ${name}`);
  return counts.length === 0 ? 'no motion' : counts.join(', ');
}

function draw(canvas: HTMLCanvasElement, intervals: readonly ProvenInterval[], low: number, high: number): void {
  const { width, height, ratio } = fitCanvas(canvas);
  const context = canvas.getContext('2d');
  if (!context) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  const x = scaleLinear([low, high], [0, width]);
  const floor = height - mark;
  for (const interval of intervals) {
    const [left, right] = [x(interval.from), x(interval.to)];
    motions(interval)?.forEach((name, k) => {
      const top = floor - (k + 1) * band;
      context.fillStyle = styleValue(classStyle(name).colour);
      context.fillRect(left, top, right - left, band - 1);
      const tile = hatching(name);
      const pattern = tile && context.createPattern(tile, 'repeat');
      if (!pattern) return;
      context.fillStyle = pattern;
      context.fillRect(left, top, right - left, band - 1);
    });
  }
  context.fillStyle = styleValue('--faint');
  context.fillRect(0, floor, width, 1);
  // What is left undecided is mostly far narrower than a pixel.
  context.fillStyle = styleValue('--ink');
  for (const interval of intervals)
    if (motions(interval) === null) context.fillRect(Math.min(Math.max(x(interval.from) - 0.5, 0), width - 1.5), floor, Math.max(x(interval.to) - x(interval.from), 1.5), mark);
}

let redraw: (() => void) | null = null;
let watching = false;

export function showProvenClasses(table: Table): void {
  const all = table.metadata?.classes ?? [];
  byId('proven-part').hidden = all.length === 0;
  byId('proven-beyond').hidden = all.every((each) => each.beyond === 'excluded');
  const [low, high] = [Math.min(...all.map((each) => each.from)), Math.max(...all.map((each) => each.to))];
  const kinds = [...new Set(all.map(kindName))];
  const strips = kinds.map((kind) => {
    const intervals = all.filter((each) => kindName(each) === kind);
    const most = Math.max(1, ...intervals.map((each) => motions(each)?.length ?? 0));
    const left = intervals.filter((each) => motions(each) === null);
    const length = left.reduce((sum, each) => sum + each.to - each.from, 0);
    const told = left.length === 0 ? 'for every ν' : `but for ${left.length} interval${left.length === 1 ? '' : 's'} of total length ${length.toPrecision(2)}`;
    const canvas = element('canvas', { class: 'proven-strip', role: 'img', 'aria-label': `${kind}: ${intervals.map((each) => `${inWords(each)} for ν in ${ends(each)}`).join('; ')}` });
    canvas.style.height = `${most * band + mark}px`;
    return { canvas, intervals, figure: element('figure', {}, element('figcaption', {}, element('b', {}, kind), ` proven for ν in ${shown(low)} … ${shown(high)} ${told}`), canvas) };
  });
  byId('proven-strips').replaceChildren(...strips.map((each) => each.figure), element('p', { class: 'ends', 'aria-hidden': 'true' }, element('span', {}, `ν = ${shown(low)}`), element('span', {}, shown(high))));
  const used = new Set(all.flatMap((each) => motions(each) ?? []));
  byId('proven-keys').replaceChildren(...classStyles.filter((style) => used.has(style.name)).map((style) => {
    const sample = element('canvas', { class: 'proven-sample', 'aria-hidden': 'true' });
    return element('span', { class: 'key', 'data-class': style.name }, sample, style.text);
  }));
  byId('proven').replaceChildren(
    ...all.map((each) => element('tr', { class: each.status }, element('th', { scope: 'row' }, kindName(each)), element('td', {}, String(each.from)), element('td', {}, String(each.to)), element('td', {}, inWords(each)))),
  );
  redraw = (): void => {
    for (const { canvas, intervals } of strips) draw(canvas, intervals, low, high);
    for (const key of byId('proven-keys').querySelectorAll<HTMLElement>('.key')) {
      const sample = key.querySelector('canvas');
      if (sample) draw(sample, [{ branch: '', from: 0, to: 1, status: 'proven', sheets: { [key.dataset['class'] ?? '']: 1 } }], 0, 1);
    }
  };
  redraw();
  if (watching) return;
  watching = true;
  new ResizeObserver(() => redraw?.()).observe(byId('proven-strips'));
}
