// The page without a pointer, without colours, without motion, large, and in the dark.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { makePage, open, result, start, stop } from './support.mjs';

before(start);
after(stop);

const path = () => makePage(result('neo_hookean_atlas.csv'));

test('every control has a name, is reached by Tab, and shows that it is', async () => {
  const page = await open(path());
  const nameless = await page.$$eval('button, select, input, [tabindex="0"]', (controls) =>
    controls.filter((each) => !(each.getAttribute('aria-label') || each.labels?.[0]?.textContent.trim() || each.textContent.trim())).map((each) => each.outerHTML),
  );
  assert.deepEqual(nameless, []);
  const wanted = new Set(['axis-of-x', 'axis-of-y', 'colour', 'log', 'zoom-in', 'zoom-out', 'zoom-all', 'plot', 'body', 'turn', 'show-axes', 'show-momentum', 'show-unit']);
  for (let k = 0; k < 120 && wanted.size > 0; ++k) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const now = document.activeElement;
      const style = getComputedStyle(now);
      return { id: now.id, outline: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2 };
    });
    if (wanted.delete(at.id)) assert.ok(at.outline, at.id);
  }
  assert.deepEqual([...wanted], []);
  await page.close();
});

test('classes differ by dash or width, not by colour alone', async () => {
  const page = await open(path(), { forcedColors: 'none' });
  // The samples of the legend, each as a pattern of where there is ink.
  const patterns = await page.$$eval('#legend input[name^=class] + canvas', (samples) =>
    samples.map((sample) => {
      const { data } = sample.getContext('2d').getImageData(0, 0, sample.width, sample.height);
      return data.filter((_, k) => k % 4 === 3).map((alpha) => (alpha > 127 ? 1 : 0)).join('');
    }),
  );
  assert.ok(patterns.length >= 4);
  assert.equal(new Set(patterns).size, patterns.length);
  await page.close();
});

test('the body turns, and not where motion is to be reduced', async () => {
  // Frames of a body at rest differ by a level of 255 where the compositor rounds otherwise; on a busy
  // machine those that were asked for before are still being drawn for a while.
  const alike = (page, pictures) =>
    page.evaluate(async (sources) => {
      const levels = [];
      for (const source of sources) {
        const picture = new Image();
        picture.src = 'data:image/png;base64,' + source;
        await picture.decode();
        const canvas = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
        canvas.drawImage(picture, 0, 0);
        levels.push(canvas.getImageData(0, 0, picture.width, picture.height).data);
      }
      return levels.every((each) => each.every((level, k) => Math.abs(level - levels[0][k]) <= 2));
    }, pictures);
  const moves = async (page) => {
    const blank = await page.context().browser().newPage(); // no policy that forbids pictures
    const pictures = [];
    let stands = false;
    for (let k = 0; k < 8 && !stands; ++k) {
      pictures.push((await page.locator('#body').screenshot()).toString('base64'));
      stands = k >= 2 && (await alike(blank, pictures.slice(-3)));
      await page.waitForTimeout(300);
    }
    await blank.close();
    return !stands;
  };
  const still = await open(path(), { reducedMotion: 'reduce' });
  assert.equal(await moves(still), false);
  await still.click('#turn');
  assert.equal(await moves(still), true);
  await still.close();
  const turning = await open(path(), { reducedMotion: 'no-preference' });
  assert.equal(await moves(turning), true);
  await turning.click('#turn');
  assert.equal(await moves(turning), false);
  await turning.close();
});

test('at 200 % and on a narrow screen nothing is cut off', async () => {
  // The second has the longest numbers of a spectrum.
  for (const [from, fragment] of [[path(), ''], [makePage(result('oblique.csv')), '#row=138']]) {
    for (const width of [700, 360, 320]) {
      const page = await open(from, { viewport: { width, height: 600 }, fragment });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wide <= 0, `${width}: ${wide} pixels too wide`);
      await page.close();
    }
  }
});

test('text stands out by 4.5 to 1, lines by 3 to 1, in the light and in the dark', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const page = await open(path(), { colorScheme });
    const colours = await page.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      return Object.fromEntries(['ink', 'soft', 'paper', 'ground', 'stable', 'elliptic', 'unstable', 'oscillatory', 'marginal', 'accent'].map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
    });
    const light = (colour) => {
      const [r, g, b] = [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16) / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const contrast = (a, b) => {
      const [high, low] = [light(a), light(b)].sort((x, y) => y - x);
      return (high + 0.05) / (low + 0.05);
    };
    for (const text of ['ink', 'soft']) for (const ground of ['paper', 'ground']) assert.ok(contrast(colours[text], colours[ground]) >= 4.5, `${colorScheme} ${text} on ${ground}`);
    for (const line of ['stable', 'elliptic', 'unstable', 'oscillatory', 'marginal', 'accent']) assert.ok(contrast(colours[line], colours.paper) >= 3, `${colorScheme} ${line}`);
    await page.close();
  }
});
