// The spectrum of a row in the complex plane. A Krein signature is a shape: +1 a disc, -1 a ring, 0 or none a cross.

import { axisBottom, axisLeft, type Axis } from 'd3-axis';
import { scaleLinear, type NumberValue } from 'd3-scale';
import { select } from 'd3-selection';
import { byId, element } from '../dom';
import { shown } from '../table/quantities';
import type { Table } from '../table/table';
import { linearTicks } from './ticks';

const size = { width: 300, height: 250, left: 54, right: 12, top: 10, bottom: 34 };

interface Root {
  re: number;
  im: number;
  krein: number | null;
  mode: number;
}

/** All of a pair or a quadruple. */
function roots(table: Table, row: number): Root[] {
  const out: Root[] = [];
  table.modes(row).forEach(({ re, im, krein }, k) => {
    for (const a of re === 0 ? [0] : [re, -re]) for (const b of im === 0 ? [0] : [im, -im]) out.push({ re: a, im: b, krein, mode: k + 1 });
  });
  return out;
}

function mark(krein: number | null): string {
  return krein === 1 ? 'plus' : krein === -1 ? 'minus' : 'none';
}

/** Which mode is animated. */
export function markMode(number: number | null): void {
  for (const button of byId('modes').querySelectorAll('button')) button.setAttribute('aria-pressed', String(button.dataset['mode'] === String(number)));
  select(byId<SVGSVGElement>('spectrum'))
    .selectAll<SVGPathElement, Root>('.root')
    .classed('chosen', (each) => each.mode === number);
}

function ticked(axis: Axis<NumberValue>, reach: number, count: number): Axis<NumberValue> {
  const { values, text } = linearTicks(-reach, reach, count, Infinity);
  return axis.tickValues(values).tickFormat((value) => text(Number(value))).tickSizeOuter(0);
}

/** choose: a mode is asked for, to be animated. */
export function showSpectrum(table: Table, row: number | null, choose: (mode: number) => void): void {
  const svg = select(byId<SVGSVGElement>('spectrum'));
  const found = row === null ? [] : roots(table, row);
  byId('spectrum-none').hidden = found.length > 0;
  byId('spectrum-part').hidden = found.length === 0;
  const largest = (part: 're' | 'im'): number => Math.max(...found.map((each) => Math.abs(each[part])), 0);
  const [im, re] = [largest('im') || largest('re') || 1, largest('re')];
  // A growth rate far below the frequencies is still seen to be one.
  const across = re > 0 ? 1.5 * re : 0.5 * im;
  const x = scaleLinear([-across, across], [size.left, size.width - size.right]);
  const y = scaleLinear([-1.12 * im, 1.12 * im], [size.height - size.bottom, size.top]);
  svg.select<SVGGElement>('.re-axis').attr('transform', `translate(0,${size.height - size.bottom})`).call(ticked(axisBottom(x), across, 4));
  svg.select<SVGGElement>('.im-axis').attr('transform', `translate(${size.left},0)`).call(ticked(axisLeft(y), 1.12 * im, 6));
  svg.select('.re-zero').attr('x1', x(0)).attr('x2', x(0)).attr('y1', size.top).attr('y2', size.height - size.bottom);
  svg.select('.im-zero').attr('y1', y(0)).attr('y2', y(0)).attr('x1', size.left).attr('x2', size.width - size.right);
  const marks = svg.select('.roots').selectAll<SVGPathElement, Root>('path').data(found);
  const cross = 'M-4,-4L4,4M-4,4L4,-4';
  const disc = 'M4.6,0A4.6,4.6,0,1,1,-4.6,0A4.6,4.6,0,1,1,4.6,0Z';
  marks
    .join('path')
    .attr('class', (each) => `root ${mark(each.krein)}${each.re > 0 ? ' growing' : ''}`)
    .attr('d', (each) => (mark(each.krein) === 'none' ? cross : disc))
    .attr('transform', (each) => `translate(${x(each.re)},${y(each.im)})`)
    .on('click', (_, each) => choose(each.mode));
  const body = byId('modes');
  body.replaceChildren(
    ...(row === null ? [] : table.modes(row)).map((mode, k) =>
      element(
        'tr',
        {},
        element('th', { scope: 'row' }, animating(k + 1, mode, choose)),
        element('td', {}, shown(mode.re)),
        element('td', {}, shown(mode.im)),
        element('td', {}, mode.krein === null ? 'not certain' : mode.krein > 0 ? '+1' : mode.krein < 0 ? '−1' : '0'),
      ),
    ),
  );
}

/** One that stands still, a symmetry's, has nothing to show. */
function animating(number: number, { re, im }: { re: number; im: number }, choose: (mode: number) => void): HTMLElement {
  const button = element('button', { type: 'button', 'data-mode': String(number), 'aria-pressed': 'false', 'aria-label': `Mode ${number}: animate` }, String(number));
  button.disabled = re === 0 && im === 0;
  button.addEventListener('click', () => choose(number));
  return button;
}
