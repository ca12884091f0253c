// What the page asks its solver, and what it is told (web/live/live.cpp).

export interface Request {
  do: 'read' | 'solve' | 'continue' | 'modes';
  /** Of the case, for messages. */
  name: string;
  /** TOML. */
  case: string;
  /** As after --set: key=value. */
  set: string[];
  /** Whose modes: S, nu, of a two-polar motion omega and theta', and s of each mode as [re, im]. */
  row?: { q: number[]; nu: number[]; rates: number[] | null; s: [number, number][] };
}

export interface Parameter {
  key: string;
  value: number;
}

export interface Described {
  code: number;
  messages?: string[];
  title: string;
  motion: string;
  parameters: Parameter[];
  followed: string[];
  range: { parameter: string; from: number; to: number } | null;
}

export interface Computed {
  /** The program's exit code. */
  code: number;
  messages: string[];
  summary?: string;
  /** Of the case as it was set; some follow from others. */
  parameters?: Parameter[];
  /** To the byte what the program would have written. */
  csv?: string;
  metadata?: string;
  /** The table as a page holds it, JSON; null: there is none. */
  page?: string | null;
}

export interface ModeAnswer {
  code: number;
  messages?: string[];
  /** Of each s: D row by row, as [re, im] (solver/solve/mode_shape.hpp); null where s is 0. */
  modes?: ({ s: [number, number]; displacement: [number, number][]; residual: number } | null)[];
}

/** To the worker: the solver once, then requests. */
export type ToWorker = { module: WebAssembly.Module } | { id: number; request: Request };
/** From it. */
export type FromWorker = { id: number; answer: string } | { id: number; fraction: number; doing: string };
