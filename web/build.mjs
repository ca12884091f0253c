// Bundles the page: node build.mjs INTO. INTO/page.html has places left for the program, @TITLE@, @DATA@, @LIVE@ and
// @LIVE_POLICY@; INTO/page_template.cpp is the same as the program embeds it.
//
// What may run is named by its hash in the page's policy, so the template is finished here and the program adds only data.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { literals } from './literals.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const into = process.argv[2] ?? join(here, 'dist');
mkdirSync(into, { recursive: true });

/**
 * d3 names SVG's and other namespaces by texts that are addresses. The page shall hold none, so that anyone sees at once
 * that it asks for nothing: the two that are in use are read from the page's own elements.
 */
const withoutAddresses = {
  name: 'without-addresses',
  setup(of) {
    of.onLoad({ filter: /node_modules\/d3-[a-z-]+\/.*\.m?js$/ }, (found) => ({
      contents: readFileSync(found.path, 'utf8')
        .replaceAll('"http://www.w3.org/2000/svg"', 'document.querySelector("svg").namespaceURI')
        .replaceAll('"http://www.w3.org/1999/xhtml"', 'document.documentElement.namespaceURI')
        .replaceAll(/"http:\/\/www\.w3\.org\/[^"]*"/g, '""'),
      loader: 'js',
    }));
  },
};

const options = { bundle: true, format: 'iife', target: 'es2022', minify: true, charset: 'utf8', legalComments: 'none', write: false };
/** The worker is a script of its own, which the page holds as text. */
const worker = await build({ ...options, entryPoints: [join(here, 'src', 'live_worker.ts')] });
const bundled = await build({
  ...options,
  entryPoints: [join(here, 'src', 'main.ts')],
  metafile: true,
  define: { WORKER_CODE: JSON.stringify(worker.outputFiles[0].text) },
  plugins: [withoutAddresses],
});
const styled = await build({ entryPoints: [join(here, 'src', 'style.css')], minify: true, write: false, charset: 'utf8' });
const script = bundled.outputFiles[0].text.trim();
const style = styled.outputFiles[0].text.trim();

/** The packages that are in the bundle, each with its licence's text. */
function notices() {
  const packages = new Set(
    Object.keys(bundled.metafile.inputs).flatMap((path) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1] ?? []),
  );
  const byLicence = new Map();
  for (const name of [...packages].sort()) {
    const folder = join(here, 'node_modules', name);
    const licence = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
    if (!licence) throw new Error(`${name} has no licence file`);
    const text = readFileSync(join(folder, licence), 'utf8').trim();
    const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    byLicence.set(text, [...(byLicence.get(text) ?? []), `${name} ${version}`]);
  }
  return [...byLicence].map(([text, names]) => `${names.join(', ')}\n\n${text}`).join('\n\n----\n\n');
}

const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
const hash = (text) => `'sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}'`;
const policy = [
  "default-src 'none'",
  `style-src ${hash(style)}`,
  'img-src data:',
  "base-uri 'none'",
  "form-action 'none'",
  // The last, for what a page that computes is allowed besides.
  `script-src ${hash(script)}@LIVE_POLICY@`,
].join('; ');

for (const [what, text] of [['script', script], ['style', style]])
  if (/<\/(script|style)|<!--/i.test(text)) throw new Error(`the ${what} would end its element`);

// Functions, not texts: a replacement's "$" would mean something.
const page = readFileSync(join(here, 'template.html'), 'utf8')
  .replace('@POLICY@', () => policy)
  .replace('@STYLE@', () => style)
  .replace('@SCRIPT@', () => script)
  .replace('@NOTICES@', () => escaped(`${notices()}\n\n----\n\n${readFileSync(join(here, 'notices.txt'), 'utf8').trim()}`));
const address = page.match(/.{0,60}:\/\/.{0,60}/);
if (address) throw new Error(`the page has an address: ${address[0]}`);
const most = 350 * 1024;
if (Buffer.byteLength(page) > most) throw new Error(`the page is larger than ${most} bytes`);
writeFileSync(join(into, 'page.html'), page);

writeFileSync(
  join(into, 'page_template.cpp'),
  literals({ made: 'Made of web/ by web/build.mjs.', header: 'page_template.hpp', function: 'page_template', text: page }),
);
console.log(`page: ${Buffer.byteLength(page)} bytes, of which script ${Buffer.byteLength(script)} and style ${Buffer.byteLength(style)}`);
