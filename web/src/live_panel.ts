// The panel that computes: sliders for the numbers of a case, what is done with it, and what came of it.

import { byId, element } from './dom';
import type { Computed, Described, Request } from './live_protocol';
import type { LiveSolver } from './live_solver';
import type { Payload, PayloadTable } from './table/payload';
import { meaning, shown } from './table/quantities';
import { number as tomlNumber } from './table/toml';

type Task = 'follow' | 'solve' | 'all';

export interface LiveCase {
  name: string;
  text: string;
}

export interface Listener {
  /** A table was computed. */
  computed(table: PayloadTable): void;
  /** The spin's slider stands here, and the family is on the page already. */
  near(parameter: string, value: number): void;
}

/** How long a computation goes on after a slider has moved on. */
const patience = 400;
/** How long one may take before its progress is shown. */
const unnoticed = 150;
const steps = 1000;

export class LivePanel {
  private opened: LiveCase = { name: 'case.toml', text: '' };
  private described: Described | null = null;
  private readonly values = new Map<string, number>();
  private readonly moved = new Set<string>();
  /** Puts a slider, by its key, where its number is. */
  private readonly show = new Map<string, (at: number) => void>();
  private task: Task = 'solve';
  /** A button said what is done; before that the case does. */
  private chosen = false;
  private again = false;
  private runs = 0;
  private began = 0;
  private csv = '';

  constructor(
    private readonly solver: LiveSolver,
    private readonly listener: Listener,
  ) {
    for (const button of this.tasks()) {
      button.addEventListener('click', () => {
        this.chosen = true;
        this.setTask(button.dataset['task'] as Task);
        this.compute();
      });
    }
    byId('live-cancel').addEventListener('click', () => {
      this.again = false;
      solver.cancel();
    });
    byId('live-use').addEventListener('click', () => void this.open({ name: this.opened.name, text: byId<HTMLTextAreaElement>('live-case').value }));
    byId('live-save').addEventListener('click', () => this.save());
    byId<HTMLDetailsElement>('live-table').addEventListener('toggle', () => this.showTable());
  }

  /** Reads a case, and computes it. task: what is done with it; else what the case is for. */
  async open(given: LiveCase, task: Task | null = null): Promise<void> {
    this.again = false;
    this.solver.cancel();
    this.began = performance.now();
    this.opened = given;
    byId<HTMLTextAreaElement>('live-case').value = given.text;
    // Until it is read no slider is of this case.
    this.described = null;
    const answer = await this.solver.ask<Described>(this.request('read', []));
    if (!answer) return;
    if (answer.code !== 0) {
      byId('sliders').replaceChildren();
      this.end('failed', (answer.messages ?? []).join('\n'));
      return;
    }
    this.described = answer;
    this.values.clear();
    this.moved.clear();
    this.show.clear();
    this.chosen = false;
    for (const { key, value } of answer.parameters) this.values.set(key, value);
    const follow = this.tasks().find((each) => each.dataset['task'] === 'follow');
    if (follow) follow.disabled = answer.range === null;
    if (answer.range === null) this.setTask(task === 'all' ? 'all' : 'solve');
    else this.setTask(task ?? 'follow');
    byId('sliders').replaceChildren(...answer.parameters.map(({ key, value }) => this.slider(key, value)));
    this.compute();
  }

  private tasks(): HTMLButtonElement[] {
    return [...byId('live-tasks').querySelectorAll('button')];
  }

  private setTask(task: Task): void {
    this.task = task;
    for (const button of this.tasks()) button.setAttribute('aria-pressed', String(button.dataset['task'] === task));
  }

  private request(what: Request['do'], set: string[]): Request {
    return { do: what, name: this.opened.name, case: this.opened.text, set };
  }

  /** As after --set; only what has been moved, so that a case that was not stays as it is written. */
  private settings(): string[] {
    const out = [];
    for (const key of this.moved) {
      if (this.task === 'follow' && key === this.described?.range?.parameter) continue;
      const value = tomlNumber(this.values.get(key) ?? NaN);
      // The case may have pi_G_rho in its place, and takes one of them.
      if (key === 'gravity.g') out.push(`gravity={ g = ${value} }`);
      else out.push(`${key === 'nu' ? 'motion.nu' : key}=${value}`);
      // A body that keeps its symmetry has one number for both.
      if (key === 'body.J.0' && !this.values.has('body.J.1')) out.push(`body.J.1=${value}`);
    }
    if (this.chosen && this.task !== 'follow') out.push(`solve.all=${String(this.task === 'all')}`);
    return out;
  }

  private slider(key: string, value: number): HTMLElement {
    const scale = this.scale(key, value);
    const { symbol, unit, text } = meaning(key);
    const id = `slider-${key.replaceAll('.', '-')}`;
    const range = element('input', { type: 'range', id, min: '0', max: String(steps), step: '1', 'data-key': key });
    const number = element('input', { type: 'number', step: 'any', 'aria-label': `${symbol}, exactly`, 'data-key': key });
    const place = (at: number): void => {
      range.value = String(Math.round(steps * scale.share(at)));
      range.setAttribute('aria-valuetext', `${symbol} = ${shown(at)}${unit === '1' ? '' : ` ${unit}`}`);
    };
    const set = (at: number): void => {
      if (!Number.isFinite(at)) return;
      this.values.set(key, at);
      this.moved.add(key);
      this.changed(key, at);
    };
    const show = (at: number): void => {
      number.value = String(at);
      place(at);
    };
    show(value);
    this.show.set(key, show);
    range.addEventListener('input', () => {
      const at = scale.value(Number(range.value) / steps);
      show(at);
      set(at);
    });
    number.addEventListener('change', () => {
      const at = number.valueAsNumber;
      if (!Number.isFinite(at)) {
        show(this.values.get(key) ?? value);
        return;
      }
      place(at);
      set(at);
    });
    return element('div', { class: 'slider' }, element('label', { for: id, title: text === '' ? key : text }, symbol.replace(/^potential\./, '')), range, number);
  }

  /** Positive numbers by factors, others by differences; the digits a slider gives are few. */
  private scale(key: string, value: number): { value(share: number): number; share(value: number): number } {
    // Four digits, and more where the range is narrow: a step of the slider is one of the number.
    const short = (at: number, step = Infinity): number => {
      const digits = at === 0 ? 4 : Math.ceil(Math.log10(Math.abs(at) / step)) + 1;
      return Number(at.toPrecision(Math.min(Math.max(digits, 4), 17)));
    };
    const spin = key === 'nu' || key.startsWith('motion.');
    if (value > 0 && !spin) {
      const [low, high] = [Math.log(value / 5), Math.log(5 * value)];
      return { value: (share) => short(Math.exp(low + share * (high - low))), share: (at) => (at > 0 ? (Math.log(at) - low) / (high - low) : 0) };
    }
    const range = this.described?.range;
    const size = Math.max(2 * Math.abs(value), 1);
    const [low, high] = spin && range?.parameter === key ? [range.from, range.to] : spin && value >= 0 ? [0, size] : [-size, size];
    return { value: (share) => short(low + share * (high - low), (high - low) / steps), share: (at) => (at - low) / (high - low) };
  }

  private changed(key: string, value: number): void {
    // A family runs through its parameter: another value of it is another point of the same curve.
    if (this.task === 'follow' && key === this.described?.range?.parameter) {
      this.listener.near(key, value);
      return;
    }
    this.compute();
  }

  /** Now, or when what is being computed is done; that is given up where it takes long. */
  private compute(): void {
    if (!this.described) return;
    if (this.solver.busy) {
      this.again = true;
      if (performance.now() - this.began > patience) this.solver.cancel();
      return;
    }
    void this.run();
  }

  private async run(): Promise<void> {
    this.again = false;
    this.began = performance.now();
    const panel = byId('live');
    const bar = byId<HTMLProgressElement>('live-bar');
    panel.dataset['state'] = 'working';
    bar.removeAttribute('value');
    byId('live-doing').textContent = this.task === 'follow' ? 'following the family' : this.task === 'all' ? 'searching for every solution' : 'solving';
    const late = setTimeout(() => (byId('live-progress').hidden = false), unnoticed);
    const answer = await this.solver.ask<Computed>(this.request(this.task === 'follow' ? 'continue' : 'solve', this.settings()), (fraction, doing) => {
      bar.value = fraction;
      byId('live-doing').textContent = doing;
    });
    clearTimeout(late);
    byId('live-progress').hidden = true;
    if (answer) this.answered(answer);
    else this.end('cancelled', 'Given up; the table is what was there before.');
    if (this.again) void this.run();
  }

  private answered(answer: Computed): void {
    const messages = answer.messages.join('\n');
    byId('live-summary').textContent = answer.summary ?? '';
    byId('live-summary-part').hidden = (answer.summary ?? '') === '';
    this.csv = answer.csv ?? '';
    // A number that follows from one that was moved is another now.
    for (const { key, value } of answer.parameters ?? []) {
      if (this.moved.has(key) || this.values.get(key) === value) continue;
      this.values.set(key, value);
      this.show.get(key)?.(value);
    }
    byId('live-result').hidden = this.csv === '';
    this.showTable();
    if (answer.page) {
      const [table] = (JSON.parse(answer.page) as Payload).tables;
      try {
        this.listener.computed(table);
      } catch (error) {
        this.end('failed', `What was computed cannot be drawn: ${error instanceof Error ? error.message : String(error)}`);
        return;
      }
      const proof = table.metadata?.message ?? '';
      const rows = `${table.rows} row${table.rows === 1 ? '' : 's'} in ${shown(Number(((performance.now() - this.began) / 1000).toPrecision(2)))} s`;
      this.end('done', [rows, proof, messages].filter((each) => each !== '').join('. '));
    } else {
      this.end(answer.code === 3 ? 'none' : 'failed', messages);
    }
  }

  private end(state: string, text: string): void {
    byId('live-message').textContent = text;
    byId('live').dataset['state'] = state;
    byId('live').dataset['runs'] = String(++this.runs);
  }

  /** Only where somebody looks: a table may be of megabytes. */
  private showTable(): void {
    byId('live-csv').textContent = byId<HTMLDetailsElement>('live-table').open ? this.csv : '';
  }

  private save(): void {
    const address = URL.createObjectURL(new Blob([this.csv], { type: 'text/csv' }));
    element('a', { href: address, download: 'live.csv' }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
  }
}
