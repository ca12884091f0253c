// Pages of every kind of table: they open without a word from the browser, ask for nothing, and show the file's own texts.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { cells, colours, csv, filled, inked, makePage, open, result, shippedCase, start, stop, table, write } from './support.mjs';

before(start);
after(stop);

const atlases = readdirSync(result('')).filter((name) => name.endsWith('_atlas.csv'));

test('the page of every shipped atlas opens and draws', async (t) => {
  assert.ok(atlases.length >= 7);
  for (const name of atlases) {
    await t.test(name, async () => {
      const path = makePage(result(name));
      const text = readFileSync(path, 'utf8');
      assert.ok(text.length < 3e6, `${text.length} bytes`);
      assert.doesNotMatch(text, /:\/\//, 'an address');
      assert.match(text, /no solver/);
      const page = await open(path);
      assert.equal(await page.getAttribute('body', 'data-state'), 'ready');
      assert.ok((await inked(page)) > 2000);
      assert.equal(await page.locator('#events li').count(), csv(result(name)).rows.filter((row) => row.event !== '').length);
      assert.deepEqual(page.complaints, []);
      await page.close();
    });
  }
});

test('the numbers at an axis have room and tell its ticks apart', async () => {
  const page = await open(makePage(result('fold.csv')));
  const ticks = (page, axis) => page.$$eval(`${axis} .tick text`, (all) => all.map((each) => {
    const [box, host] = [each.getBoundingClientRect(), each.closest('svg').getBoundingClientRect()];
    return { text: each.textContent, from: box.left - host.left, to: box.right - host.left };
  }));
  const assertApart = (seen, what) => {
    const texts = seen.map((each) => each.text);
    assert.ok(texts.length > 1 && new Set(texts).size === texts.length, `${what}: ${texts}`);
    for (let k = 1; k < seen.length; ++k) assert.ok(seen[0].to === seen[1].to || seen[k].from > seen[k - 1].to, `${what}: ${texts}`);
  };
  const narrow = 'zoom=0.5491055228,0.549105523,1.64872127,1.64872128';
  for (const view of ['x=error_bound&y=residual', 'x=|pi|&y=energy', 'x=point&y=growth', `log=0&${narrow}`, 'zoom=1e8,9e8,1e8,9e8', 'zoom=-1e-12,1e-12,-1e200,1e200', narrow]) {
    await page.evaluate((to) => (location.hash = to), `#${view}`);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    for (const axis of ['#axis-x', '#axis-y']) assertApart(await ticks(page, axis), `${view} ${axis}`);
    assert.ok((await ticks(page, '#axis-y')).every((each) => each.from > 15), view);
  }
  // What they leave out of a narrow axis stands beside its name.
  assert.match(await page.textContent('#name-x'), /, less 0\.549105523$/);
  await page.close();
  const growing = await open(makePage(result('oblique.csv')), { fragment: '#row=138' });
  assertApart(await ticks(growing, '#spectrum .re-axis'), 'spectrum');
  await growing.close();
});

test('the body is drawn: many colours, and none of them all of it', async () => {
  const page = await open(makePage(result('neo_hookean_atlas.csv')));
  const counts = await colours(page, '#body-frame');
  const all = counts.reduce((sum, each) => sum + each, 0);
  assert.ok(counts.length > 500, `${counts.length} colours`);
  assert.ok(counts[0] < 0.5 * all);
  await page.close();
});

test('every cell of a row stands in the page as in the file', async () => {
  const { rows } = csv(result('two_polar.csv'));
  const path = makePage(result('two_polar.csv'));
  const page = await open(path);
  const seen = [0, 1, 2, 17, rows.length - 1];
  for (const row of seen) {
    await page.evaluate((to) => (location.hash = `#row=${to}`), row + 1);
    await page.waitForFunction((name) => document.getElementById('row-name').textContent.includes(`point ${name}`), rows[row].point);
    assert.deepEqual(await cells(page), filled(rows[row]));
  }
  await page.close();
});

test('modes of the spectrum are the row\'s, one of each pair, with their signatures', async () => {
  const { rows } = csv(result('disc.csv'));
  const row = rows.findIndex((each) => each.krein2 === '1' && each.re5 !== '');
  const page = await open(makePage(result('disc.csv')), { fragment: `#row=${row + 1}` });
  const shown = await page.$$eval('#modes tr', (lines) => lines.map((line) => [...line.cells].map((cell) => cell.textContent)));
  assert.equal(shown.length, 5);
  for (const [k, re, im, krein] of shown) {
    assert.ok(Math.abs(Number(re) - Number(rows[row][`re${k}`])) <= 1e-9 * Math.abs(Number(re)));
    assert.ok(Math.abs(Number(im) - Number(rows[row][`im${k}`])) <= 1e-9 * Math.abs(Number(im)));
    assert.equal(krein, { 1: '+1', '-1': '−1', 0: '0', '': 'not certain' }[rows[row][`krein${k}`]]);
  }
  const signs = [...'12345'].map((k) => rows[row][`krein${k}`]);
  const zero = [...'12345'].filter((k) => rows[row][`re${k}`] === '0' && rows[row][`im${k}`] === '0').length;
  assert.equal(await page.locator('#spectrum .root.plus').count(), 2 * signs.filter((each) => each === '1').length);
  assert.ok((await page.locator('#spectrum .root').count()) >= 10 - zero);
  await page.close();
});

test('every solution at one spin is a point of its own', async () => {
  const page = await open(makePage(result('every_sheet.csv')));
  assert.equal(await page.inputValue('#axis-of-x'), 'lambda');
  assert.equal(await page.inputValue('#axis-of-y'), 'mu');
  const { rows } = csv(result('every_sheet.csv'));
  assert.deepEqual(await cells(page), filled(rows[0]));
  await page.locator('#plot').press('ArrowDown');
  assert.deepEqual(await cells(page), filled(rows[1]));
  assert.deepEqual(page.complaints, []);
  await page.close();
});

const mapped = () => table('map.csv', 'map', shippedCase('fibre_map.toml'), '--set', 'map.x.count=24', '--set', 'map.y.count=16');

test('a map is a heat map: a click and the arrow keys open its cells', async () => {
  const { header, rows } = csv(mapped());
  const page = await open(makePage(mapped()));
  assert.ok((await inked(page)) > 100000);
  const [x, y] = header.slice(-2);
  const plot = await page.locator('#plot').boundingBox();
  await page.mouse.click(plot.x + 0.4 * plot.width, plot.y + 0.5 * plot.height);
  const clicked = await cells(page);
  const at = rows.findIndex((row) => row[x] === clicked[x] && row[y] === clicked[y]);
  assert.ok(at >= 0);
  assert.deepEqual(clicked, filled(rows[at]));
  await page.locator('#plot').press('ArrowRight');
  const next = await cells(page);
  assert.equal(next[y], clicked[y]);
  assert.ok(Number(next[x]) > Number(clicked[x]));
  await page.locator('#plot').press('ArrowUp');
  assert.ok(Number((await cells(page))[y]) > Number(clicked[y]));
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('the scale of a map says where cells lie beyond its ends', async () => {
  const map = (name, value) => {
    const cells = Array.from({ length: 400 }, (_, k) => `i,1,${value(k)},solved,${k % 20},${Math.floor(k / 20)}\n`);
    return write(name, `branch,xi,energy,status,nu,body.J.1\n${cells.join('')}`);
  };
  const ends = async (path) => {
    const page = await open(makePage(path), { fragment: '#y=energy' });
    const text = await page.locator('#legend .key').first().textContent();
    assert.deepEqual(page.complaints, []);
    await page.close();
    return text;
  };
  // The least and the largest 1 in 200 are left out of the scale.
  assert.match(await ends(map('wide.csv', (k) => k)), /: ≤ 1≥ 397$/);
  assert.match(await ends(map('even.csv', (k) => k % 2)), /: 01$/);
  assert.match(await ends(map('above.csv', (k) => (k === 7 ? 1e6 : k % 2))), /: 0≥ 1$/);
  assert.match(await ends(map('below.csv', (k) => (k === 7 ? -1e6 : k % 2))), /: ≤ 01$/);
});

test('the colours of a map\'s statuses are told', async () => {
  const { rows } = csv(mapped());
  const page = await open(makePage(mapped()), { fragment: '#y=status' });
  const told = await page.$$eval('#legend .key', (keys) => keys.map((key) => key.textContent));
  assert.deepEqual(told.sort(), [...new Set(rows.map((row) => row.status))].sort());
  await page.close();
});

test('curves of events lie on a map over the same parameters', async () => {
  const tilting = write('tilting.toml', `[body]
J = [1.0, 1.7, 0.6]
[potential]
plane = { model = "neo-hookean", mu = 1.0, lambda = 2.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "i"
nu = 0.5
[map]
x = { parameter = "nu", from = 0.3, to = 0.8, count = 30 }
y = { parameter = "body.J.1", from = 1.2, to = 2.4, count = 25 }
[curve]
event = "tilt"
parameters = ["nu", "body.J.1"]
from = [0.3, 1.2]
to = [0.8, 2.4]
`);
  const [map, curve] = [table('tilting_map.csv', 'map', tilting), table('tilting_curve.csv', 'curve', tilting)];
  const [alone, together] = [await open(makePage(map)), await open(makePage([map, curve]))];
  const picture = async (page) => (await page.locator('#curves').screenshot()).toString('base64');
  assert.notEqual(await picture(alone), await picture(together));
  await together.selectOption('#tables', '1');
  assert.match(await together.textContent('#events'), /tilt.*\(i\) curve 1/);
  await together.locator('#events button').first().click();
  assert.deepEqual(await cells(together), filled(csv(curve).rows[0]));
  assert.ok((await inked(together)) > 500);
  assert.deepEqual(together.complaints, []);
  await alone.close();
  await together.close();
});

test('between an event and an end, where no row lies, a line has the class of the metadata\'s segment', async () => {
  const rows = ['0,limit,0.1,1,1,1,stable,1', '1,,0.3,1,1.2,1,stable,1', '2,shear,0.5,1,1.3,1,marginal,1', '3,tilt,0.9,1,1.5,1,marginal,2'];
  const path = write('stretch.csv', `branch,sheet,point,event,nu3,xi,zeta,rho,class,segment\n${rows.map((row) => `iii,1,${row}\n`).join('')}`);
  const about = (verdict) => write('stretch.meta.json', JSON.stringify({ segments: [{ sheet: 1, segment: 1, class: 'stable' }, { sheet: 1, segment: 2, class: verdict }] }));
  const seen = async (fragment) => {
    const page = await open(makePage(path), { fragment });
    assert.deepEqual(page.complaints, []);
    const out = { ink: await inked(page), classes: await page.$$eval('#legend input[name^=class]', (all) => all.map((each) => each.name)) };
    await page.close();
    return out;
  };
  const beside = (without) => `#x=nu3&y=zeta&row=1&zoom=0.6,0.8,0,2&without=${without}`;
  for (const verdict of ['unstable', 'elliptic']) {
    about(verdict);
    const all = await seen(beside(''));
    assert.ok(all.ink > 500 && all.classes.includes(`class ${verdict}`), all.classes.join());
    assert.equal((await seen(beside('stable'))).ink, all.ink);
    assert.equal((await seen(beside(verdict))).ink, 0);
  }
  // Metadata that do not tell it: as the rows before.
  about(null);
  assert.equal((await seen(beside('stable'))).ink, 0);
});

test('what an address asks for stays: several quantities that no view has, rows without a class', async () => {
  const rows = [0.1, 0.2, 0.3, 0.4].map((nu, k) => `iii,1,${k},0,0,${nu},${1 + nu},${1 - nu},1,${1 + nu},${1 - nu}\n`).join('');
  const path = makePage(write('bare.csv', `branch,sheet,point,nu1,nu2,nu3,xi,zeta,rho,lambda,mu\n${rows}`));
  const page = await open(path, { fragment: '#y=xi,zeta' });
  await page.locator('#colour').selectOption('sheet');
  assert.match(decodeURIComponent(page.url()), /y=xi,zeta/);
  const all = await inked(page);
  await page.locator('#legend input[name="class "]').uncheck();
  assert.ok((await inked(page)) < all);
  const without = page.url();
  await page.close();
  const again = await open(path, { fragment: without.slice(without.indexOf('#')) });
  assert.ok((await inked(again)) < all);
  assert.deepEqual(again.complaints, []);
  await again.close();
});

test('beside rest a line has the class of the motions there', async () => {
  const row = (point, nu, verdict) => `iii,1,${point},0,0,${nu},1,${1 + nu ** 2},1,${verdict}\n`;
  const page = await open(makePage(write('rest.csv', `branch,sheet,point,nu1,nu2,nu3,xi,zeta,rho,class\n${row(0, -0.3, 'unstable')}${row(1, 0, 'stable')}${row(2, 0.3, 'unstable')}${row(3, 0.6, 'unstable')}`)), { fragment: '#y=zeta&row=4&zoom=-0.2,0.2,0.9,1.2' });
  const all = await inked(page);
  assert.ok(all > 500);
  await page.locator('#legend input[name="class stable"]').uncheck();
  assert.equal(await inked(page), all);
  await page.close();
});

test('a table with one component of the spin is drawn against it', async () => {
  const columns = ['branch', 'sheet', 'point', 'event', 'nu3', 'lambda', 'mu', 'rho', 'class'];
  const page = await open(makePage(table('component.csv', 'continue', shippedCase('third_axis.toml'), '--set', `output.columns=${JSON.stringify(columns)}`)));
  assert.equal(await page.inputValue('#axis-of-x'), 'nu3');
  await page.close();
});

test('an event that is not located stands in the list with its bracket', async () => {
  const path = write('unlocated.csv', 'branch,sheet,point,event,nu3,xi,zeta,rho\niii,1,0,limit,0.1,1,1,1\niii,1,1,,0.3,1.1,1,1\n');
  const event = { event: 'tilt', sheet: 1, point: null, parameter: 0.2, bracket: [0.15, 0.25], status: 'unresolved' };
  const skipped = [{ quantity: 'spectrum', how: 'not computed', why: 'not asked for' }];
  write('unlocated.meta.json', JSON.stringify({ case: { title: 'Unlocated', body: { J: [1, 2, 3] } }, events: [event], skipped }));
  const page = await open(makePage(path));
  const list = await page.$$eval('#events li', (items) => items.map((item) => item.textContent));
  assert.equal(list.length, 2);
  assert.match(list[1], /tilt.*0\.2.*unresolved, between 0\.15 and 0\.25/);
  assert.equal(await page.locator('#events li').nth(1).locator('button').count(), 0);
  assert.match(await page.textContent('#skipped'), /spectrum: not asked for/);
  assert.equal(await page.isVisible('#spectrum-none'), true);
  assert.equal(await page.isDisabled('#as-mass'), false);
  await page.close();
});

test('numbers near the ends of the range of doubles are left out of an axis, not the page', async () => {
  const row = (nu, xi, energy) => `iii,1,${nu},${xi},1,1,${energy}\n`;
  for (const rows of [row('1e-320', 1, 2) + row('2e-320', 1.1, 2), row('-1e308', '1e308', '1e308') + row('1e308', '1e-308', '-1e308'), row(0.1, 1, 2) + row(0.2, 'inf', 'nan') + row(0.3, 1.2, '1e300') + row(0.4, 1.3, 3)]) {
    const page = await open(makePage(write('ends.csv', `branch,sheet,nu3,xi,zeta,rho,energy\n${rows}`)));
    for (const name of await page.$$eval('#axis-of-y option', (options) => options.map((each) => each.value))) {
      await page.selectOption('#axis-of-y', name);
      for (const axis of ['#axis-x', '#axis-y']) assert.ok((await page.locator(`${axis} .tick`).count()) > 1, `${name} ${axis} of ${rows}`);
      assert.doesNotMatch(await page.textContent('#axes'), /NaN|Infinity/);
    }
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
});

test('HDF5 gives the same page as CSV, but for the name', async () => {
  const words = ['continue', shippedCase('tilted.toml')];
  const [a, b] = [await open(makePage(table('t.csv', ...words))), await open(makePage(table('t.h5', ...words)))];
  for (const row of [1, 5]) {
    for (const page of [a, b]) await page.evaluate((to) => (location.hash = `#row=${to}`), row);
    assert.deepEqual(await cells(a), await cells(b));
  }
  assert.equal(await a.textContent('#title'), await b.textContent('#title'));
  await a.close();
  await b.close();
});
