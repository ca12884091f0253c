// The solver of pages outside of a browser, in node: what it writes of every shipped case, and of cases beside them, is to the byte
// what the program writes.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

const { STATIONARY_PROGRAM: program, STATIONARY_SOURCES: sources, STATIONARY_LIVE: live } = process.env;

/** As the page's worker (web/src/live_worker.ts): of the system there is a clock. */
function started() {
  const notThere = 52;
  let out = null;
  const view = () => new DataView(out.memory.buffer);
  const known = {
    clock_time_get: (_clock, _precision, at) => {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    environ_sizes_get: (count, size) => {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
  };
  const system = new Proxy({}, { get: (_, name) => known[String(name)] ?? (() => notThere) });
  const module = new WebAssembly.Module(readFileSync(live));
  out = new WebAssembly.Instance(module, { wasi_snapshot_preview1: system, page: { progress: () => {} } }).exports;
  out._initialize();
  return out;
}

const solver = started();

function inPage(request) {
  const bytes = new TextEncoder().encode(JSON.stringify(request));
  const room = solver.live_room(bytes.length);
  new Uint8Array(solver.memory.buffer, room, bytes.length).set(bytes);
  const at = solver.live_run();
  return JSON.parse(new TextDecoder().decode(new Uint8Array(solver.memory.buffer, at, solver.live_size()))).csv ?? '';
}

function byProgram(what, path, set) {
  const overrides = set.flatMap((each) => ['--set', each]);
  const { stdout } = spawnSync(program, [what, path, '-o', '-', '--quiet', '--threads', '1', ...overrides], { encoding: 'utf8', maxBuffer: 1 << 28 });
  return stdout;
}

/** The row and the columns where they differ, for messages. */
function difference(here, there) {
  const [a, b] = [here, there].map((text) => text.split('\n').map((line) => line.split(',')));
  if (a.length !== b.length) return `${a.length - 2} rows, not ${b.length - 2}`;
  const row = b.findIndex((cells, k) => cells.some((cell, j) => cell !== a[k][j]));
  return `row ${row}: ${b[row].flatMap((cell, j) => (cell === a[row][j] ? [] : [`${b[0][j]} ${a[row][j]}, not ${cell}`])).join('; ')}`;
}

/** How many tables were compared. A page certifies no rows. */
function compare(what, more) {
  let compared = 0;
  for (const file of readdirSync(join(sources, 'cases')).filter((name) => name.endsWith('.toml'))) {
    const path = join(sources, 'cases', file);
    const set = ['output.certificate=false', ...more];
    const there = byProgram(what, path, set);
    const here = inPage({ do: what, name: file, case: readFileSync(path, 'utf8'), set });
    if (there === '' && here === '') continue;
    if (here !== there) assert.fail(`${what} ${file} ${more}: ${here === '' || there === '' ? 'one of the two has no table' : difference(here, there)}`);
    ++compared;
  }
  return compared;
}

test('the shipped cases solved', () => assert.ok(compare('solve', []) >= 30));
test('the shipped cases followed', () => assert.ok(compare('continue', []) >= 30));
test('other bodies followed', () => {
  let compared = 0;
  for (const J3 of ['0.57', '0.83', '1.31']) compared += compare('continue', [`body.J.2=${J3}`]);
  assert.ok(compared >= 60, `${compared}`);
});
test('followed more coarsely and more finely', () => {
  for (const tolerance of ['1e-4', '1e-8']) assert.ok(compare('continue', [`continuation.tolerance=${tolerance}`]) >= 30);
});
