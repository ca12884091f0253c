// What lines mean, and switches to hide classes, branches and sheets; of a map the scale of its colours.

import { classStyle, classStyles } from '../table/classes';
import { sheetColours } from './diagram';
import { classLines } from './diagram_data';
import { byId, element, styleValue } from '../dom';
import { hatching, HeatMap, rampColour, statuses } from './heat_map';
import { shown, withUnit } from '../table/quantities';
import type { State } from '../table/state';
import type { Table } from '../table/table';

function sampleCanvas(width: number, height: number, draw: (context: CanvasRenderingContext2D) => void): HTMLCanvasElement {
  const ratio = window.devicePixelRatio || 1;
  const out = element('canvas', { width: String(width * ratio), height: String(height * ratio), 'aria-hidden': 'true' });
  out.style.width = `${width}px`;
  out.style.height = `${height}px`;
  const context = out.getContext('2d');
  if (context) {
    context.scale(ratio, ratio);
    draw(context);
  }
  return out;
}

function lineSample(verdict: string, colour: string): HTMLCanvasElement {
  const style = classStyle(verdict);
  return sampleCanvas(44, 12, (context) => {
    context.strokeStyle = styleValue(colour);
    context.lineWidth = style.width;
    context.setLineDash([...style.dash]);
    context.beginPath();
    context.moveTo(1, 6);
    context.lineTo(43, 6);
    context.stroke();
  });
}

function fieldSample(colour: string, verdict = ''): HTMLCanvasElement {
  return sampleCanvas(30, 16, (context) => {
    context.fillStyle = styleValue(colour);
    context.fillRect(0, 0, 30, 16);
    const tile = hatching(verdict);
    if (!tile) return;
    context.fillStyle = context.createPattern(tile, 'repeat') ?? 'transparent';
    context.fillRect(0, 0, 30, 16);
  });
}

function toggle(name: string, on: boolean, sample: Node | null, text: string, title: string, changed: (on: boolean) => void): HTMLElement {
  const box = element('input', { type: 'checkbox', name });
  box.checked = on;
  box.addEventListener('change', () => changed(box.checked));
  return element('label', { class: 'toggle', title }, box, sample, text);
}

export function showLegend(table: Table, state: State, changed: () => void): void {
  const host = byId('legend');
  const focused = host.contains(document.activeElement) ? (document.activeElement as HTMLInputElement).name : null;
  host.replaceChildren();
  if (table.kind === 'map') showScale(host, table, state);
  else showToggles(host, table, state, changed);
  if (focused !== null) [...host.querySelectorAll('input')].find((each) => each.name === focused)?.focus();
}

function showScale(host: HTMLElement, table: Table, state: State): void {
  const quantity = state.y[0] ?? 'class';
  if (quantity === 'class') {
    const used = new Set<string>();
    for (let row = 0; row < table.rows; ++row) used.add(table.text('class', row));
    for (const style of classStyles.filter((each) => used.has(each.name) && each.name !== ''))
      host.append(element('span', { class: 'key' }, fieldSample(style.colour, style.name), style.text));
  } else if (quantity === 'status') {
    const used = new Set<string>();
    for (let row = 0; row < table.rows; ++row) used.add(table.text('status', row));
    for (const word of used) host.append(element('span', { class: 'key' }, fieldSample(statuses[word] ?? '--none'), word || 'no status'));
    return;
  } else {
    const { low, high, below, above } = HeatMap.range(table, quantity);
    const end = (beyond: boolean, sign: string, value: number): string => (beyond ? `${sign} ` : '') + shown(Number(value.toPrecision(4)));
    const bar = sampleCanvas(220, 14, (context) => {
      for (let k = 0; k < 220; ++k) {
        context.fillStyle = rampColour(k / 219);
        context.fillRect(k, 0, 1.5, 14);
      }
    });
    host.append(element('span', { class: 'key' }, `${withUnit(quantity)}: ${end(below, '≤', low)}`, bar, end(above, '≥', high)));
  }
  host.append(element('span', { class: 'key' }, fieldSample('--none'), 'no solution here, or nothing computed'));
}

function showToggles(host: HTMLElement, table: Table, state: State, changed: () => void): void {
  const used = new Set(classLines(table).map((line) => line.verdict));
  for (let row = 0; row < table.rows; ++row) used.add(table.text('class', row));
  const classes = classStyles.filter((each) => used.has(each.name) && (each.name !== '' || used.size === 1));
  const first = element('div', { class: 'keys', role: 'group', 'aria-label': 'Classes' });
  for (const style of classes) {
    const colour = state.colour === 'class' ? style.colour : '--ink';
    first.append(
      toggle(`class ${style.name}`, !state.hiddenClasses.has(style.name), lineSample(style.name, colour), style.name || 'no class', style.text, (on) => {
        if (on) state.hiddenClasses.delete(style.name);
        else state.hiddenClasses.add(style.name);
        changed();
      }),
    );
  }
  const keys = [...new Set(table.pieces.map((piece) => piece.key))];
  const second = element('div', { class: 'keys sheets', role: 'group', 'aria-label': 'Branches and sheets' });
  const branches = [...new Set(table.pieces.map((piece) => piece.branch))];
  for (const branch of branches) {
    const own = keys.filter((key) => table.pieces.some((piece) => piece.key === key && piece.branch === branch));
    const title = /^i+$/.test(branch) ? `branch (${branch})` : branch || 'rows';
    const set = (key: string, on: boolean): void => {
      if (on) state.hidden.delete(key);
      else state.hidden.add(key);
    };
    const group = element('span', { class: 'branch', role: 'group', 'aria-label': title });
    second.append(group);
    if (branches.length > 1 || own.length === 1) {
      group.append(
        toggle(`branch ${branch}`, own.some((key) => !state.hidden.has(key)), null, title, 'Show or hide the branch', (on) => {
          own.forEach((key) => set(key, on));
          changed();
        }),
      );
    }
    if (own.length < 2) continue;
    for (const key of own) {
      const at = table.pieces.findIndex((piece) => piece.key === key);
      const { sheet, first: row } = table.pieces[at];
      const piece = table.kind === 'events' ? `curve ${sheet}, ${table.text('event', row)}` : `sheet ${sheet}`;
      const sample = state.colour === 'sheet' ? lineSample('', sheetColours[at % sheetColours.length]) : null;
      group.append(
        toggle(`sheet ${key}`, !state.hidden.has(key), sample, piece, `${title}, ${piece}`, (on) => {
          set(key, on);
          changed();
        }),
      );
    }
  }
  host.append(first, second);
}
