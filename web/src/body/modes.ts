// A mode on the body: its shape comes from the page's solver, for a row of a table holds frequencies alone.

import { bodyOf } from './body';
import type { BodyView } from './body_view';
import { byId } from '../dom';
import type { ModeAnswer } from '../live_protocol';
import type { LiveSolver } from '../live_solver';
import type { Matrix } from './matrix';
import { shown } from '../table/quantities';
import { rowAsToml } from '../table/row_start';
import { markMode } from '../diagram/spectrum';
import type { Table } from '../table/table';

/** Phi = L (S + e Re[D exp((re + i im) t)]), Re D S^-1 of Frobenius norm 1. */
export interface MovingMode {
  re: number;
  im: number;
  real: Matrix;
  imaginary: Matrix;
}

/** A growing mode is shown between this share of its size and all of it, over and over. */
const least = 1 / 8;
/** Of no vector: two modes have met. */
const noVector = 1e-6;
/** How far the largest displacement goes, in strain and turn together: to be seen, not small. */
export const reach = 0.25;

/** A period, or what a growing one is shown for, whichever is shorter. */
export function modeTime(mode: { re: number; im: number }): number {
  const period = mode.im === 0 ? Infinity : (2 * Math.PI) / mode.im;
  return Math.min(period, growthTime(mode));
}

export function growthTime(mode: { re: number }): number {
  return mode.re === 0 ? Infinity : -Math.log(least) / Math.abs(mode.re);
}

/** Of Phi in the body's axes, at a time. */
export function displacement(mode: MovingMode, time: number): Matrix {
  const loop = growthTime(mode);
  const within = Number.isFinite(loop) ? time % loop : 0;
  const size = reach * (mode.re > 0 ? least : 1) * Math.exp(mode.re * within);
  const [c, s] = [size * Math.cos(mode.im * time), size * Math.sin(mode.im * time)];
  return mode.real.map((each, k) => c * each - s * mode.imaginary[k]) as unknown as Matrix;
}

const short = (value: number): string => shown(Number(value.toPrecision(4)));

function inWords(number: number, mode: MovingMode): string {
  const period = mode.im === 0 ? [] : [`period ${short((2 * Math.PI) / mode.im)}`];
  const growth = mode.re === 0 ? [] : [`${mode.re > 0 ? 'grows' : 'decays'} by a factor e in ${short(1 / Math.abs(mode.re))}, shown from ${mode.re > 0 ? 'an eighth to all' : 'all to an eighth'} of its size, again and again`];
  return `Mode ${number}: ${[...period, ...growth].join('; ')}. Displaced by up to ${100 * reach} %, far more than the linear motion is good for.`;
}

/** Chooses, runs, stops and ends the animation of the shown row's modes. */
export class Modes {
  private table: Table | null = null;
  private row: number | null = null;
  private chosen: number | null = null;
  private asked = 0;
  private solver: Promise<LiveSolver> | null = null;

  /** load: the page's solver; null: it carries none. */
  constructor(
    private readonly body: BodyView,
    private readonly load: (() => Promise<LiveSolver>) | null,
  ) {
    byId('mode-run').addEventListener('click', () => this.named(this.body.runMode(!this.body.modeRuns)));
    byId('mode-reset').addEventListener('click', () => {
      const number = this.chosen;
      this.end('');
      if (number !== null) byId('modes').querySelector<HTMLElement>(`[data-mode="${number}"]`)?.focus();
    });
  }

  /** Another row: at rest beside its motion. */
  show(table: Table, row: number | null): void {
    this.table = table;
    this.row = row;
    this.end('');
  }

  choose(number: number): void {
    if (number === this.chosen) this.end('');
    else void this.animate(number);
  }

  private end(text: string): void {
    ++this.asked;
    this.chosen = null;
    this.body.showMode(null);
    markMode(null);
    byId('mode-buttons').hidden = true;
    byId('mode-note').textContent = text;
  }

  private async animate(number: number): Promise<void> {
    const { table, row } = this;
    if (!table || row === null) return;
    if (!this.load) return this.end('This page carries no solver, which the shape of a mode comes from: make it without --no-live, or with a program that has the solver of pages.');
    if (!table.metadata?.case) return this.end('This table does not say what case it is of, so the shapes of its modes are not known: its metadata were not beside it.');
    const asked = ++this.asked;
    byId('mode-note').textContent = `Mode ${number}: its shape is computed.`;
    try {
      const mode = await this.find(table, row, number);
      if (asked !== this.asked || !mode) return;
      if (typeof mode === 'string') return this.end(mode);
      this.chosen = number;
      this.body.showMode(mode);
      this.named(this.body.modeRuns);
      markMode(number);
      byId('mode-buttons').hidden = false;
      byId('mode-note').textContent = inWords(number, mode);
    } catch (error) {
      if (asked === this.asked) this.end(`No shape of a mode is to be had here: ${error instanceof Error ? error.message : String(error)}.`);
    }
  }

  private named(runs: boolean): void {
    byId('mode-run').textContent = runs ? 'Stop the mode' : 'Run the mode';
    byId('mode-run').setAttribute('aria-pressed', String(runs));
  }

  /** A sentence where there is none; null where another was asked for meanwhile. */
  private async find(table: Table, row: number, number: number): Promise<MovingMode | string | null> {
    const solver = await (this.solver ??= this.load!().then((each) => each.another()));
    solver.cancel();
    const modes = table.modes(row);
    const value = (name: string): number => table.value(name, row);
    const twoPolar = table.text('branch', row) === 'two-polar';
    const body = bodyOf(table, row);
    if (!body?.spinIsTold) return 'This row does not tell the motion, so the shapes of its modes are not known.';
    const answer = await solver.ask<ModeAnswer>({
      do: 'modes',
      name: 'row.toml',
      case: rowAsToml(table, row, true),
      set: [],
      row: {
        q: [body.S[1], body.S[0], body.S[4], body.S[8]],
        nu: [...body.nu],
        rates: twoPolar ? [value('omega'), value('theta_dot')] : null,
        s: modes.map(({ re, im }, k): [number, number] => [isTwin(modes, k) ? -re : re, im]),
      },
    });
    if (!answer) return null;
    if (answer.code !== 0 || !answer.modes) return `No shape of a mode is to be had here: ${(answer.messages ?? []).join('; ')}.`;
    const shape = answer.modes[number - 1];
    if (!shape) return `Mode ${number} is a symmetry's: it does not move by itself.`;
    if (!(shape.residual < noVector)) return `Mode ${number} has met another here, and has no shape of its own.`;
    const part = (k: 0 | 1): Matrix => shape.displacement.map((each) => each[k]) as unknown as Matrix;
    return { re: shape.s[0], im: shape.s[1], real: part(0), imaginary: part(1) };
  }
}

/** The second of a quadruple's two: the one that decays. */
function isTwin(modes: readonly { re: number; im: number }[], k: number): boolean {
  const { re, im } = modes[k];
  return re > 0 && im > 0 && modes.slice(0, k).filter((each) => each.re === re && each.im === im).length % 2 === 1;
}
