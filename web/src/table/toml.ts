// Cases as TOML: what the metadata say of one, with a row's own numbers in it.

import type { CaseData, CaseValue } from './payload';
import type { Table } from './table';

/** A basic string: every character that TOML does not take as it is becomes an escape. */
export function quoted(text: string): string {
  let out = '';
  for (const each of text) {
    const code = each.codePointAt(0) ?? 0;
    if (each === '"' || each === '\\') out += '\\' + each;
    else if (code < 0x20 || code === 0x7f) out += '\\u' + code.toString(16).padStart(4, '0');
    else out += each;
  }
  return `"${out}"`;
}

const isBare = (key: string): boolean => /^[A-Za-z0-9_-]+$/.test(key);

export function number(value: number): string {
  const text = String(value);
  // TOML asks for a point or an exponent in a number that is no whole one, and JSON has written 1.0 as 1.
  return /[.en]/.test(text) ? text : text + '.0';
}

function inline(value: CaseValue): string {
  if (typeof value === 'string') return quoted(value);
  if (typeof value === 'number') return number(value);
  if (typeof value === 'boolean') return String(value);
  if (Array.isArray(value)) return `[${value.map(inline).join(', ')}]`;
  return `{ ${Object.entries(value).map(([key, each]) => entry(key, each)).join(', ')} }`;
}

/** An entry of a table. */
export const entry = (key: string, value: CaseValue): string => `${isBare(key) ? key : quoted(key)} = ${inline(value)}`;

/** What a dotted key names, "body.J.0" or "potential.plane.mu"; undefined where the case has it not. */
export function get(from: CaseData, key: string): CaseValue | undefined {
  let at: CaseValue | undefined = from;
  for (const part of key.split('.')) at = Array.isArray(at) ? at[Number(part)] : typeof at === 'object' && Object.hasOwn(at ?? {}, part) ? at[part] : undefined;
  return at;
}

/** Sets what a dotted key names, where the case has it. */
function set(into: CaseData, key: string, value: number): boolean {
  if (get(into, key) === undefined) return false;
  const cut = key.lastIndexOf('.');
  const within = cut < 0 ? into : get(into, key.slice(0, cut));
  if (Array.isArray(within)) within[Number(key.slice(cut + 1))] = value;
  else (within as CaseData)[key.slice(cut + 1)] = value;
  return true;
}

/** A case with a row's own numbers. */
export interface RowsCase {
  given: CaseData;
  /** The parameters that name nothing of the case. */
  left: string[];
}

/** The metadata's case with the row's numbers: of a ratio "body.J.1/body.J.0" the first number, the second being the row's. */
export function caseOfRow(table: Table, row: number): RowsCase {
  const given: CaseData = structuredClone(table.metadata?.case ?? {}) as CaseData;
  const inMotion = (key: string): boolean => key === 'nu' || key.startsWith('motion.');
  const plain = table.parameters.filter((key) => !key.includes('/') && !inMotion(key));
  const left = plain.filter((key) => !set(given, key, table.value(key, row)));
  // Where one number is divided by the other, that one comes first.
  const ratios = table.parameters.filter((key) => key.includes('/')).map((key) => [key, ...key.split('/')]);
  while (ratios.length > 0) {
    const free = ratios.findIndex(([, , second]) => !ratios.some(([, first]) => first === second));
    const [[key, first, second]] = ratios.splice(Math.max(free, 0), 1);
    if (inMotion(first)) continue;
    const unit = !inMotion(second) ? get(given, second) : table.has(second) ? table.value(second, row) : get(given, second === 'nu' ? 'motion.nu' : second);
    if (typeof unit !== 'number' || !set(given, first, table.value(key, row) * unit)) left.push(key);
  }
  return { given, left };
}

/** The case as the metadata have it; what is of other commands, or of files beside it, is left out. */
export function caseAsToml(given: CaseData): string {
  const lines = [];
  if (typeof given['title'] === 'string' && given['title'] !== '') lines.push(`title = ${quoted(given['title'])}`);
  for (const part of ['body', 'potential', 'gravity', 'motion', 'solve', 'continuation', 'output']) {
    const section = given[part];
    if (typeof section !== 'object' || Array.isArray(section)) continue;
    const own = Object.entries(section).filter(([key]) => key !== 'start_row');
    if (own.length > 0) lines.push('', `[${part}]`, ...own.map(([key, value]) => entry(key, value)));
  }
  return lines.join('\n') + '\n';
}
