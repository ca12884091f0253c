// Going on from a row: the case that the page makes of it, and what it says of rows that are no place to start from.
import assert from 'node:assert/strict';
import { readFileSync, rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { csv, makePage, open, result, run, shippedCase, start, stop, table, write } from './support.mjs';

before(start);
after(stop);

/** What the panel has of a row, counted from 1. */
async function panel(path, row) {
  const page = await open(makePage(path, '--no-live'), { fragment: `#row=${row}` });
  await page.evaluate(() => document.querySelectorAll('#row-part details').forEach((each) => (each.open = true)));
  const shown = async (id) => ((await page.isVisible(id)) ? page.textContent(id) : null);
  const out = { note: await shown('#start-note'), name: await shown('#start-name'), toml: await shown('#toml'), command: await shown('#command') };
  assert.deepEqual(page.complaints, []);
  await page.close();
  return out;
}

let solved = 0;
/** The one row that `solve` makes of a case. */
const solution = (toml) => csv(table(`solved${++solved}.csv`, 'solve', write(`solved${solved}.toml`, toml))).rows[0];

function assertSame(found, row, what) {
  for (const column of ['branch', 'alpha', 'xi', 'zeta', 'rho', 'nu1', 'nu2', 'nu3']) {
    if (row[column] === undefined) continue;
    if (column === 'branch') assert.equal(found.branch, row.branch, what);
    else assert.ok(Math.abs(Number(found[column]) - Number(row[column])) <= 1e-8 * Math.max(1, Math.abs(Number(row[column]))), `${what}: ${column} ${found[column]}, not ${row[column]}`);
  }
}

const readCase = (name) => readFileSync(shippedCase(name), 'utf8');
const columns = (...names) => ['--set', `output.columns=${JSON.stringify(names)}`];
const stretches = ['alpha', 'xi', 'zeta', 'rho'];

test('what no column tells of the motion comes from the case', async () => {
  const tables = [
    ['inertia', ['branch', ...stretches]],
    ['inertia', stretches],
    ['two_polar', ['branch', ...stretches]],
    ['two_polar', stretches],
    ['two_polar_momenta', stretches],
    ['oblique', ['nu1', 'nu2', 'nu3', ...stretches]],
    ['tilted', ['nu1', 'nu2', 'nu3', ...stretches]],
  ];
  for (const [name, kept] of tables) {
    const what = `${name} with ${kept}`;
    const whole = csv(table(`${name}_whole.csv`, 'continue', shippedCase(`${name}.toml`))).rows;
    const path = table(`${name}_${kept.length}.csv`, 'continue', shippedCase(`${name}.toml`), ...columns(...kept));
    const row = Math.floor(whole.length / 3);
    const { note, toml } = await panel(path, row + 1);
    assert.equal(note, null, what);
    assertSame(solution(toml), whole[row], what);
  }
});

test('a motion that nothing tells is no case', async () => {
  const disc = shippedCase('disc.toml');
  const tables = [
    ['nu', table('no_nu.csv', 'continue', disc, ...columns('branch', ...stretches))],
    ['nu', table('no_branch.csv', 'continue', disc, ...columns(...stretches))],
    ['branch', table('no_branch_atlas.csv', 'atlas', disc, ...columns('sheet', 'nu1', 'nu2', 'nu3', ...stretches))],
    ['branch', write('foreign.csv', 'nu3,alpha,xi,zeta,rho\n0.1,0,1,1,1\n0.2,0,1,1,1\n')],
    ['theta_dot', write('no_rate.csv', 'branch,omega,alpha,xi,zeta,rho\ntwo-polar,1,0,2,1,1\n')],
  ];
  for (const [missing, path] of tables) {
    const { note, toml, command, name } = await panel(path, 1);
    assert.deepEqual({ toml, command, name }, { toml: null, command: null, name: null }, path);
    assert.ok(note.includes(`(${missing})`) && note.includes('no case'), note);
  }
});

test('the plane of an axis that lies in two of them is its sheet\'s', async () => {
  // Without the column event nothing says that the sheet ends there, and without metadata nothing else tells the plane.
  const path = table('planes.csv', 'continue', shippedCase('tilted.toml'), ...columns('branch', 'sheet', 'nu1', 'nu2', 'nu3', ...stretches));
  const { rows } = csv(path);
  assert.equal(Number(rows[rows.length - 1].nu1), 0);
  assert.match((await panel(path, rows.length)).toml, /^plane = "13"$/m);
  rmSync(path.replace(/\.csv$/, '.meta.json'));
  for (const row of [rows.length, rows.length - 1]) assert.match((await panel(path, row)).toml, /^plane = "13"$/m);
  // A row by itself shows none, and none is made up.
  const alone = await panel(write('alone.csv', 'branch,nu1,nu2,nu3,alpha,xi,zeta,rho\ntilted,0,0,1,0,1,1,1\n'), 1);
  assert.doesNotMatch(alone.toml, /plane/);
  const inNone = await panel(write('in_none.csv', 'branch,nu1,nu2,nu3,alpha,xi,zeta,rho\ntilted,0.1,0,1,0,1,1,1\ntilted,0.1,0.1,1,0,1,1,1\n'), 1);
  assert.match(inNone.toml, /^plane = "123"$/m);
});

test('a cell without a motion is a case with its numbers and no start', async () => {
  const map = `
[map]
x = { parameter = "nu", from = 0.9, to = 1.2, count = 7 }
y = { parameter = "body.J.1", from = 1.5, to = 1.9, count = 3 }
`;
  for (const plane of ['13', null]) {
    const [own] = /^plane = ".*\n/m.exec(readCase('tilted.toml'));
    const text = readCase('tilted.toml').replace(own, plane === null ? '' : own) + map;
    const path = table(`tilted_map${plane}.csv`, 'map', write(`tilted_map${plane}.toml`, text));
    const { rows } = csv(path);
    const row = rows.findIndex((each) => each.status !== 'solved');
    assert.ok(row >= 0);
    const { note, toml, command, name } = await panel(path, row + 1);
    assert.ok(note.includes(rows[row].status) && note.includes('no start'), note);
    assert.equal(name, 'A case with the numbers of this row');
    assert.equal(command, null);
    assert.doesNotMatch(toml, /start|NaN/);
    const [, nu] = /^nu = (.*)$/m.exec(toml);
    assert.equal(Number(nu), Number(rows[row].nu));
    assert.equal(/^plane = "(.*)"$/m.exec(toml)?.[1] ?? null, plane);
    const [, J] = /^J = \[(.*)\]$/m.exec(toml);
    assert.equal(Number(J.split(',')[1]), Number(rows[row]['body.J.1']));
    const { code, err } = run('solve', write('cell.toml', toml), '-o', 'cell.csv');
    assert.equal(code, 3, err);
  }
});

test('a row that is no place to start from says so, and gives the nearest that is one', async () => {
  const folds = table('folds.csv', 'continue', shippedCase('fold.toml'));
  const fibre = table('fibre_atlas.csv', 'atlas', shippedCase('fibre.toml'));
  const fold = csv(folds).rows.findIndex((each) => each.event === 'fold-nu') + 1;
  assert.ok(fold > 1);
  const rows = [
    [result('oblique.csv'), 1, 2],
    [fibre, 250, 251],
    [fibre, 473, 474],
    [result('two_polar.csv'), 1, 2],
    [result('tilted.csv'), 32, 31],
    [result('tilted.csv'), 1, 2],
    [result('heavy_plate_atlas.csv'), 2280, 2278],
    [folds, fold, fold - 1],
  ];
  for (const [path, row, beside] of rows) {
    const what = `${path}:${row}`;
    const { note, toml, command, name } = await panel(path, row);
    assert.ok(note?.includes(`row ${beside}, the nearest of its sheet`), `${what}: ${note}`);
    assert.equal(name, `A case that starts at row ${beside}`);
    assert.match(command, new RegExp(`\\.csv:${beside} `));
    assert.match(toml, new RegExp(`^# row ${beside} of `));
    assertSame(solution(toml), csv(path).rows[beside - 1], what);
  }
  assert.match((await panel(result('heavy_plate_atlas.csv'), 2280)).toml, /^plane = "13"$/m);
  const usual = await panel(folds, fold - 1);
  assert.equal(usual.note, null);
  assert.equal(usual.name, 'A case that starts at this row');
});

test('a row that is no place to start from, with none beside it, says that', async () => {
  const header = 'branch,sheet,event,nu1,nu2,nu3,alpha,xi,zeta,rho\n';
  const still = await panel(write('still.csv', `${header}oblique,1,limit,0,0,0,0,1,1,1\n`), 1);
  assert.match(still.note, /ν = 0, so that there is no case/);
  assert.equal(still.toml, null);
  const meeting = await panel(write('meeting.csv', `${header}iii,1,ellipse,0,0,1,0,1,1,1\niii,2,,0,0,1,0,1,1,1\n`), 1);
  assert.match(meeting.note, /^Sheets meet at this row, .* no row of its sheet is a better start\.$/);
  assert.match(meeting.toml, /^# row 1 of meeting\.csv$/m);
  const curve = await panel(result('elastic_sphere_fold_nu.csv'), 3);
  assert.match(curve.note, /^This row is a fold, /);
  assert.match(curve.toml, /^# row 3 of /m);
});
