// What the page asks its solver, and what it is told (web/live/live.cpp).

export interface Request {
  do: 'read' | 'solve' | 'continue';
  /** Of the case, for messages. */
  name: string;
  /** TOML. */
  case: string;
  /** As after --set: key=value. */
  set: string[];
}

export interface Described {
  code: number;
  messages?: string[];
  title: string;
  motion: string;
  parameters: { key: string; value: number }[];
  followed: string[];
  range: { parameter: string; from: number; to: number } | null;
}

export interface Computed {
  /** The program's exit code. */
  code: number;
  messages: string[];
  summary?: string;
  /** To the byte what the program would have written. */
  csv?: string;
  metadata?: string;
  /** The table as a page holds it, JSON; null: there is none. */
  page?: string | null;
}

/** To the worker: the solver once, then requests. */
export type ToWorker = { module: WebAssembly.Module } | { id: number; request: Request };
/** From it. */
export type FromWorker = { id: number; answer: string } | { id: number; fraction: number; doing: string };
