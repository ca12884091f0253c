// What the diagram draws, as numbers: the page's own sources, bundled for node. No browser.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';

const web = createRequire(join(process.env.STATIONARY_WEB, 'package.json'));
const sources = process.env.STATIONARY_SOURCES;

/** What modules of web/src/ export. */
async function modules(...paths) {
  const contents = paths.map((path) => `export * from ${JSON.stringify(join(sources, 'web/src', path))};`).join('\n');
  const { outputFiles } = await web('esbuild').build({ stdin: { contents, resolveDir: sources, loader: 'ts' }, bundle: true, format: 'esm', write: false });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);
}

const { apart, modeTracks, Table } = await modules('diagram/label_places.ts', 'diagram/mode_tracks.ts', 'table/table.ts');

/** A shipped table. No cell of it is quoted. */
function shipped(name) {
  const [header, ...lines] = readFileSync(join(sources, 'results', name), 'utf8').trimEnd().split('\n').map((line) => line.split(','));
  const texts = ['branch', 'event', 'class'];
  const columns = header.map((column, k) => ({ name: column, kind: texts.includes(column) ? 'text' : 'number', cells: lines.map((cells) => cells[k]) }));
  return new Table({ file: name, title: name, rows: lines.length, metadata: null, parameters: [], columns });
}

test('a frequency goes on as one curve from rest, where there is one mode less', () => {
  for (const name of ['disc.csv', 'fold.csv', 'double_well_atlas.csv']) {
    const table = shipped(name);
    const tracks = modeTracks(table);
    let rest = 0;
    for (let row = 0; row < table.rows; ++row) {
      const drawn = tracks.map((each) => each[row]).filter(Number.isFinite).sort((a, b) => a - b);
      assert.deepEqual(drawn, table.modes(row).map(({ im }) => im).sort((a, b) => a - b), `${name}, row ${row + 1}`);
      const goesOn = row + 1 < table.rows && table.piece(row) === table.piece(row + 1);
      if (table.value('spin', row) !== 0 || !goesOn) continue;
      ++rest;
      // By number the modes would be those beside: here each is the nearest.
      for (const track of tracks.filter((each) => Number.isFinite(each[row])))
        assert.ok(Math.abs(track[row + 1] - track[row]) < 0.1 * track[row] + 1e-12, `${name}, row ${row + 1}: ${track[row]} to ${track[row + 1]}`);
    }
    assert.ok(rest > 0, name);
  }
});

test('two modes of opposite signature cross', () => {
  const rows = 21;
  const at = (row) => [1 + 0.05 * row, 2 - 0.05 * row];
  const columns = ['im1', 'im2', 're1', 're2', 'krein1', 'krein2', 'nu1', 'nu2', 'nu3'].map((name) => ({ name, kind: 'number', cells: [] }));
  for (let row = 0; row < rows; ++row) {
    const modes = [[at(row)[0], 1], [at(row)[1], -1]].sort((a, b) => a[0] - b[0]);
    const cells = [modes[0][0], modes[1][0], 0, 0, modes[0][1], modes[1][1], 0.1 * (row + 1), 0, 0];
    columns.forEach((column, k) => column.cells.push(String(cells[k])));
  }
  columns.push({ name: 'branch', kind: 'text', cells: Array(rows).fill('i') });
  const tracks = modeTracks(new Table({ file: 'x.csv', title: '', rows, metadata: null, parameters: [], columns }));
  for (let row = 0; row < rows; ++row) assert.deepEqual([tracks[0][row], tracks[1][row]], at(row), `row ${row + 1}`);
});

test('labels that would cover each other keep their order and stay near', () => {
  const near = [1, 2, 2.5, 40];
  const places = apart([40, 2.5, 1, 2], 14);
  const sorted = [...places].sort((a, b) => a - b);
  for (let k = 1; k < sorted.length; ++k) assert.ok(sorted[k] - sorted[k - 1] >= 14 - 1e-9);
  assert.deepEqual([2, 3, 1, 0].map((k) => places[k]), sorted);
  const mean = (of) => of.reduce((a, b) => a + b, 0) / of.length;
  assert.ok(Math.abs(mean(places) - mean(near)) < 1e-9);
  assert.deepEqual(apart([5, 100], 14), [5, 100]);
});
