// Bundles the page: node build.mjs INTO. INTO/page.html has two places left for the program, @TITLE@ and @DATA@;
// INTO/page_template.cpp is the same as the program embeds it.
//
// What may run is named by its hash in the page's policy, so the template is finished here and the program adds only data.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

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

const bundled = await build({
  entryPoints: [join(here, 'src', 'main.ts')],
  bundle: true,
  format: 'iife',
  target: 'es2022',
  minify: true,
  charset: 'utf8',
  legalComments: 'none',
  metafile: true,
  write: false,
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
  `script-src ${hash(script)}`,
  `style-src ${hash(style)}`,
  'img-src data:',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

for (const [what, text] of [['script', script], ['style', style]])
  if (/<\/(script|style)|<!--/i.test(text)) throw new Error(`the ${what} would end its element`);

// Functions, not texts: a replacement's "$" would mean something.
const page = readFileSync(join(here, 'template.html'), 'utf8')
  .replace('@POLICY@', () => policy)
  .replace('@STYLE@', () => style)
  .replace('@SCRIPT@', () => script)
  .replace('@NOTICES@', () => escaped(notices()));
const address = page.match(/.{0,60}:\/\/.{0,60}/);
if (address) throw new Error(`the page has an address: ${address[0]}`);
const most = 350 * 1024;
if (Buffer.byteLength(page) > most) throw new Error(`the page is larger than ${most} bytes`);
writeFileSync(join(into, 'page.html'), page);

/** Pieces of one literal each, as the program reads them. */
function source(text) {
  const size = 12000;
  const pieces = [];
  for (let at = 0; at < text.length; ) {
    let end = Math.min(at + size, text.length);
    if (end < text.length && /[\uD800-\uDBFF]/.test(text[end - 1])) --end;
    pieces.push(`    R"PAGE(${text.slice(at, end)})PAGE",`);
    at = end;
  }
  if (text.includes(')PAGE"')) throw new Error('the page holds the mark that ends a literal');
  return [
    '// Made of web/ by web/build.mjs.',
    '#include "solver/program/explore/page_template.hpp"',
    '',
    'namespace stationary {',
    'namespace {',
    'constexpr std::string_view pieces[] = {',
    ...pieces,
    '};',
    '}  // namespace',
    'std::span<const std::string_view> page_template() { return pieces; }',
    '}  // namespace stationary',
    '',
  ].join('\n');
}
writeFileSync(join(into, 'page_template.cpp'), source(page));
console.log(`page: ${Buffer.byteLength(page)} bytes, of which script ${Buffer.byteLength(script)} and style ${Buffer.byteLength(style)}`);
