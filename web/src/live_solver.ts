// The solver in its worker, as the page sees it: one request at a time, which can be given up.

import type { FromWorker, Request } from './live_protocol';
import { unpackedBytes } from './table/payload';

/** The worker's code; web/build.mjs puts it here. */
declare const WORKER_CODE: string;

export class LiveSolver {
  private worker: Worker | null = null;
  private last = 0;
  private settle: ((answer: string | null) => void) | null = null;
  private heard: (fraction: number, doing: string) => void = () => undefined;

  private constructor(private readonly module: WebAssembly.Module) {}

  /** Throws where the browser has no WebAssembly, or an old one. */
  static async unpacked(base64: string): Promise<LiveSolver> {
    if (typeof WebAssembly !== 'object') throw new Error('this browser has no WebAssembly, or has it switched off');
    return new LiveSolver(await WebAssembly.compile(await unpackedBytes(base64)));
  }

  /** The same code in a worker of its own, so that neither waits for the other. */
  another(): LiveSolver {
    return new LiveSolver(this.module);
  }

  get busy(): boolean {
    return this.settle !== null;
  }

  /** Its answer; null where it was given up. Not while it is busy. */
  ask<Answer>(request: Request, heard: (fraction: number, doing: string) => void = () => undefined): Promise<Answer | null> {
    const worker = (this.worker ??= this.start());
    this.heard = heard;
    const id = ++this.last;
    return new Promise((settle) => {
      this.settle = (answer) => {
        this.settle = null;
        settle(answer === null ? null : (JSON.parse(answer) as Answer));
      };
      worker.postMessage({ id, request });
    });
  }

  /** Ends what it is doing, at once. */
  cancel(): void {
    if (!this.settle) return;
    this.worker?.terminate();
    this.worker = null;
    this.settle(null);
  }

  private start(): Worker {
    const address = URL.createObjectURL(new Blob([WORKER_CODE], { type: 'text/javascript' }));
    const worker = new Worker(address);
    worker.onmessage = ({ data }: MessageEvent<FromWorker>): void => {
      if (data.id !== this.last) return;
      if ('answer' in data) this.settle?.(data.answer);
      else this.heard(data.fraction, data.doing);
    };
    worker.onerror = (event): void => {
      this.worker = null;
      this.settle?.(JSON.stringify({ code: 4, messages: [`the solver did not start: ${event.message}`] }));
    };
    worker.postMessage({ module: this.module });
    return worker;
  }
}
