// Text from outside stays text, and the page's policy lets nothing else run or load.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { cells, makePage, open, result, shippedCase, start, stop, table, write } from './support.mjs';

before(start);
after(stop);

const hostile = `</script><img src=x onerror="window.caught=1"><svg onload="window.caught=2">&lt;'"`;

const mapped = () => write('map.csv', 'branch,xi,energy,status,nu,body.J.1\n' + [1, 2, 3].flatMap((x) => [1, 2].map((y) => `i,1,${x * y},solved,${x},${y}\n`)).join(''));

const untouched = async (page) => {
  assert.equal(await page.evaluate(() => window.caught), undefined);
  assert.equal(await page.locator('img').count(), 0);
  assert.deepEqual(page.complaints, []);
};

test('a hostile title is shown as it is', async () => {
  const path = table('hostile.csv', 'continue', shippedCase('fold.toml'), '--set', `title=${JSON.stringify(hostile)}`);
  const page = await open(makePage(path));
  assert.equal(await page.textContent('#title'), hostile);
  assert.equal(await page.title(), hostile);
  await untouched(page);
  const titled = await open(makePage(result('fold.csv'), '--title', hostile));
  assert.equal(await titled.textContent('#title'), hostile);
  await untouched(titled);
  await page.close();
  await titled.close();
});

test('hostile names of columns, files, sheets and events are text', async () => {
  const quoted = `"${hostile.replaceAll('"', '""')}"`;
  const path = write(`<img src=x onerror=caught=3>.csv`, `branch,sheet,point,event,nu3,xi,zeta,rho,${quoted}\n` +
    `iii,1,0,${quoted},0.1,1,1,1,${quoted}\n${quoted},2,0,,0.2,1,1,1,5\n`);
  const page = await open(makePage([path, result('fold.csv')]));
  assert.equal((await cells(page))[hostile], hostile);
  assert.ok((await page.textContent('#events')).includes(hostile));
  assert.ok((await page.textContent('#legend')).includes(hostile));
  await page.hover('#plot', { position: { x: 70, y: 300 } });
  await untouched(page);
  await page.close();
});

test('a column with the name of an object\'s own member is a column', async () => {
  const path = write('members.csv', 'branch,nu3,xi,zeta,rho,__proto__,constructor,toString\niii,0.1,1,1,1,7,8,9\niii,0.2,1,1,1,7,8,9\n');
  const page = await open(makePage(path), { fragment: '#y=__proto__' });
  assert.equal((await cells(page)).constructor, '8');
  await untouched(page);
  await page.close();
});

test('two thousand fragments of anything leave the page as it is made', async () => {
  const page = await open(makePage([result('neo_hookean_atlas.csv'), result('fold.csv')]));
  const shown = await page.evaluate(async (hostile) => {
    let seed = 24;
    const below = (n) => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      return Math.floor((seed / 2 ** 32) * n);
    };
    const any = (list) => list[below(list.length)];
    const keys = ['x', 'y', 'row', 'table', 'zoom', 'hidden', 'classes', 'colour', 'log', 'case', '__proto__', 'constructor', ''];
    const values = ['', '0', '1', '-1', '1e9', '1e308', 'NaN', 'nu', 'xi', 'lambda,mu', '__proto__', 'toString', 'stable', 'class',
      '0,1,2', '0,0,0,0', '1,0,1,0', '0.5,1.2,0.01,100', '-Infinity,Infinity,0,1', '0,1,0,1e-320', '-1e308,1e308,0,1', '%', '%E0%A4%A', '%00', '\u{1F600}', hostile, 'a'.repeat(3000)];
    for (let k = 0; k < 2000; ++k) {
      const parts = [];
      for (let n = below(5); n >= 0; --n) parts.push(below(4) ? `${any(keys)}=${any(values)}` : any(values));
      history.replaceState(null, '', `#${parts.join(any(['&', '&', '&&', ';', '#']))}`);
      window.dispatchEvent(new HashChangeEvent('hashchange'));
      if (k % 50 === 0) await new Promise((done) => requestAnimationFrame(done));
    }
    history.replaceState(null, '', '#');
    window.dispatchEvent(new HashChangeEvent('hashchange'));
    return document.querySelectorAll('#legend *').length;
  }, hostile);
  assert.ok(shown > 0);
  await untouched(page);
  await page.close();
});

test('a zoom that cannot be drawn is none, and one that can is', async () => {
  const page = await open(makePage([result('fold.csv'), mapped()]));
  const shown = async (zoom, table) => {
    await page.evaluate((to) => (location.hash = to), `#table=${table}&zoom=${zoom}`);
    await page.waitForFunction((to) => document.getElementById('tables').value === to, String(table - 1));
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    await page.hover('#plot', { position: { x: 300, y: 200 } });
    await untouched(page);
    return [await page.textContent('#axis-x'), await page.textContent('#axis-y')];
  };
  for (const table of [1, 2]) {
    const all = await shown('', table);
    for (const zoom of ['0,1,0,1e-320', '-1e308,1e308,0,1', '0,1e-310,0,1', '0,1,-1e308,1e308', '1,1.0000000000000002,0,1', '0,1,1e300,1.0000000000000002e300', '0,Infinity,0,1'])
      assert.deepEqual(await shown(zoom, table), all, zoom);
    for (const zoom of ['0,1,0,1e-200', '-1e200,1e200,0,1', '0,1,1,1.00000000001', '1e-240,1e240,1e-240,1e240', '1e-249,2e-249,-9e249,9e249'])
      assert.notDeepEqual(await shown(zoom, table), all, zoom);
  }
  await page.close();
});

test('the policy runs no other script, evaluates no text, loads nothing', async () => {
  const page = await open(makePage(result('fold.csv')));
  const found = await page.evaluate(async () => {
    const blocked = [];
    document.addEventListener('securitypolicyviolation', (event) => blocked.push(event.effectiveDirective));
    const script = document.createElement('script');
    script.textContent = 'window.caught = 4';
    document.body.append(script);
    const image = document.createElement('img');
    image.src = 'http://127.0.0.1:9/x.png';
    document.body.append(image);
    const style = document.createElement('style');
    style.textContent = 'body { display: none }';
    document.head.append(style);
    const fetched = await fetch('http://127.0.0.1:9/').then(() => true, () => false);
    await new Promise((done) => setTimeout(done, 100));
    return { blocked, fetched, caught: window.caught };
  });
  assert.equal(found.caught, undefined);
  assert.equal(found.fetched, false);
  for (const directive of ['script-src-elem', 'img-src', 'style-src-elem', 'connect-src']) assert.ok(found.blocked.includes(directive), directive);
  const evaluated = await page.evaluate(() => document.querySelector('meta[http-equiv]').content);
  assert.doesNotMatch(evaluated, /'unsafe-/);
  await page.close();
});
