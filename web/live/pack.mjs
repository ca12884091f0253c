// Packs the pages' solver: node pack.mjs SOLVER.wasm INTO.cpp MOST [ZOPFLI]. As zlib does, in base64, as C++ source for the program;
// by Zopfli, where it is there, in a twentieth less.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';
import { literals } from '../literals.mjs';

const [from, into, most, zopfli] = process.argv.slice(2);
const code = readFileSync(from);
const packed = zopfli ? execFileSync(zopfli, ['--zlib', '-c', from], { maxBuffer: code.length }) : deflateSync(code, { level: 9 });
const text = packed.toString('base64');
// With it, the page of the largest atlas is to stay below 3 MB.
if (!(text.length <= Number(most))) throw new Error(`the solver takes ${text.length} bytes of a page, more than ${most}`);
writeFileSync(into, literals({ made: 'Made of web/live by web/live/pack.mjs.', header: 'live_solver.hpp', function: 'live_solver', text }));
console.log(`the solver of pages: ${code.length} bytes, ${text.length} in a page`);
