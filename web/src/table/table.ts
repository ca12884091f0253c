// A table of the program, by columns: exact texts beside their values, connected pieces, and what is derived of columns.

import type { Metadata, MetadataEvent, PayloadTable } from './payload';
import { caseOfRow } from './toml';

/** Rows of one branch and sheet, in a row: from first up to, and without, end. */
export interface Piece {
  first: number;
  end: number;
  branch: string;
  sheet: string;
  key: string;
}

export interface TableEvent {
  event: string;
  row: number | null;
  sheet: string;
  parameter: number;
  note: string;
}

export type Kind = 'curve' | 'map' | 'events';

const spins = ['nu1', 'nu2', 'nu3'] as const;

export class Table {
  readonly file: string;
  readonly title: string;
  readonly kind: Kind;
  readonly rows: number;
  readonly names: readonly string[];
  /** The columns that are varied. */
  readonly parameters: readonly string[];
  readonly metadata: Metadata | null;
  readonly pieces: readonly Piece[];
  /** Ids of what an axis can show. */
  readonly quantities: readonly string[];
  private readonly texts = new Map<string, readonly string[]>();
  private readonly values = new Map<string, Float64Array>();
  private readonly pieceOf: Int32Array;

  constructor(from: PayloadTable) {
    this.file = from.file;
    this.title = from.title;
    this.rows = from.rows;
    this.metadata = from.metadata;
    this.names = from.columns.map((each) => each.name);
    this.parameters = from.parameters;
    for (const column of from.columns) {
      const cells = typeof column.cells === 'string' ? column.cells.split(',') : column.cells;
      this.texts.set(column.name, cells);
      if (column.kind === 'number') this.values.set(column.name, Float64Array.from(cells, (each) => (each === '' ? NaN : Number(each))));
    }
    const overTwo = this.parameters.length === 2;
    this.kind = overTwo && this.texts.has('status') ? 'map' : overTwo && this.texts.has('curve') ? 'events' : 'curve';
    this.pieces = this.findPieces();
    this.pieceOf = new Int32Array(this.rows);
    this.pieces.forEach((piece, k) => this.pieceOf.fill(k, piece.first, piece.end));
    this.derive();
    this.quantities = this.listQuantities();
  }

  has(name: string): boolean {
    return this.texts.has(name) || this.values.has(name);
  }

  /** The cell as it stands in the file; empty where there is none. */
  text(name: string, row: number): string {
    return this.texts.get(name)?.[row] ?? '';
  }

  /** What is marked at a row: its event; on the curve of an event, where every row is one, what is special there. */
  mark(row: number): string {
    return this.text(this.kind === 'events' ? 'special' : 'event', row);
  }

  value(name: string, row: number): number {
    return this.values.get(name)?.[row] ?? NaN;
  }

  column(name: string): Float64Array {
    return this.values.get(name) ?? new Float64Array(this.rows).fill(NaN);
  }

  piece(row: number): number {
    return this.pieceOf[row];
  }

  /** The column that the family runs in. */
  get parameter(): string {
    return this.parameters[this.parameters.length - 1] ?? ['spin', ...spins, 'omega'].find((name) => this.quantities.includes(name)) ?? this.quantities[0];
  }

  /** Inertia of a row: the case's, with the row's own parameters; null: the table does not say. */
  inertia(row: number): [number, number, number] | null {
    const body = caseOfRow(this, row).given['body'] as { J?: unknown } | undefined;
    const J = Array.isArray(body?.J) ? body.J.map(Number) : [NaN, NaN, NaN];
    for (let k = 0; k < 3; ++k) {
      const own = this.value(`body.J.${k}`, row);
      if (Number.isFinite(own)) J[k] = own;
    }
    return J.length === 3 && J.every((each) => each > 0) ? [J[0], J[1], J[2]] : null;
  }

  /** Where a row has a spectrum: one representative of each pair, with its signature (null: not certain). */
  modes(row: number): { re: number; im: number; krein: number | null }[] {
    const out = [];
    for (let k = 1; k <= 5; ++k) {
      const [re, im] = [this.value(`re${k}`, row), this.value(`im${k}`, row)];
      if (!Number.isFinite(re) || !Number.isFinite(im)) continue;
      const krein = this.value(`krein${k}`, row);
      out.push({ re, im, krein: Number.isFinite(krein) ? krein : null });
    }
    return out;
  }

  /** The located events (of curves of events where each begins, and what is special on it), and those of the metadata that have no row. */
  events(): TableEvent[] {
    const out: TableEvent[] = [];
    for (let row = 0; row < this.rows; ++row) {
      const begins = this.kind === 'events' && this.pieces[this.piece(row)].first === row;
      const event = this.mark(row) || (begins ? this.text('event', row) : '');
      if (event === '') continue;
      out.push({ event, row, sheet: this.text('sheet', row) || this.text('curve', row), parameter: this.value(this.parameter, row), note: '' });
    }
    for (const each of this.metadata?.events ?? []) {
      if (each.point !== null || !Array.isArray(each.bracket)) continue;
      out.push({ event: each.event, row: null, sheet: String(each.sheet ?? ''), parameter: each.parameter, note: unlocated(each) });
    }
    return out;
  }

  private findPieces(): Piece[] {
    const out: Piece[] = [];
    for (let row = 0; row < this.rows; ++row) {
      const branch = this.text('branch', row);
      const sheet = this.text('sheet', row) || this.text('curve', row);
      const last = out[out.length - 1];
      if (last && last.branch === branch && (this.kind === 'map' || last.sheet === sheet)) {
        last.end = row + 1;
      } else {
        out.push({ first: row, end: row + 1, branch, sheet, key: `${branch}.${sheet}` });
      }
    }
    return out;
  }

  /** spin: the family's nu; |nu|, |pi|: sizes of vectors. */
  private derive(): void {
    const norm = (names: readonly string[]): Float64Array => {
      const parts = names.map((name) => this.column(name));
      return Float64Array.from({ length: this.rows }, (_, row) => Math.hypot(...parts.map((each) => each[row])));
    };
    if (spins.every((name) => this.values.has(name))) {
      this.values.set('|nu|', norm(spins));
      this.values.set('spin', Float64Array.from({ length: this.rows }, (_, row) => this.spin(row)));
    }
    const momenta = ['pi1', 'pi2', 'pi3'];
    if (momenta.every((name) => this.values.has(name))) this.values.set('|pi|', norm(momenta));
  }

  /** As `plot` has it: along the axis; |nu| of an axis oblique or tilted, negative for its mirror image; omega if two-polar. */
  private spin(row: number): number {
    const axis = ['i', 'ii', 'iii'].indexOf(this.text('branch', row));
    if (axis >= 0) return this.value(spins[axis], row);
    if (this.text('branch', row) === 'two-polar') return this.value('omega', row);
    const nu = spins.map((name) => this.value(name, row));
    return nu.every((each) => each <= 0) ? -Math.hypot(...nu) : Math.hypot(...nu);
  }

  /** What the spin of a row is. */
  spinColumn(row: number): string {
    return this.text('branch', row) === 'two-polar' ? 'omega' : 'nu';
  }

  private listQuantities(): string[] {
    const first = [...this.parameters].reverse();
    if (this.values.has('spin')) first.push('spin');
    const all = [...first, ...this.values.keys()].filter((name, k, list) => list.indexOf(name) === k);
    return all.filter((name) => this.column(name).some((each) => Number.isFinite(each)));
  }
}

function unlocated(event: MetadataEvent): string {
  const [a, b] = event.bracket ?? [NaN, NaN];
  return `${event.status ?? 'not located'}, between ${a} and ${b}`;
}
