// Pages that compute: the same bits as the program, sliders, wrong cases, giving up.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { cells, csv, filled, folder, makePage, open, run, shippedCase, start, stop, table, write } from './support.mjs';

before(start);
after(stop);

/** What the panel says when what it does is over. */
async function over(page, runs) {
  await page.waitForFunction((least) => {
    const { state, runs } = document.getElementById('live').dataset;
    return Number(runs ?? 0) >= least && state !== 'working';
  }, runs, { timeout: 60_000 });
  return page.$eval('#live', (live) => ({ state: live.dataset.state, runs: Number(live.dataset.runs), message: live.querySelector('#live-message').textContent }));
}
const runsOf = (page) => page.$eval('#live', (live) => Number(live.dataset.runs ?? 0));

async function openCase(text, name = 'given.toml') {
  const page = await open(makePage(write(name, text)));
  await over(page, 1);
  return page;
}

/** Computes another case in the panel; `task` chooses what is done with it. Inside the page: a thousand of these are nothing. */
const compute = (page, text) =>
  page.evaluate(async (given) => {
    const live = document.getElementById('live');
    const before = Number(live.dataset.runs ?? 0);
    document.getElementById('live-case').value = given;
    document.getElementById('live-use').click();
    while (!(Number(live.dataset.runs) > before && live.dataset.state !== 'working')) await new Promise((next) => setTimeout(next));
    return { state: live.dataset.state, message: document.getElementById('live-message').textContent, table: document.getElementById('live-csv').textContent };
  }, text);

const showTable = (page) => page.evaluate(() => { document.getElementById('live-table').open = true; });

/** Numbers from one seed, the same in every run. */
function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** A case of a model, a body and a spin of its own. */
function someCase(next) {
  const among = (low, high) => Number((low * (high / low) ** next()).toPrecision(6));
  const pick = (list) => list[Math.floor(next() * list.length)];
  const two = `mu = ${among(0.5, 2)}, lambda = ${among(0.3, 2)}`;
  const plane = pick([
    `{ model = "reciprocal-determinant", c = ${among(0.5, 2)}, k = ${among(1, 3)} }`,
    ...['saint-venant-kirchhoff', 'biot', 'biot-log', 'neo-hookean', 'hencky'].map((model) => `{ model = "${model}", ${two} }`),
    `{ expression = "a*(I1 - 2 - 2*log(d)) + b*(exp(d - 1) - d)", a = ${among(0.5, 2)}, b = ${among(0.5, 2)} }`,
  ]);
  const thickness = pick([`{ model = "reciprocal-quadratic", a = ${among(0.5, 2)}, b = ${among(1, 3)} }`, `{ model = "harmonic", k = ${among(1, 3)}, rest = 1.0 }`]);
  const potential = next() < 0.2 ? `coupled = { model = "neo-hookean-3d", ${two} }` : `plane = ${plane}\nthickness = ${thickness}`;
  return `[body]\nJ = [${among(0.7, 1.5)}, ${among(0.7, 1.5)}, ${among(0.7, 1.5)}]\n[potential]\n${potential}\n[motion]\nbranch = "${pick(['i', 'ii', 'iii'])}"\nnu = ${among(0.01, 0.4)}\n`;
}

test('two hundred cases are solved to the bit as the program solves them', async () => {
  const next = random(21);
  const page = await openCase(someCase(next));
  await showTable(page);
  let solved = 0;
  for (let k = 0; k < 200; ++k) {
    const text = someCase(next);
    const program = run('solve', write('random.toml', text), '-o', '-', '--quiet');
    const here = await compute(page, text);
    assert.equal(here.table, program.out, `case ${k}:\n${text}\n${here.message}`);
    if (program.code === 0) ++solved;
    assert.equal(here.state, { 0: 'done', 3: 'none', 4: 'failed' }[program.code], text);
  }
  assert.ok(solved > 150, `${solved} of 200 have a solution`);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('a family is followed as by the program, to the byte', async () => {
  for (const name of ['fold.toml', 'tilted.toml', 'two_polar.toml', 'inertia.toml', 'mooney_rivlin.toml', 'elastic_sphere.toml', 'heavy_plate.toml', 'no_plane.toml']) {
    const page = await open(makePage(shippedCase(name)));
    const { state, message } = await over(page, 1);
    assert.equal(state, 'done', `${name}: ${message}`);
    await showTable(page);
    const here = await page.textContent('#live-csv');
    assert.ok(here === readFileSync(table(`${name}.csv`, 'continue', shippedCase(name)), 'utf8'), name);
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
});

test('a thousand wrong formulas in a row are told what is wrong, and the next right one is solved', async () => {
  const right = someCase(random(5)).replace(/plane = .*/, 'plane = { expression = "a*(I1 - 2 - 2*log(d))", a = 1.5 }').replace(/coupled = .*/, 'plane = { expression = "a*(I1 - 2 - 2*log(d))", a = 1.5 }\nthickness = { model = "harmonic", k = 1.0, rest = 1.0 }');
  const page = await openCase(right);
  const wrong = ['a*(I1 - 2', 'a**I1', 'nobody + I1', 'sin()', 'a*I1 +', '1/0 + a', 'log(-1)*a', 'I1^^2', 'a*(d))', '\\u0000', '"', 'a*rho', '(((((((((a', 'd + ]', 'abs(lambda - 1)*a'];
  const bad = await page.evaluate(async ({ right, wrong }) => {
    const live = document.getElementById('live');
    const out = [];
    for (let k = 0; k < 1000; ++k) {
      const before = Number(live.dataset.runs);
      document.getElementById('live-case').value = right.replace('a*(I1 - 2 - 2*log(d))', wrong[k % wrong.length]);
      document.getElementById('live-use').click();
      while (!(Number(live.dataset.runs) > before && live.dataset.state !== 'working')) await new Promise((next) => setTimeout(next));
      const message = document.getElementById('live-message').textContent;
      if (live.dataset.state === 'done' || !/given\.toml:\d+:\d+/.test(message)) out.push(`${wrong[k % wrong.length]}: ${message}`);
    }
    return [...new Set(out)];
  }, { right, wrong });
  assert.deepEqual(bad, []);
  assert.equal((await compute(page, right)).state, 'done');
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('a slider computes what the program computes with its number', async () => {
  const path = shippedCase('fold.toml');
  const page = await open(makePage(path));
  await over(page, 1);
  await showTable(page);
  await page.click('[data-task=solve]');
  await over(page, 2);
  for (const [key, step] of [['nu', -30], ['body.J.1', 25], ['potential.plane.mu', 40]]) {
    const before = await runsOf(page);
    const slider = page.locator(`input[type=range][data-key="${key}"]`);
    await slider.evaluate((input, by) => {
      input.value = String(Number(input.value) + by);
      input.dispatchEvent(new Event('input', { bubbles: true }));
    }, step);
    await over(page, before + 1);
  }
  const set = [];
  for (const key of ['nu', 'body.J.1', 'potential.plane.mu'])
    set.push('--set', `${key === 'nu' ? 'motion.nu' : key}=${await page.inputValue(`input[type=number][data-key="${key}"]`)}`);
  const there = run('solve', path, '-o', '-', '--quiet', ...set);
  assert.equal(await page.textContent('#live-csv'), there.out, 'slider');
  assert.deepEqual(await cells(page), filled(csv(write('slider.csv', there.out)).rows[0]));
  // The keyboard moves it too.
  const before = await runsOf(page);
  await page.locator('input[type=range][data-key="body.J.1"]').press('ArrowRight');
  await over(page, before + 1);
  assert.notEqual(await page.textContent('#live-csv'), there.out);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('a field that is cleared keeps its number', async () => {
  const page = await open(makePage(shippedCase('disc.toml')));
  const { runs } = await over(page, 1);
  const field = page.locator('input[type=number][data-key="body.J.1"]');
  const before = await field.inputValue();
  await field.fill('');
  await field.press('Tab');
  assert.equal(await field.inputValue(), before);
  assert.equal((await over(page, runs)).state, 'done');
  assert.equal(await runsOf(page), runs);
  await page.close();
});

test('a table that has no numbers is said not to be drawn', async () => {
  const page = await open(makePage(shippedCase('disc.toml')));
  await over(page, 1);
  const { state, message } = await compute(page, `${readFileSync(shippedCase('disc.toml'), 'utf8')}\n[output]\ncolumns = ["class"]\n`);
  assert.equal(state, 'failed');
  assert.match(message, /numbers|drawn/);
  await page.close();
});

test('the slider of a followed number goes along the family', async () => {
  const page = await open(makePage(shippedCase('fold.toml')));
  const { runs } = await over(page, 1);
  const slider = page.locator('input[type=range][data-key="nu"]');
  await slider.press('Home');
  const first = Number((await cells(page)).nu1);
  for (let k = 0; k < 100; ++k) await slider.press('ArrowRight');
  assert.ok(Number((await cells(page)).nu1) > first);
  assert.equal(await runsOf(page), runs);
  await page.close();
});

test('each key moves the slider of a narrow range', async () => {
  const page = await open(makePage(shippedCase('tilted.toml')));
  await over(page, 1);
  const slider = page.locator('input[type=range][data-key="nu"]');
  const before = Number(await slider.inputValue());
  for (let k = 0; k < 5; ++k) await slider.press('ArrowRight');
  assert.equal(Number(await slider.inputValue()), before + 5);
  assert.match(page.url(), /row=/);
  await page.close();
});

test('sliders are not cut off on the narrowest screen', async () => {
  const page = await open(makePage(shippedCase('fold.toml')), { viewport: { width: 320, height: 600 } });
  await over(page, 1);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
  await page.close();
});

test('what is solved has the number that the slider of the followed one shows', async () => {
  const page = await open(makePage(shippedCase('fold.toml')));
  await over(page, 1);
  await showTable(page);
  const field = page.locator('input[type=number][data-key="nu"]');
  await field.fill('0.3');
  await field.press('Tab');
  await page.click('[data-task=solve]');
  await over(page, 2);
  assert.equal(await page.textContent('#live-csv'), run('solve', shippedCase('fold.toml'), '--set', 'motion.nu=0.3', '-o', '-', '--quiet').out, 'nu');
  // The family is the case's own again.
  await page.click('[data-task=follow]');
  assert.equal((await over(page, 3)).state, 'done');
  assert.equal(await page.locator('#events li').count(), 4);
  await page.close();
});

test('the strength of gravity has a slider where the case tells it by a density', async () => {
  const page = await open(makePage(shippedCase('jacobi.toml')));
  await over(page, 1);
  await showTable(page);
  await page.click('[data-task=solve]');
  const { runs } = await over(page, 2);
  const field = page.locator('input[type=number][data-key="gravity.g"]');
  await field.fill('4.1');
  await field.press('Tab');
  const { state, message } = await over(page, runs + 1);
  assert.equal(state, 'done', message);
  assert.equal(await page.textContent('#live-csv'), run('solve', shippedCase('jacobi.toml'), '--set', 'gravity={ g = 4.1 }', '-o', '-', '--quiet').out, 'g');
  await page.close();
});

test('a slider whose number follows from one that moved goes with it', async () => {
  const page = await open(makePage(shippedCase('jacobi.toml')));
  await over(page, 1);
  await showTable(page);
  await page.click('[data-task=solve]');
  const { runs } = await over(page, 2);
  const g = page.locator('input[type=number][data-key="gravity.g"]');
  const before = await g.inputValue();
  const told = () => page.getAttribute('input[type=range][data-key="gravity.g"]', 'aria-valuetext');
  const toldBefore = await told();
  const inertia = page.locator('input[type=number][data-key="body.J.0"]');
  await inertia.fill('1.1');
  await inertia.press('Tab');
  await over(page, runs + 1);
  const path = write('heavier.csv', '');
  run('solve', shippedCase('jacobi.toml'), '--set', 'body.J.0=1.1', '-o', path, '--quiet');
  const { gravity } = JSON.parse(readFileSync(path.replace(/\.csv$/, '.meta.json'), 'utf8')).case;
  assert.notEqual(await g.inputValue(), before);
  assert.equal(Number(await g.inputValue()), gravity.g);
  assert.notEqual(await told(), toldBefore);
  assert.equal(await page.textContent('#live-csv'), readFileSync(path, 'utf8'), 'heavier');
  await page.close();
});

test('all solutions are found, with what is proven of them', async () => {
  const page = await open(makePage(shippedCase('fold.toml')));
  await over(page, 1);
  await showTable(page);
  await page.click('[data-task=all]');
  const { state, message } = await over(page, 2);
  assert.equal(state, 'done');
  const there = run('solve', shippedCase('fold.toml'), '--set', 'solve.all=true', '-o', '-', '--quiet');
  assert.equal(await page.textContent('#live-csv'), there.out, 'all');
  assert.match(message, /proven|complete|every/i);
  await page.close();
});

test('a table computes its own case, and goes on from a row', async () => {
  const path = table('fold.csv', 'continue', shippedCase('fold.toml'));
  const page = await open(makePage(path));
  assert.equal(await page.locator('#live').getAttribute('open'), null);
  await page.click('#live > summary');
  const { state, message, runs } = await over(page, 1);
  assert.equal(state, 'done', message);
  assert.equal(await page.$eval('#tables', (tables) => tables.selectedOptions[0].textContent), 'computed here');
  await page.selectOption('#tables', '0');
  await page.evaluate(() => document.querySelectorAll('#row-part details').forEach((each) => (each.open = true)));
  await page.click('#go-live');
  assert.equal((await over(page, runs + 1)).state, 'done');
  assert.match(await page.inputValue('#live-case'), /start = \[/);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('a link to what was computed in a page opens that page as it is made', async () => {
  const path = makePage(table('fold.csv', 'continue', shippedCase('fold.toml')));
  const page = await open(path);
  const first = await cells(page);
  await page.click('#live > summary');
  await over(page, 1);
  await page.locator('#plot').press('End');
  const fragment = new URL(page.url()).hash;
  assert.match(fragment, /table=2.*row=/);
  const again = await open(path, { fragment });
  assert.deepEqual(await cells(again), first);
  await again.close();
  await page.close();
});

test('the panel, opened again, takes the case of the table that is shown by then', async () => {
  const page = await open(makePage(['fold', 'tilted'].map((name) => table(`${name}.csv`, 'continue', shippedCase(`${name}.toml`)))));
  const title = async () => /^title = (.*)$/m.exec(await page.inputValue('#live-case'))[1];
  await page.click('#live > summary');
  const { runs } = await over(page, 1);
  assert.match(await title(), /fold/);
  await page.click('#live > summary');
  await page.selectOption('#tables', '1');
  await page.click('#live > summary');
  assert.equal((await over(page, runs + 1)).state, 'done');
  assert.match(await title(), /Tilted/);
  // What was changed in it stays while the same table, or what came of it, is shown.
  await page.getByText('The case', { exact: true }).click();
  await page.fill('#live-case', (await page.inputValue('#live-case')).replace('Tilted', 'Changed'));
  for (let k = 0; k < 2; ++k) await page.click('#live > summary');
  await page.selectOption('#tables', '1');
  for (let k = 0; k < 2; ++k) await page.click('#live > summary');
  await page.waitForTimeout(200);
  assert.match(await title(), /Changed/);
  await page.close();
});

test('what takes long can be given up, and the page goes on', async () => {
  const long = `${readFileSync(shippedCase('compressible_sphere.toml'), 'utf8').replace(/\[continuation\][^[]*/, '')}\n[solve]\nall = true\n`;
  const page = await open(makePage(shippedCase('two_polar.toml')));
  await over(page, 1);
  const seen = await page.evaluate(async (given) => {
    const { dataset } = document.getElementById('live');
    const before = dataset.runs;
    document.getElementById('live-case').value = given;
    document.getElementById('live-use').click();
    const progress = document.getElementById('live-progress');
    while (progress.hidden && dataset.runs === before) await new Promise((next) => setTimeout(next));
    document.getElementById('live-cancel').click();
    return !progress.hidden || `${dataset.state}: ${document.getElementById("live-message").textContent}`;
  }, long);
  assert.equal(seen, true, 'it is over before progress shows');
  assert.equal((await over(page, 2)).state, 'cancelled');
  assert.equal((await compute(page, readFileSync(shippedCase('fold.toml'), 'utf8'))).state, 'done');
  assert.deepEqual(page.complaints, []);
  await page.close();
});

/** The modes' buttons, and what is said of the one that is pressed. */
const modeButtons = (page) => page.$$eval('#modes button', (all) => all.map((each) => ({ number: each.dataset.mode, pressed: each.getAttribute('aria-pressed'), enabled: !each.disabled })));
const modeSaid = async (page, wanted) => {
  await page.waitForFunction((text) => document.getElementById('mode-note').textContent.includes(text), wanted, { timeout: 20_000 });
  return page.textContent('#mode-note');
};

/** Whether two pictures of the body differ in more than a level or two of some pixels. */
const differ = (page, one, other) =>
  page.evaluate(async (sources) => {
    const [a, b] = await Promise.all(sources.map(async (source) => {
      const picture = new Image();
      picture.src = 'data:image/png;base64,' + source;
      await picture.decode();
      const canvas = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
      canvas.drawImage(picture, 0, 0);
      return canvas.getImageData(0, 0, picture.width, picture.height).data;
    }));
    return a.filter((level, k) => Math.abs(level - b[k]) > 24).length;
  }, [one, other]);
const bodyPicture = async (page) => (await page.locator('#body-frame').screenshot()).toString('base64');

test('a mode is animated on the body: by the pointer, by keys, run, stopped and ended', async () => {
  const path = table('fold.csv', 'continue', shippedCase('fold.toml'));
  const row = csv(path).rows.findIndex((each, k) => k > 3 && each.event === '' && each.class === 'stable');
  const wanted = csv(path).rows[row];
  const page = await open(makePage(path), { fragment: `#row=${row + 1}` });
  const buttons = await modeButtons(page);
  assert.equal(buttons.length, [1, 2, 3, 4, 5].filter((k) => wanted[`im${k}`] !== '').length);
  assert.ok(buttons.every((each) => each.enabled && each.pressed === 'false'));
  const still = await bodyPicture(page);
  // Less motion is asked for: a mode stands at its largest until it is run.
  await page.locator('#modes [data-mode="2"]').focus();
  await page.keyboard.press('Enter');
  const said = await modeSaid(page, 'Mode 2: period');
  const period = Number(/period ([\d.]*\d)/.exec(said)[1]);
  assert.ok(Math.abs(period - (2 * Math.PI) / Number(wanted.im2)) < 1e-3 * period, said);
  assert.deepEqual((await modeButtons(page)).map((each) => each.pressed), ['false', 'true', 'false', 'false', 'false'].slice(0, buttons.length));
  assert.equal(await page.textContent('#mode-run'), 'Run the mode');
  const displaced = await bodyPicture(page);
  assert.ok((await differ(page, still, displaced)) > 200);
  await page.waitForTimeout(300);
  assert.equal(await differ(page, displaced, await bodyPicture(page)), 0);
  await page.locator('#mode-run').press('Enter');
  const pictures = [];
  for (let k = 0; k < 4; ++k) {
    await page.waitForTimeout(250);
    pictures.push(await bodyPicture(page));
  }
  let moved = 0;
  for (let k = 1; k < pictures.length; ++k) if ((await differ(page, pictures[k - 1], pictures[k])) > 50) ++moved;
  assert.ok(moved >= 2, `${moved} of 3 pictures moved`);
  assert.equal(await page.textContent('#mode-run'), 'Stop the mode');
  await page.click('#mode-run');
  // Another, from the picture of the spectrum; then none.
  await page.locator('#spectrum .root').first().dispatchEvent('click');
  await modeSaid(page, 'Mode 1: period');
  assert.ok((await page.locator('#spectrum .root.chosen').count()) >= 2);
  await page.click('#mode-reset');
  assert.equal(await page.isVisible('#mode-buttons'), false);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.mode), '1');
  await page.waitForTimeout(100);
  assert.equal(await differ(page, still, await bodyPicture(page)), 0);
  // Another row is another body.
  await page.click('#modes [data-mode="1"]');
  await modeSaid(page, 'Mode 1: period');
  await page.locator('#plot').press('ArrowRight');
  assert.equal(await page.textContent('#mode-note'), '');
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('every mode of every kind of motion has a shape, a growing one says how fast', async () => {
  for (const name of ['tilted.toml', 'two_polar.toml', 'elastic_sphere.toml', 'no_plane.toml', 'heavy_plate.toml', 'oblique.toml', 'mooney_rivlin.toml']) {
    const path = table(`${name}.csv`, 'continue', shippedCase(name));
    const { rows } = csv(path);
    const growing = rows.findIndex((each) => each.event === '' && Number(each.growth) > 0.01);
    const page = await open(makePage(path), { fragment: `#row=${(growing < 0 ? Math.floor(rows.length / 2) : growing) + 1}`, reducedMotion: 'no-preference' });
    const buttons = await modeButtons(page);
    assert.ok(buttons.length >= 3, name);
    for (const { number, enabled } of buttons) {
      if (!enabled) continue;
      await page.click(`#modes [data-mode="${number}"]`);
      const said = await modeSaid(page, `Mode ${number}: `).then(() => page.waitForFunction(() => !document.getElementById('mode-note').textContent.includes('is computed'))).then(() => page.textContent('#mode-note'));
      assert.match(said, /period|grows|decays/, `${name} ${number}`);
      assert.equal(await page.isVisible('#mode-run'), true);
    }
    if (growing >= 0) {
      const mode = await page.$$eval('#modes tr', (all) => all.findIndex((each) => Number(each.children[1].textContent) > 0.01));
      await page.click('#mode-reset');
      await page.click(`#modes [data-mode="${mode + 1}"]`);
      assert.match(await modeSaid(page, 'grows'), /factor e in/);
    }
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
});

test('a page without the solver says why a mode is not shown', async () => {
  const page = await open(makePage(table('fold.csv', 'continue', shippedCase('fold.toml')), '--no-live'));
  await page.click('#modes [data-mode="1"]');
  await modeSaid(page, 'carries no solver');
  assert.equal(await page.isVisible('#mode-buttons'), false);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('a hostile case is text', async () => {
  const hostile = `</script><img src=x onerror="window.caught=1">`;
  const text = readFileSync(shippedCase('fold.toml'), 'utf8').replace(/^title = .*/m, `title = ${JSON.stringify(hostile)}`);
  const page = await openCase(text, '<b>x.toml');
  assert.equal(await page.textContent('#title'), hostile);
  assert.equal(await page.evaluate(() => window.caught), undefined);
  assert.equal(await page.locator('img').count(), 0);
  const wrong = await compute(page, text.replace('hencky', '<img src=x onerror=caught=2>'));
  assert.equal(wrong.state, 'failed');
  assert.ok(wrong.message.includes('<img'));
  assert.equal(await page.locator('img').count(), 0);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('a page without the solver is allowed to compute nothing', async () => {
  const page = await open(makePage(table('fold.csv', 'continue', shippedCase('fold.toml')), '--no-live'));
  assert.equal(await page.isVisible('#live'), false);
  assert.match(await page.textContent('#about-live'), /no solver/);
  const policy = await page.evaluate(() => document.querySelector('meta[http-equiv]').content);
  assert.doesNotMatch(policy, /wasm|blob/);
  assert.ok(readFileSync(makePage(`${folder}/fold.csv`, '--no-live')).length < 400_000);
  await page.close();
});
