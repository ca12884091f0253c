// A row as a case file that goes on from there: what the metadata say of the case, with the row's own parameters, its
// motion, and its S as the start.

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

function number(value: number): string {
  const text = String(value);
  // TOML asks for a point or an exponent in a number that is no whole one, and JSON has written 1.0 as 1.
  return /[.en]/.test(text) ? text : text + '.0';
}

function inline(value: CaseValue): string {
  if (typeof value === 'string') return quoted(value);
  if (typeof value === 'number') return number(value);
  if (typeof value === 'boolean') return String(value);
  if (Array.isArray(value)) return `[${value.map(inline).join(', ')}]`;
  return `{ ${Object.entries(value).map(([key, each]) => `${isBare(key) ? key : quoted(key)} = ${inline(each)}`).join(', ')} }`;
}

/** Sets a dotted key, "body.J.0" or "potential.plane.mu", where the case has it. */
function set(into: CaseData, key: string, value: number): boolean {
  let at: CaseValue | undefined = into;
  const parts = key.split('.');
  const last = parts.pop() ?? '';
  for (const part of parts) at = Array.isArray(at) ? at[Number(part)] : typeof at === 'object' && Object.hasOwn(at, part) ? at[part] : undefined;
  if (Array.isArray(at) && at[Number(last)] !== undefined) at[Number(last)] = value;
  else if (typeof at === 'object' && !Array.isArray(at) && Object.hasOwn(at, last)) at[last] = value;
  else return false;
  return true;
}

/** As the program's reader takes it; the exact texts of the row. */
function motion(table: Table, row: number, own: CaseValue | undefined): [string, string][] {
  const branch = table.text('branch', row);
  const out: [string, string][] = branch === '' ? [] : [['branch', quoted(branch)]];
  if (branch === 'two-polar') {
    const byMomenta = typeof own === 'object' && !Array.isArray(own) && Object.hasOwn(own, 's3');
    for (const name of byMomenta ? ['s3', 'p_theta'] : ['omega', 'theta_dot']) out.push([name, table.text(name, row)]);
    return out;
  }
  const axis = ['i', 'ii', 'iii'].indexOf(branch);
  if (axis >= 0) return [...out, ['nu', table.text(`nu${axis + 1}`, row)]];
  if (branch === 'tilted') {
    const first = table.value('nu1', row) !== 0;
    const second = table.value('nu2', row) !== 0;
    out.push(['plane', first && second ? '"123"' : first ? '"13"' : '"23"']);
  }
  if (table.has('|nu|')) out.push(['nu', number(table.value('|nu|', row))]);
  return out;
}

/** The case as the metadata have it; what is of other commands, or of files beside it, is left out. */
export function caseAsToml(given: CaseData): string {
  const lines = [];
  if (typeof given['title'] === 'string' && given['title'] !== '') lines.push(`title = ${quoted(given['title'])}`);
  for (const part of ['body', 'potential', 'gravity', 'motion', 'solve', 'continuation', 'output']) {
    const section = given[part];
    if (typeof section !== 'object' || Array.isArray(section)) continue;
    const own = Object.entries(section).filter(([key]) => key !== 'start_row');
    if (own.length > 0) lines.push('', `[${part}]`, ...own.map(([key, value]) => `${isBare(key) ? key : quoted(key)} = ${inline(value)}`));
  }
  return lines.join('\n') + '\n';
}

export function rowAsToml(table: Table, row: number): string {
  const given: CaseData = structuredClone(table.metadata?.case ?? {}) as CaseData;
  const lines = [`# row ${row + 1} of ${table.file.replace(/[\u0000-\u001f\u007f]/g, '?')}`];
  for (const key of table.parameters) {
    const value = table.value(key, row);
    if (key.startsWith('motion.') || key === 'nu' || set(given, key, value)) continue;
    lines.push(`# with ${key} = ${table.text(key, row)}`);
  }
  if (typeof given['title'] === 'string') lines.push(`title = ${quoted(given['title'])}`);
  for (const part of ['body', 'potential', 'gravity']) {
    const section = given[part];
    if (typeof section !== 'object' || Array.isArray(section)) continue;
    lines.push('', `[${part}]`);
    for (const [key, value] of Object.entries(section)) lines.push(`${isBare(key) ? key : quoted(key)} = ${inline(value)}`);
  }
  lines.push('', '[motion]', ...motion(table, row, given['motion']).map(([key, value]) => `${key} = ${value === '' ? '0.0' : value}`));
  const start = ['alpha', 'xi', 'zeta', 'rho'].map((name) => table.text(name, row));
  if (start.every((each) => each !== '')) lines.push('', '[solve]', `start = [${start.join(', ')}]`);
  const range = given['continuation'];
  if (typeof range === 'object' && !Array.isArray(range)) {
    lines.push('', '[continuation]');
    for (const key of ['parameter', 'from', 'to']) if (Object.hasOwn(range, key)) lines.push(`${key} = ${inline(range[key])}`);
  }
  return lines.join('\n') + '\n';
}
