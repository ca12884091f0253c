// The located events as text: a list of buttons that go there, each with what it is, where, and on which sheet.

import { drawEvent, isEnd } from '../table/classes';
import { byId, element, styleValue } from '../dom';
import { spinSymbol } from './diagram';
import { withUnit } from '../table/quantities';
import type { Table } from '../table/table';

function sample(event: string): HTMLCanvasElement {
  const ratio = window.devicePixelRatio || 1;
  const out = element('canvas', { width: String(18 * ratio), height: String(18 * ratio), 'aria-hidden': 'true', class: 'event-mark' });
  const context = out.getContext('2d');
  if (context) {
    context.scale(ratio, ratio);
    drawEvent(context, event, 9, 9, styleValue('--ink'), styleValue('--paper'));
  }
  return out;
}

export function showEvents(table: Table, chosen: number | null, choose: (row: number) => void): void {
  const host = byId('events');
  const events = table.events();
  byId('no-events').hidden = events.length > 0;
  const key = table.parameter;
  const symbol = (key === 'spin' ? spinSymbol(table) : withUnit(key)).replace(/ \(.*/, '');
  host.replaceChildren(
    ...events.map((each) => {
      // Of a spin the exact text stands in the component's column.
      const text = each.row === null ? String(each.parameter) : textOf(table, each.row, each.parameter);
      // On the curve of an event both parameters are told.
      const others = table.kind === 'events' && each.row !== null ? table.parameters.filter((name) => name !== key).map((name) => `${withUnit(name).replace(/ \(.*/, '')} = ${table.text(name, each.row ?? 0)}`) : [];
      const where = [...others, `${symbol} = ${text}`].join(', ');
      const branch = each.row === null ? '' : table.text('branch', each.row);
      const sheet = each.sheet === '' ? '' : `${/^i+$/.test(branch) ? `(${branch})` : branch} ${table.kind === 'events' ? 'curve' : 'sheet'} ${each.sheet}`;
      const parts = [sample(each.event), element('b', {}, each.event), element('span', { class: 'where' }, where), element('span', { class: 'sheet' }, sheet)];
      if (each.note !== '') parts.push(element('span', { class: 'note' }, each.note));
      if (each.row === null) return element('li', { class: 'unlocated' }, ...parts);
      const row = each.row;
      const button = element('button', { type: 'button', 'data-row': String(row + 1), 'aria-pressed': String(row === chosen) }, ...parts);
      button.addEventListener('click', () => choose(row));
      return element('li', { class: isEnd(each.event) ? 'end' : '' }, button);
    }),
  );
}

/** Marks the chosen one, without making the list anew: focus stays where it is. */
export function markEvent(chosen: number | null): void {
  for (const button of byId('events').querySelectorAll('button'))
    button.setAttribute('aria-pressed', String(button.dataset['row'] === String((chosen ?? -1) + 1)));
}

function textOf(table: Table, row: number, parameter: number): string {
  if (table.parameter !== 'spin') return table.text(table.parameter, row);
  for (const name of ['nu1', 'nu2', 'nu3', 'omega']) if (table.value(name, row) === parameter) return table.text(name, row);
  return String(parameter);
}
