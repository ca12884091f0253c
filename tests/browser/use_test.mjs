// What a person does with a page: pointer, keys, switches, links, going on from a row.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { cells, csv, filled, inked, makePage, open, result, run, shippedCase, start, stop, table, write } from './support.mjs';

before(start);
after(stop);

const followed = () => table('fold.csv', 'continue', shippedCase('fold.toml'));

test('hovering reads the nearest point, a click chooses it', async () => {
  const { rows } = csv(followed());
  const page = await open(makePage(followed()));
  const plot = await page.locator('#plot').boundingBox();
  // Down the middle until a curve is near.
  let found = false;
  for (let share = 0.1; share < 0.9 && !found; share += 0.02) {
    await page.mouse.move(plot.x + 0.5 * plot.width, plot.y + share * plot.height);
    found = await page.isVisible('#tip');
    if (found) await page.mouse.click(plot.x + 0.5 * plot.width, plot.y + share * plot.height);
  }
  assert.ok(found);
  const tip = await page.textContent('#tip');
  const point = /point (\d+)/.exec(tip)[1];
  const row = rows.find((each) => each.point === point);
  assert.deepEqual(await cells(page), filled(row));
  const shown = Number(/= ([\d.]+) ±/.exec(tip)[1]);
  assert.ok(['lambda', 'mu', 'rho'].some((name) => Math.abs(Number(row[name]) - shown) < 1e-8), tip);
  assert.match(tip, new RegExp(row.class));
  await page.close();
});

test('keys go along the sheet, to events, to other sheets, and zoom', async () => {
  const { rows } = csv(result('neo_hookean_atlas.csv'));
  const page = await open(makePage(result('neo_hookean_atlas.csv')), { fragment: '#row=1' });
  const plot = page.locator('#plot');
  assert.deepEqual(await cells(page), filled(rows[0]));
  const expectRow = async (key, index) => {
    await plot.press(key);
    assert.deepEqual(await cells(page), filled(rows[index]), key);
  };
  await expectRow('ArrowRight', 1);
  await expectRow('Shift+ArrowRight', 11);
  await expectRow('ArrowLeft', 10);
  const last = rows.findLastIndex((row) => row.sheet === rows[0].sheet);
  await expectRow('End', last);
  await expectRow('ArrowRight', last);
  await expectRow('Home', 0);
  await expectRow('e', rows.findIndex((row, k) => k > 0 && row.event !== ''));
  await plot.press('ArrowDown');
  assert.notEqual((await cells(page)).sheet, rows[0].sheet);
  const before = await inked(page);
  await plot.press('+');
  const larger = page.url();
  assert.match(larger, /zoom=/);
  await plot.press('-');
  assert.notEqual(page.url(), larger);
  assert.ok(Math.abs((await inked(page)) - before) < 0.02 * before);
  await plot.press('+');
  assert.equal(page.url(), larger);
  await plot.press('0');
  assert.doesNotMatch(page.url(), /zoom=/);
  assert.ok(Math.abs((await inked(page)) - before) < 0.02 * before);
  await page.close();
});

test('the live region reads the chosen point', async () => {
  const { rows } = csv(followed());
  const page = await open(makePage(followed()), { fragment: '#row=3' });
  await page.locator('#plot').press('ArrowRight');
  const said = await page.textContent('#point');
  assert.equal(await page.getAttribute('#point', 'aria-live'), 'polite');
  assert.ok(said.includes(`point ${rows[3].point}`) && said.includes(rows[3].class), said);
  await page.close();
});

test('what stands of the chosen point is of the quantity that is drawn', async () => {
  const { rows } = csv(followed());
  const page = await open(makePage(followed()), { fragment: '#row=3' });
  await page.selectOption('#axis-of-y', 'energy');
  const [, energy] = /E = (.*)\. \w+$/.exec(await page.textContent('#point'));
  assert.ok(Math.abs(Number(energy.replace('−', '-')) - Number(rows[2].energy)) < 1e-9, energy);
  await page.close();
});

test('the events are a list of text, and each goes to its row', async () => {
  const { rows } = csv(followed());
  const page = await open(makePage(followed()));
  const events = rows.flatMap((row, k) => (row.event === '' ? [] : [k]));
  const list = await page.$$eval('#events li', (items) => items.map((item) => item.textContent));
  assert.equal(list.length, events.length);
  for (const [k, row] of events.entries()) {
    assert.ok(list[k].includes(rows[row].event) && list[k].includes(rows[row].nu3), list[k]);
    await page.locator('#events button').nth(k).click();
    assert.deepEqual(await cells(page), filled(rows[row]));
  }
  assert.equal(await page.locator('#events button[aria-pressed=true]').count(), 1);
  await page.close();
});

test('classes, branches and sheets are switched off and on', async () => {
  // At a zoom of its own the diagram does not adapt to what is left.
  const page = await open(makePage(result('neo_hookean_atlas.csv')), { fragment: '#zoom=0.5,1.2,0.01,100' });
  const all = await inked(page);
  for (const name of ['class elliptic', 'branch iii', 'sheet iii.4']) {
    await page.locator(`#legend input[name="${name}"]`).uncheck();
    assert.ok((await inked(page)) < all, name);
    await page.locator(`#legend input[name="${name}"]`).check();
    assert.equal(await inked(page), all, name);
  }
  await page.close();
});

test('of a complete atlas, how many motions of each class there are at every nu is drawn and told', async () => {
  const path = table('complete.csv', 'atlas', shippedCase('neo_hookean.toml'), '--complete');
  const { classes } = JSON.parse(readFileSync(path.replace(/\.csv$/, '.meta.json'), 'utf8'));
  assert.ok(classes.length > 10);
  const page = await open(makePage(path));
  // A strip for each kind of motion: tilted ones are of one plane or of the other.
  const kinds = [...new Set(classes.map((each) => `${each.branch} ${each.plane}`))];
  assert.ok(kinds.length > new Set(classes.map((each) => each.branch)).size);
  assert.equal(await page.locator('.proven-strip').count(), kinds.length);
  await page.evaluate(() => document.querySelectorAll('#proven-part details').forEach((each) => (each.open = true)));
  const told = await page.$$eval('#proven tr', (all) => all.map((each) => [...each.children].map((cell) => cell.textContent)));
  assert.equal(told.length, classes.length);
  for (const [k, each] of classes.entries()) {
    assert.ok(told[k][0].includes(each.branch));
    if (each.plane) assert.ok(told[k][0].endsWith(`plane ${each.plane}`));
    assert.equal(Number(told[k][1]), each.from);
    assert.equal(Number(told[k][2]), each.to);
    const counts = Object.entries(each.sheets ?? {}).map(([name, count]) => `${count} ${name}`).join(', ');
    assert.equal(told[k][3], each.status === 'proven' ? counts || 'no motion' : [each.reason, ...each.events].join(': '));
  }
  // Ink where there is a motion, in one band for each; not where there is none; a mark where nothing is told.
  const seen = await page.$$eval('.proven-strip', (strips, given) => {
    const { from, to } = { from: Math.min(...given.map((each) => each.from)), to: Math.max(...given.map((each) => each.to)) };
    const kindOf = (each) => `${each.branch} ${each.plane}`;
    return [...new Set(given.map(kindOf))].flatMap((kind, which) => {
      const strip = strips[which];
      const { data } = strip.getContext('2d').getImageData(0, 0, strip.width, strip.height);
      const inked = (x, y) => data[4 * (y * strip.width + x) + 3] > 200;
      return given.filter((each) => kindOf(each) === kind && each.to - each.from > 0.02 * (to - from) && each.status === 'proven').map((each) => {
        const x = Math.floor((((each.from + each.to) / 2 - from) / (to - from)) * strip.width);
        const bands = Object.values(each.sheets).reduce((sum, count) => sum + count, 0);
        let rows = 0;
        for (let y = 0; y < strip.height - 8; ++y) if (inked(x, y)) ++rows;
        return { bands, rows: Math.round(rows / 13) };
      });
    });
  }, classes);
  assert.ok(seen.length >= 5);
  for (const { bands, rows } of seen) assert.equal(rows, bands);
  // Not by colour alone: samples of different classes have different patterns of light.
  const patterns = await page.$$eval('.proven-sample', (samples) =>
    samples.map((sample) => {
      const { data } = sample.getContext('2d').getImageData(0, 1, sample.width, 11);
      const light = data.filter((_, k) => k % 4 === 1);
      return light.map((level) => (level > light.reduce((a, b) => Math.min(a, b)) + 20 ? 1 : 0)).join('');
    }),
  );
  assert.ok(patterns.length >= 3);
  assert.equal(new Set(patterns).size, patterns.length);
  assert.deepEqual(page.complaints, []);
  await page.close();
  const other = await open(makePage(result('neo_hookean_atlas.csv')));
  assert.equal(await other.isVisible('#proven-part'), false);
  await other.close();
});

test('axes are any columns; energy against momentum is a button', async () => {
  const page = await open(makePage(followed()));
  const before = await inked(page);
  await page.click('[data-preset=energy-momentum]');
  assert.equal(await page.inputValue('#axis-of-x'), '|pi|');
  assert.equal(await page.inputValue('#axis-of-y'), 'energy');
  assert.notEqual(await inked(page), before);
  const offered = await page.$$eval('#axis-of-y option', (options) => options.map((each) => each.value));
  for (const name of ['alpha', 'xi', 'energy', 'growth', 'im3', 'residual']) assert.ok(offered.includes(name), name);
  for (const name of offered) await page.selectOption('#axis-of-y', name);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('a link opens what was seen; one that means nothing opens the page', async () => {
  const path = makePage(result('neo_hookean_atlas.csv'));
  const first = await open(path);
  await first.selectOption('#axis-of-y', 'energy');
  await first.locator('#legend input[name="branch i"]').uncheck();
  await first.selectOption('#colour', 'sheet');
  await first.locator('#plot').press('+');
  await first.locator('#events button').nth(3).click();
  const fragment = new URL(first.url()).hash;
  const second = await open(path, { fragment });
  assert.deepEqual(await cells(second), await cells(first));
  assert.equal(await second.inputValue('#axis-of-y'), 'energy');
  assert.equal(await second.inputValue('#colour'), 'sheet');
  assert.equal(await second.locator('#legend input[name="branch i"]').isChecked(), false);
  assert.equal(await inked(second), await inked(first));
  await first.close();
  await second.close();
  for (const wrong of ['#row=999999&x=no&y=__proto__&zoom=NaN,1,2,3&table=77', '#%3Cimg%20src=x%20onerror=alert(1)%3E', '#row=-1&zoom=2,1,0,1', '#hide=constructor&colour=toString']) {
    const page = await open(path, { fragment: wrong });
    assert.equal(await page.getAttribute('body', 'data-state'), 'ready', wrong);
    assert.deepEqual(page.complaints, [], wrong);
    assert.ok((await inked(page)) > 2000, wrong);
    await page.close();
  }
});

test('a link of a narrow zoom opens the same view', async () => {
  const path = makePage(followed());
  const first = await open(path, { fragment: '#zoom=0.5,0.6,1.2,1.3' });
  const axes = async (page) => [await page.textContent('#axis-x'), await page.textContent('#axis-y')];
  const narrowed = async (page) => {
    for (let k = 0; k < 40; ++k) await page.locator('#plot').press('+');
    return new URL(page.url()).hash;
  };
  const second = await open(path, { fragment: await narrowed(first) });
  assert.deepEqual(await axes(second), await axes(first));
  // It narrows on from there, until digits end.
  const third = await open(path, { fragment: await narrowed(second) });
  assert.notDeepEqual(await axes(second), await axes(first));
  assert.deepEqual(await axes(third), await axes(second));
  for (const page of [second, third]) {
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
  await first.close();
});

test('a row as TOML is a case whose solution is the row', async () => {
  for (const [name, ...words] of [['fold.csv', 'continue', shippedCase('fold.toml')], ['tilted.csv', 'continue', shippedCase('tilted.toml')], ['inertia.csv', 'continue', shippedCase('inertia.toml')]]) {
    const { rows } = csv(table(name, ...words));
    const row = Math.floor(rows.length / 3);
    const page = await open(makePage(table(name, ...words)), { fragment: `#row=${row + 1}` });
    const solved = table(`again_${name}`, 'solve', write(`${name}.toml`, await page.textContent('#toml')));
    const again = csv(solved).rows[0];
    for (const column of ['xi', 'zeta', 'rho', 'nu1', 'nu2', 'nu3', 'energy'])
      assert.ok(Math.abs(Number(again[column]) - Number(rows[row][column])) <= 1e-9 * Math.max(1, Math.abs(Number(rows[row][column]))), `${name} ${column}`);
    assert.equal(again.branch, rows[row].branch);
    await page.close();
  }
});

test('a round two-polar motion and a length of an atlas from below 0 have cases that are taken', async () => {
  const all = table('round.csv', 'solve', shippedCase('two_polar.toml'), '--set', 'solve.all=true');
  const round = csv(all).rows.findIndex((row) => row.xi === row.zeta);
  assert.ok(round >= 0);
  const both = table('both.csv', 'atlas', shippedCase('neo_hookean.toml'), '--set', 'continuation.from=-1', '--set', 'continuation.to=1');
  const tilted = csv(both).rows.findIndex((row) => row.branch === 'tilted' && row.event === '');
  assert.ok(tilted >= 0);
  for (const [name, row, what] of [[all, round, /round at this row/], [both, tilted, /^$/]]) {
    const page = await open(makePage(name), { fragment: `#row=${row + 1}` });
    assert.equal(run('solve', write('offered.toml', await page.textContent('#toml'))).code, 0);
    assert.match(await page.textContent('#start-note'), what);
    await page.close();
  }
});

test('a body whose table leaves columns out turns as its case says', async () => {
  const some = table('some.csv', 'continue', shippedCase('fold.toml'), '--set', 'output.columns=["nu1","lambda","mu","rho","angle","class"]');
  const page = await open(makePage(some), { fragment: '#row=30' });
  assert.match(await page.getAttribute('#body', 'aria-label'), /turning about/);
  await page.close();
});

test('the diagram has one page for several tables', async () => {
  const page = await open(makePage([followed(), result('two_polar.csv')]));
  await page.selectOption('#tables', '1');
  assert.equal((await cells(page)).branch, 'two-polar');
  assert.match(page.url(), /table=2/);
  await page.close();
});

test('a damaged page says so', async () => {
  const path = makePage(followed());
  const text = readFileSync(path, 'utf8');
  const broken = write('broken.html', text.replace(/(id="data">.{400})./, '$1!'));
  const page = await open(broken);
  assert.equal(await page.getAttribute('body', 'data-state'), 'failed');
  assert.match(await page.textContent('#failure'), /damaged/);
  await page.close();
});

test('a broken table is refused with its place', () => {
  const path = write('broken.csv', 'branch,sheet,point,nu3,xi\niii,1,0,0.1,1\niii,1,1,0.2,wide\n');
  const { code, err } = run('explore', path, '-o', 'x.html');
  assert.equal(code, 2);
  assert.match(err, /broken\.csv:3/);
  assert.match(err, /wide/);
});
