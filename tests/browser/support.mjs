// What the tests of the page share: the program, the browser, and a page opened as a user would open it.
//
// From the environment: STATIONARY_PROGRAM, STATIONARY_SOURCES, STATIONARY_WEB (where the packages are), CHROMIUM.
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const from = (name) => {
  const value = process.env[name];
  if (!value) throw new Error(`${name} is not set; run these tests by ctest`);
  return value;
};
const program = from('STATIONARY_PROGRAM');
const sources = from('STATIONARY_SOURCES');
const { chromium } = createRequire(join(from('STATIONARY_WEB'), 'package.json'))('playwright-core');

export const folder = mkdtempSync(join(tmpdir(), 'stationary-page-'));
export const result = (name) => join(sources, 'results', name);
export const shippedCase = (name) => join(sources, 'cases', name);

/** The program's exit code and both its streams. */
export function run(...words) {
  const { status, stdout, stderr } = spawnSync(program, words, { encoding: 'utf8', cwd: folder });
  return { code: status, out: stdout, err: stderr };
}

export function write(name, text) {
  const path = join(folder, name);
  writeFileSync(path, text);
  return path;
}

/** A table of the program, made once. */
export function table(name, ...words) {
  const path = join(folder, name);
  if (!existsSync(path)) execFileSync(program, [...words, '-o', path, '--quiet'], { cwd: folder });
  return path;
}

/** The header's names, and the rows as objects of texts. No cell of these tables is quoted. */
export function csv(path) {
  const [header, ...lines] = readFileSync(path, 'utf8').trimEnd().split('\n').map((line) => line.split(','));
  return { header, rows: lines.map((cells) => Object.fromEntries(cells.map((cell, k) => [header[k], cell]))) };
}

let made = 0;
export function makePage(tables, ...options) {
  const path = join(folder, `page${++made}.html`);
  const { code, err } = run('explore', ...[tables].flat(), '-o', path, ...options);
  if (code !== 0) throw new Error(`explore: exit code ${code}: ${err}`);
  return path;
}

let browser;
export async function start() {
  // SwiftShader draws WebGL where there is no graphics card; the sandbox needs a user that is not root.
  const graphics = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
  browser = await chromium.launch({ executablePath: from('CHROMIUM'), args: ['--no-sandbox', ...graphics] });
}
export async function stop() {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}

/**
 * Opens a page from file://. `complaints` gathers all that the browser says of it, and what it asks for elsewhere.
 * options: of the browser's context, and `fragment`.
 */
export async function open(path, { fragment = '', ...options } = {}) {
  const page = await browser.newPage({ viewport: { width: 1400, height: 1000 }, reducedMotion: 'reduce', ...options });
  const complaints = [];
  page.on('console', (message) => complaints.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => complaints.push(`error: ${error.message}`));
  const own = pathToFileURL(path).href;
  page.on('request', (request) => {
    if (!request.url().startsWith(own) && !request.url().startsWith('data:') && !request.url().startsWith('blob:')) complaints.push(`request: ${request.url()}`);
  });
  await page.goto(own + fragment);
  await page.waitForSelector('body[data-state]', { state: 'attached' });
  return Object.assign(page, { complaints });
}

/** The chosen row's cells by column, as texts. */
export const cells = (page) =>
  page.$$eval('#cells tr', (rows) => Object.fromEntries(rows.map((row) => [row.dataset.column, row.querySelector('.cell').textContent])));

/** A CSV row without its empty cells. */
export const filled = (row) => Object.fromEntries(Object.entries(row).filter(([, text]) => text !== ''));

/** How many pixels of an element are of each colour, as it is seen. */
export async function colours(page, selector) {
  const png = (await page.locator(selector).screenshot()).toString('base64');
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
    const counts = new Map();
    for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
    return [...counts.values()].sort((a, b) => b - a);
  }, png);
}

/** Pixels that a canvas of curves has drawn on. */
export const inked = (page) =>
  page.$eval('#curves', (canvas) => {
    // Of a copy: reading the canvas itself would change how the browser draws on it.
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let k = 3; k < data.length; k += 4) if (data[k] > 0) ++count;
    return count;
  });
