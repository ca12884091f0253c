// The picture of the documentation: node screenshot.mjs FILE.png, by the target of that name.
import { resolve } from 'node:path';
import { makePage, open, result, start, stop } from './support.mjs';

const into = resolve(process.argv[2]);
await start();
try {
  const page = await open(makePage(result('neo_hookean_atlas.csv'), '--title', 'Every sheet of a neo-Hookean body'), {
    viewport: { width: 1400, height: 1080 },
    fragment: '#zoom=-0.02,1.15,0.3,12',
  });
  await page.screenshot({ path: into });
} finally {
  await stop();
}
