// Sizes and times of pages, as tables: of the shipped atlases, and of the solver in them.
// cmake --build build/release --target page_times
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';
import { csv, makePage, open, result, shippedCase, start, stop } from './support.mjs';

const middle = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
const kB = (bytes) => Math.round(bytes / 1000);

/** From a slider's move to the page drawn, in the page's own time. */
async function dragged(name, key) {
  const page = await open(makePage(shippedCase(name)));
  await page.waitForSelector('#live[data-state=done]', { timeout: 60_000 });
  const times = await page.evaluate(async (of) => {
    const live = document.getElementById('live');
    const slider = document.querySelector(`input[type=range][data-key="${of}"]`);
    const out = [];
    for (let k = 0; k < 21; ++k) {
      const runs = live.dataset.runs;
      const begin = performance.now();
      slider.value = String(Number(slider.value) + (k % 2 === 0 ? 5 : -5));
      slider.dispatchEvent(new Event('input'));
      while (live.dataset.runs === runs) await new Promise((next) => setTimeout(next));
      out.push(performance.now() - begin);
    }
    return out;
  }, key);
  const rows = await page.$eval('#live-message', (line) => Number.parseInt(line.textContent, 10));
  await page.close();
  return { rows, time: middle(times) };
}

await start();
try {
  console.log('| table | rows | page, kB | without the solver, kB | opened, ms | drawn again, ms |\n|---|---|---|---|---|---|');
  for (const name of readdirSync(result('')).filter((each) => each.endsWith('_atlas.csv'))) {
    const path = makePage(result(name));
    const opened = [];
    let again = [];
    for (let k = 0; k < 5; ++k) {
      const page = await open(path);
      opened.push(await page.evaluate(() => performance.getEntriesByName('ready')[0].startTime));
      again = await page.evaluate(() =>
        Array.from({ length: 21 }, (_, step) => {
          const begin = performance.now();
          document.getElementById('plot').dispatchEvent(new KeyboardEvent('keydown', { key: step % 2 === 0 ? '+' : '-' }));
          return performance.now() - begin;
        }),
      );
      await page.close();
    }
    console.log(`| ${name} | ${csv(result(name)).rows.length} | ${kB(statSync(path).size)} | ${kB(statSync(makePage(result(name), '--no-live')).size)} | ${middle(opened).toFixed(0)} | ${middle(again).toFixed(1)} |`);
  }
  const solver = join(process.env.STATIONARY_WEB, 'live', 'solver.wasm');
  const code = readFileSync(solver);
  const packed = deflateSync(code, { level: 9 }).length;
  console.log(`\n| the solver | kB |\n|---|---|\n| WebAssembly | ${kB(code.length)} |\n| packed | ${kB(packed)} |\n| in a page | ${kB((4 * packed) / 3)} |`);
  console.log('\n| a slider moves: followed and drawn again | rows | ms |\n|---|---|---|');
  for (const [name, key] of [['fold.toml', 'body.J.1'], ['neo_hookean.toml', 'body.J.1'], ['tilted.toml', 'body.J.0'], ['two_polar.toml', 'body.J.2']]) {
    const { rows, time } = await dragged(name, key);
    console.log(`| ${name}, ${key} | ${rows} | ${time.toFixed(0)} |`);
  }
} finally {
  await stop();
}
