// What the program put into the page: the tables, column by column as text, with their metadata; packed as zlib does and
// written in base64.

export interface PayloadColumn {
  name: string;
  /** number: cells apart by commas, empty where nothing was computed; text: a list. */
  kind: 'number' | 'text';
  cells: string | string[];
}

export interface PayloadTable {
  /** The file's name, without its folder. */
  file: string;
  title: string;
  /** The columns that are varied, under their dotted keys. */
  parameters: string[];
  rows: number;
  columns: PayloadColumn[];
  /** As in x.meta.json, without what depends on the run; null: there were none. */
  metadata: Metadata | null;
}

export interface Payload {
  version: string;
  title: string;
  tables: PayloadTable[];
  /** A case that the page opens with, in the place of tables. */
  case?: { file: string; text: string };
}

export interface MetadataEvent {
  event: string;
  sheet?: number;
  point: number | null;
  parameter: number;
  bracket?: [number, number];
  status?: string;
}

/** A stretch of a sheet of one class; the row of an event is of the one that it ends. */
export interface MetadataSegment {
  sheet: number;
  segment: number;
  class: string | null;
}

/** Of a complete atlas: what is proven of every motion of a branch at every ν in [from, to]. */
export interface ProvenInterval {
  branch: string;
  /** Of tilted motions. */
  plane?: string;
  from: number;
  to: number;
  status: string;
  /** How many are of each class. */
  sheets?: { [name: string]: number } | null;
  /** Why nothing is told, and the events that the listed sheets have there. */
  reason?: string;
  events?: string[];
  beyond?: string;
}

export interface Metadata {
  /** What made the table: continue, solve, ... */
  command?: string;
  /** Of solve: what was found, and what is proven of it. */
  message?: string;
  case?: CaseData;
  events?: MetadataEvent[];
  segments?: MetadataSegment[];
  classes?: ProvenInterval[];
  skipped?: { quantity?: string; why?: string }[];
}

export type CaseValue = string | number | boolean | CaseValue[] | { [key: string]: CaseValue };
export type CaseData = { [key: string]: CaseValue };

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const out = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) out[k] = text.charCodeAt(k);
  return out;
}

/** What zlib has packed, of its base64. */
export async function unpackedBytes(base64: string): Promise<ArrayBuffer> {
  const packed = new Blob([bytesOf(base64.trim())]).stream();
  return new Response(packed.pipeThrough(new DecompressionStream('deflate'))).arrayBuffer();
}

/** Throws where the packed text is damaged, with a sentence for the reader. */
export async function unpack(base64: string): Promise<Payload> {
  let text: string;
  try {
    text = new TextDecoder().decode(await unpackedBytes(base64));
  } catch {
    throw new Error('The data in this page are damaged. Make the page again with `stationary explore`.');
  }
  const payload = JSON.parse(text) as Payload;
  for (const table of payload.tables) {
    for (const column of table.columns) {
      const count = typeof column.cells === 'string' ? column.cells.split(',').length : column.cells.length;
      if (count !== table.rows)
        throw new Error(`The data in this page are damaged: the column ${column.name} has ${count} cells, not ${table.rows}.`);
    }
  }
  return payload;
}
