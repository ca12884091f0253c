// The chosen row: every cell as it stands in the file, and the same as a case to go on from.

import { byId, element } from './dom';
import { meaning } from './table/quantities';
import { rowStart } from './table/row_start';
import type { Table } from './table/table';

async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false; // the browser does not allow it here; the text can be selected
  }
}

export function listenToCopying(say: (text: string) => void): void {
  for (const [button, source] of [['copy-toml', 'toml'], ['copy-command', 'command']]) {
    byId(button).addEventListener('click', () => {
      const from = byId(source);
      void copy(from.textContent ?? '').then((done) => {
        if (!done) getSelection()?.selectAllChildren(from);
        say(done ? 'Copied.' : 'Selected. Copy it with Ctrl+C.');
      });
    });
  }
}

export function showRow(table: Table, row: number | null): void {
  byId('row-part').hidden = row === null;
  if (row === null) return;
  byId('row-name').textContent = rowName(table, row);
  byId('cells').replaceChildren(
    ...table.names
      .filter((name) => table.text(name, row) !== '')
      .map((name) => {
        const { symbol, unit, text } = meaning(name);
        return element(
          'tr',
          { 'data-column': name },
          element('th', { scope: 'row', title: text }, symbol === name ? name : `${symbol}`, symbol === name ? null : element('small', {}, name)),
          element('td', { class: 'cell' }, table.text(name, row)),
          element('td', { class: 'unit' }, unit === '1' ? '' : unit),
        );
      }),
  );
  showStart(table, row);
}

function showStart(table: Table, row: number): void {
  const start = rowStart(table, row);
  byId('start-note').textContent = start.note;
  byId('start-note').hidden = start.note === '';
  byId('start-part').hidden = start.toml === null;
  byId('start-name').textContent = !start.hasStart ? 'A case with the numbers of this row' : start.row === row ? 'A case that starts at this row' : `A case that starts at row ${start.row + 1}`;
  byId('toml').textContent = start.toml ?? '';
  byId('command-part').hidden = !start.hasStart;
  byId('command').textContent = start.hasStart ? `stationary continue case.toml --from ${shellWord(table.file)}:${start.row + 1} -o next.csv` : '';
}

function shellWord(text: string): string {
  return /^[\w.+-]+$/.test(text) ? text : `'${text.replaceAll("'", `'\\''`)}'`;
}

/** "(iii), sheet 1, point 40: tilt". */
export function rowName(table: Table, row: number): string {
  const parts = [];
  const branch = table.text('branch', row);
  if (branch !== '') parts.push(/^i+$/.test(branch) ? `(${branch})` : branch);
  for (const name of ['sheet', 'curve', 'point']) if (table.text(name, row) !== '') parts.push(`${name} ${table.text(name, row)}`);
  if (parts.length === 0) parts.push(`row ${row + 1}`);
  const event = table.text('event', row);
  const special = table.text('special', row);
  return parts.join(', ') + (event === '' ? '' : `: ${event}`) + (special === '' ? '' : `, ${special}`);
}
