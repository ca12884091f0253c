// Sizes and times of the pages of the shipped atlases, as a table: cmake --build build/release --target page_times
import { readdirSync, statSync } from 'node:fs';
import { csv, makePage, open, result, start, stop } from './support.mjs';

const middle = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

await start();
try {
  console.log('| table | rows | page, kB | opened, ms | drawn again, ms |\n|---|---|---|---|---|');
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
    console.log(`| ${name} | ${csv(result(name)).rows.length} | ${Math.round(statSync(path).size / 1000)} | ${middle(opened).toFixed(0)} | ${middle(again).toFixed(1)} |`);
  }
} finally {
  await stop();
}
