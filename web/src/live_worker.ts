// The page's worker: runs the solver, so that the page is never kept waiting. Bundled by itself, and started from a Blob.

import type { FromWorker, Request, ToWorker } from './live_protocol';

interface Solver {
  memory: WebAssembly.Memory;
  _initialize(): void;
  live_room(size: number): number;
  live_run(): number;
  live_size(): number;
}

const worker = self as unknown as { postMessage(message: FromWorker): void; onmessage: ((event: MessageEvent<ToWorker>) => void) | null };
let module: WebAssembly.Module | null = null;
let solver: Solver | null = null;
let current = 0;

const textOf = (memory: WebAssembly.Memory, at: number, size: number): string => new TextDecoder().decode(new Uint8Array(memory.buffer, at, size));

/** Of the system a page has a clock; files, arguments and the rest are answered as not there. */
function system(memory: () => WebAssembly.Memory): WebAssembly.ModuleImports {
  const notThere = 52;
  const view = (): DataView => new DataView(memory().buffer);
  const known: Record<string, (...given: never[]) => number> = {
    clock_time_get: (_clock: number, _precision: bigint, at: number) => {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    environ_sizes_get: (count: number, size: number) => {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    proc_exit: (code: number) => {
      throw new Error(`it ended with code ${code}`);
    },
  };
  return new Proxy({}, { get: (_, name) => known[String(name)] ?? ((): number => notThere) }) as WebAssembly.ModuleImports;
}

function started(): Solver {
  if (!module) throw new Error('the solver has not been sent');
  const instance: WebAssembly.Instance = new WebAssembly.Instance(module, {
    wasi_snapshot_preview1: system(() => out.memory),
    page: {
      progress: (fraction: number, at: number, size: number): void => worker.postMessage({ id: current, fraction, doing: textOf(out.memory, at, size) }),
    },
  });
  const out = instance.exports as unknown as Solver;
  out._initialize();
  return out;
}

/** A solver that stopped in the middle is not asked again: the next request has a new one. */
function answer(request: Request): string {
  try {
    solver ??= started();
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const room = solver.live_room(bytes.length);
    new Uint8Array(solver.memory.buffer, room, bytes.length).set(bytes);
    const at = solver.live_run();
    return textOf(solver.memory, at, solver.live_size());
  } catch (error) {
    solver = null;
    return JSON.stringify({ code: 4, messages: [`the solver stopped: ${error instanceof Error ? error.message : String(error)}`] });
  }
}

worker.onmessage = ({ data }): void => {
  if ('module' in data) {
    module = data.module;
    return;
  }
  current = data.id;
  worker.postMessage({ id: data.id, answer: answer(data.request) });
};
