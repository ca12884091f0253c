// The page: unpacks what the program put into it, and keeps diagram, body, spectrum, row and address in step.

import { BodyView } from './body/body_view';
import { Diagram } from './diagram/diagram';
import { byId, element, fill } from './dom';
import { markEvent, showEvents } from './diagram/events_list';
import { HeatMap } from './diagram/heat_map';
import { showLegend } from './diagram/legend';
import { LivePanel, type LiveCase } from './live_panel';
import { LiveSolver } from './live_solver';
import { unpack, type Payload, type PayloadTable } from './table/payload';
import { Modes } from './body/modes';
import { showProvenClasses } from './diagram/proven_classes';
import { meaning, shown } from './table/quantities';
import { listenToCopying, rowName, showRow } from './row_panel';
import { rowStart } from './table/row_start';
import { stretchSize } from './table/stretch_size';
import { showSpectrum } from './diagram/spectrum';
import { available, colourings, firstState, fromFragment, mapQuantities, prefersLogarithm, presets, toFragment, type ColourBy, type State } from './table/state';
import { Table } from './table/table';
import { caseAsToml } from './table/toml';

/** Unpacks it when it is first asked for. */
type SolverSource = () => Promise<LiveSolver>;

class Page {
  private readonly tables: Table[];
  private state: State;
  private readonly diagram: Diagram;
  private readonly body = new BodyView();
  private readonly modes: Modes;
  private heat: HeatMap | null = null;
  /** What the choice of the vertical axis says; several quantities may be none of its choices. */
  private choiceOfY = '';
  /** Where the table that was computed here is; null: nothing was. */
  private live: number | null;

  /** solver: the one this page carries; null: none. computed: the one table was computed here. */
  constructor(tables: readonly PayloadTable[], solver: SolverSource | null, computed = false) {
    this.modes = new Modes(this.body, solver);
    this.live = computed ? 0 : null;
    this.tables = tables.map((each) => new Table(each));
    this.state = fromFragment(location.hash, this.tables);
    this.diagram = new Diagram({
      hovered: (row, quantity, x, y) => this.tip(row, quantity, x, y),
      chosen: (row) => this.choose(row),
      zoomed: () => this.remember(),
      key: (event) => this.key(event),
    });
    this.listen();
    this.showTable();
  }

  private get table(): Table {
    return this.tables[this.state.table];
  }

  /** In the place of what was computed before; what is drawn of it, and where, stays as far as it can. */
  showLive(from: PayloadTable): void {
    const table = new Table(from);
    const before = this.live === this.state.table ? this.table : null;
    const old = this.state;
    this.live ??= this.tables.length;
    this.tables[this.live] = table;
    this.state = firstState(this.tables, this.live);
    const { state } = this;
    const known = (name: string): boolean => table.quantities.includes(name);
    if (before && known(old.x) && old.y.length > 0 && old.y.every(known) && (before.rows > 1) === (table.rows > 1)) {
      Object.assign(state, { x: old.x, y: this.sameView(before, table, old.y), colour: old.colour, logarithmic: old.logarithmic, hiddenClasses: old.hiddenClasses });
      if (old.row !== null) this.nearest(before.value(before.parameter, old.row), before.text('sheet', old.row));
    }
    this.fillTables();
    this.showTable();
  }

  /** The quantities shown, or all of a view's that the other table has. */
  private sameView(from: Table, to: Table, y: readonly string[]): string[] {
    const of = (table: Table, names: readonly string[]): string[] => names.filter((name) => table.quantities.includes(name));
    const preset = presets.find((each) => available(from, each) && of(from, each.y).join() === y.join());
    return preset ? of(to, preset.y) : [...y];
  }

  /** Chooses the row nearest to a value of the family's parameter. */
  chooseNear(parameter: string, value: number): void {
    if (this.live === null || this.state.table !== this.live || (parameter !== this.table.parameter && parameter !== 'nu')) return;
    this.nearest(value, this.state.row === null ? '' : this.table.text('sheet', this.state.row));
    this.showChosen(false);
    this.diagram.draw();
    this.remember();
  }

  /** The table that is shown; null: the one that was computed here. */
  get given(): Table | null {
    return this.state.table === this.live ? null : this.table;
  }

  /** The case of the shown table, or the one that goes on from the chosen row. */
  liveCase(ofRow: boolean): LiveCase | null {
    const { table, state } = this;
    const given = table.metadata?.case;
    if (!given) return null;
    return { name: 'case.toml', text: (ofRow && state.row !== null ? rowStart(table, state.row).toml : null) ?? caseAsToml(given) };
  }

  private nearest(value: number, sheet: string): void {
    const { table, state } = this;
    let least = Infinity;
    for (let row = 0; row < table.rows; ++row) {
      const apart = Math.abs(table.value(table.parameter, row) - value) + (table.text('sheet', row) === sheet ? 0 : 1e9);
      if (!(apart < least) || !(table.value('xi', row) > 0)) continue;
      least = apart;
      state.row = row;
    }
  }

  private fillTables(): void {
    fill(byId<HTMLSelectElement>('tables'), this.tables.map((each, k) => ({ id: String(k), label: k === this.live ? 'computed here' : each.file })), String(this.state.table));
    byId('tables-part').hidden = this.tables.length < 2;
  }

  private listen(): void {
    const tables = byId<HTMLSelectElement>('tables');
    this.fillTables();
    tables.addEventListener('change', () => {
      this.state = firstState(this.tables, Number(tables.value));
      this.showTable();
    });
    for (const id of ['axis-of-x', 'axis-of-y', 'colour']) byId(id).addEventListener('change', () => this.readControls());
    byId('log').addEventListener('change', () => this.readControls());
    byId('zoom-in').addEventListener('click', () => this.diagram.zoomBy(1.5));
    byId('zoom-out').addEventListener('click', () => this.diagram.zoomBy(1 / 1.5));
    byId('zoom-all').addEventListener('click', () => this.zoomAll());
    window.addEventListener('hashchange', () => {
      if (location.hash.replace(/^#/, '') === toFragment(this.state, this.tables)) return;
      this.state = fromFragment(location.hash, this.tables);
      tables.value = String(this.state.table);
      this.showTable();
    });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.showTable());
    listenToCopying((text) => this.say(text));
  }

  /** All of it, of another table or another address. */
  private showTable(): void {
    const { table, state } = this;
    this.heat = table.kind === 'map' ? new HeatMap(table) : null;
    byId('title').textContent = table.title;
    document.title = table.title;
    const skipped = (table.metadata?.skipped ?? []).map((each) => [each.quantity, each.why].filter(Boolean).join(': '));
    byId('skipped').replaceChildren(...skipped.map((text) => element('li', {}, text)));
    byId('skipped-part').hidden = skipped.length === 0;
    byId('presets').replaceChildren(
      ...presets
        .filter((each) => available(table, each))
        .map((preset) => {
          const button = element('button', { type: 'button', 'data-preset': preset.id }, preset.label);
          button.addEventListener('click', () => {
            state.x = preset.x ?? table.parameter;
            state.y = preset.y.filter((name) => table.quantities.includes(name));
            state.logarithmic = prefersLogarithm(table, state.y);
            state.zoom = null;
            this.showAxes();
          });
          return button;
        }),
    );
    byId('keys-of-curves').hidden = table.kind === 'map';
    byId('keys-of-maps').hidden = table.kind !== 'map';
    byId('curve-controls').hidden = table.kind !== 'curve';
    const option = (name: string): { id: string; label: string } => ({ id: name, label: this.optionLabel(name) });
    const several = presets.filter((each) => available(table, each) && each.y.length > 1 && each.id !== 'energy-momentum');
    fill(byId('axis-of-x'), table.quantities.map(option), state.x);
    const ordinates = table.kind === 'map' ? mapQuantities(table) : table.quantities;
    fill(byId('axis-of-y'), [...(table.kind === 'curve' ? several.map((each) => ({ id: `:${each.id}`, label: each.label })) : []), ...ordinates.map(option)], '');
    byId('y-name').textContent = table.kind === 'map' ? 'Colour shows' : 'Vertical';
    byId('y-part').hidden = table.kind === 'events';
    fill(byId('colour'), colourings.map((id) => ({ id, label: id })), state.colour);
    showProvenClasses(table);
    showEvents(table, state.row, (row) => this.choose(row));
    this.showAxes();
    this.showChosen(false);
  }

  private optionLabel(name: string): string {
    if (name === 'spin') return 'ν, the spin';
    const { symbol } = meaning(name);
    return symbol === name ? name : `${symbol}  ${name}`;
  }

  private readControls(): void {
    const { state, table } = this;
    const y = byId<HTMLSelectElement>('axis-of-y').value;
    const before = [state.x, ...state.y, state.logarithmic].join();
    if (table.kind === 'curve') state.x = byId<HTMLSelectElement>('axis-of-x').value;
    const several = presets.find((each) => `:${each.id}` === y);
    const ordinates = state.y.join();
    // An address may ask for quantities that no one choice stands for.
    if (y !== this.choiceOfY) {
      if (several) state.y = several.y.filter((name) => table.quantities.includes(name));
      else if (y !== '') state.y = [y];
    }
    state.colour = byId<HTMLSelectElement>('colour').value as ColourBy;
    state.logarithmic = ordinates === state.y.join() ? byId<HTMLInputElement>('log').checked : prefersLogarithm(table, state.y);
    if (table.kind === 'curve' && before !== [state.x, ...state.y, state.logarithmic].join()) state.zoom = null;
    this.showAxes();
  }

  private showAxes(): void {
    const { state, table } = this;
    const preset = presets.find((each) => available(table, each) && each.y.filter((name) => table.quantities.includes(name)).join() === state.y.join());
    byId<HTMLSelectElement>('axis-of-x').value = state.x;
    byId<HTMLSelectElement>('axis-of-y').value = state.y.length > 1 && preset ? `:${preset.id}` : (state.y[0] ?? '');
    this.choiceOfY = byId<HTMLSelectElement>('axis-of-y').value;
    byId<HTMLInputElement>('log').checked = state.logarithmic;
    for (const button of byId('presets').querySelectorAll('button'))
      button.setAttribute('aria-pressed', String(button.dataset['preset'] === preset?.id && state.x === (preset?.x ?? table.parameter)));
    showLegend(table, state, () => this.showAxes());
    this.diagram.show(table, state, this.overlays());
    if (state.row !== null) this.say(this.sentence(state.row));
    this.remember();
  }

  /** Curves of events over the same two parameters as the map. */
  private overlays(): readonly Table[] {
    if (this.table.kind !== 'map') return [];
    return this.tables.filter((each) => each.kind === 'events' && this.table.parameters.every((name) => each.has(name)));
  }

  private zoomAll(): void {
    this.state.zoom = null;
    this.showAxes();
  }

  private choose(row: number): void {
    this.state.row = row;
    this.showChosen(true);
    this.diagram.draw();
    this.remember();
  }

  private showChosen(aloud: boolean): void {
    const { table, state } = this;
    this.body.show(table, state.row);
    showSpectrum(table, state.row, (mode) => this.modes.choose(mode));
    this.modes.show(table, state.row);
    showRow(table, state.row);
    markEvent(state.row);
    const sentence = state.row === null ? '' : this.sentence(state.row);
    if (aloud) this.say(sentence);
    else byId('point').textContent = sentence;
  }

  private sentence(row: number): string {
    const { table, state } = this;
    const verdict = table.text('class', row);
    const names = table.kind === 'map' ? [...table.parameters, ...state.y] : [state.x, ...state.y];
    const values = names.filter((name) => Number.isFinite(table.value(name, row))).map((name) => `${meaning(name === 'spin' ? table.spinColumn(row) : name).symbol} = ${shown(table.value(name, row))}`);
    return `${rowName(table, row)}. ${values.join(', ')}${verdict === '' ? '' : `. ${verdict}`}`;
  }

  /** Read by a screen reader, and shown beneath the diagram. */
  private say(text: string): void {
    byId('point').textContent = text;
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { table, state } = this;
    const done = (): void => event.preventDefault();
    switch (event.key) {
      case '+':
      case '=':
        this.diagram.zoomBy(1.5);
        return done();
      case '-':
        this.diagram.zoomBy(1 / 1.5);
        return done();
      case '0':
        this.zoomAll();
        return done();
      case 'e':
      case 'E': {
        const events = table.events().flatMap((each) => (each.row === null ? [] : [each.row]));
        if (events.length === 0) return;
        const at = state.row ?? -1;
        const next = event.key === 'e' ? (events.find((row) => row > at) ?? events[0]) : ([...events].reverse().find((row) => row < at) ?? events[events.length - 1]);
        this.choose(next);
        return done();
      }
      default:
    }
    const next = this.beside(event.key, event.shiftKey ? 10 : 1);
    if (next === null) return;
    if (next !== state.row) this.choose(next);
    done();
  }

  /** The row that an arrow key goes to: along the sheet, or to the sheet before or after. */
  private beside(key: string, step: number): number | null {
    const { table, state } = this;
    if (table.rows === 0) return null;
    const row = state.row ?? 0;
    if (this.heat) {
      const way = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[key];
      return way ? this.heat.beside(row, way[0], way[1]) : null;
    }
    const at = table.piece(row);
    const piece = table.pieces[at];
    const shownPieces = table.pieces.map((_, k) => k).filter((k) => !state.hidden.has(table.pieces[k].key));
    switch (key) {
      case 'ArrowRight':
        return Math.min(row + step, piece.end - 1);
      case 'ArrowLeft':
        return Math.max(row - step, piece.first);
      case 'Home':
        return piece.first;
      case 'End':
        return piece.end - 1;
      case 'ArrowUp':
      case 'ArrowDown': {
        const other = key === 'ArrowUp' ? [...shownPieces].reverse().find((k) => k < at) : shownPieces.find((k) => k > at);
        if (other === undefined) return row;
        return this.nearestOn(other, table.value(state.x, row));
      }
      default:
        return null;
    }
  }

  private nearestOn(piece: number, x: number): number {
    const { first, end } = this.table.pieces[piece];
    let best = first;
    const distance = (row: number): number => Math.abs(this.table.value(this.state.x, row) - x);
    for (let row = first; row < end; ++row) if (distance(row) < distance(best)) best = row;
    return best;
  }

  private tip(row: number | null, quantity: string, x: number, y: number): void {
    const tip = byId('tip');
    tip.hidden = row === null;
    if (row === null) return;
    const { table, state } = this;
    const names = table.kind === 'map' ? [...table.parameters, ...state.y.filter((name) => name !== 'class')] : [state.x, quantity];
    const bound = table.value('error_bound', row);
    const lines = names.map((name) => {
      const value = table.value(name, row);
      if (!Number.isFinite(value)) return element('div', {}, `${meaning(name).symbol}: ${table.text(name, row) || 'not computed'}`);
      const { symbol, unit } = meaning(name === 'spin' ? table.spinColumn(row) : name);
      const error = stretchSize(table, name, row) * bound;
      const told = Number.isFinite(error) ? `${table.text(name, row)} ± ${error.toExponential(1)}` : shown(value);
      return element('div', {}, element('i', {}, symbol), ` = ${told}${unit === '' || unit === '1' ? '' : ` ${unit}`}`);
    });
    const verdict = table.text('class', row);
    const growth = table.value('growth', row);
    tip.replaceChildren(
      element('b', {}, rowName(table, row)),
      ...lines,
      verdict === '' ? '' : element('div', {}, verdict + (growth > 0 ? `, growth ${shown(Number(growth.toPrecision(6)))} 1/T` : '')),
    );
    const host = byId('plot');
    tip.style.left = `${Math.min(x + 16, host.clientWidth - tip.offsetWidth - 4)}px`;
    tip.style.top = `${y + 18 + tip.offsetHeight > host.clientHeight ? y - tip.offsetHeight - 12 : y + 18}px`;
  }

  /** The address says what is shown, without an entry of the history for each step. */
  private remember(): void {
    const fragment = toFragment(this.state, this.tables);
    if (fragment === location.hash.replace(/^#/, '')) return;
    history.replaceState(null, '', fragment === '' ? location.pathname + location.search : `#${fragment}`);
  }
}

/** The panel that computes, of a page that carries the solver; opened by a person, or by a page of a case. */
function prepareLive(payload: Payload, page: Page | null, solver: SolverSource | null): void {
  const about = byId('about-live');
  const carries = solver !== null;
  about.textContent = carries
    ? `This page computes, too: it carries the solver of stationary ${payload.version}, whose solutions are to the bit the program's.`
    : 'This page carries its tables and no solver: what is shown was computed when it was made.';
  const host = byId<HTMLDetailsElement>('live');
  host.hidden = !carries;
  byId('go-live').hidden = !carries;
  if (!carries) return;
  let shownOn = page;
  let panel: Promise<LivePanel> | null = null;
  const prepared = (): Promise<LivePanel> =>
    (panel ??= solver().then((loaded) => {
      return new LivePanel(loaded, {
        computed: (table) => {
          byId('main').hidden = false;
          if (shownOn) shownOn.showLive(table);
          else shownOn = new Page([table], solver, true);
        },
        near: (parameter, value) => shownOn?.chooseNear(parameter, value),
      });
    }));
  const compute = (given: LiveCase | null): void => {
    if (!given) {
      byId('live-message').textContent = 'This table does not say what case it is of: its metadata were not beside it.';
      host.dataset['state'] = 'failed';
      return;
    }
    prepared().then(
      (ready) => ready.open(given),
      (error: unknown) => {
        byId('live-message').textContent = `Nothing can be computed here: ${error instanceof Error ? error.message : String(error)}. The tables are shown all the same.`;
        host.dataset['state'] = 'failed';
      },
    );
  };
  let begun = false;
  /** Whose case it is. */
  let taken: Table | null = null;
  host.addEventListener('toggle', () => {
    const given = shownOn?.given ?? null;
    if (!host.open || (begun && (given === null || given === taken))) return;
    begun = true;
    taken = given;
    compute(payload.case ? { name: payload.case.file, text: payload.case.text } : (shownOn?.liveCase(false) ?? null));
  });
  byId('go-live').addEventListener('click', () => {
    begun = true;
    taken = shownOn?.given ?? taken;
    host.open = true;
    compute(shownOn?.liveCase(true) ?? null);
    host.scrollIntoView({ block: 'nearest' });
  });
  if (payload.case) host.open = true;
}

function solverSource(): SolverSource | null {
  const packed = byId('solver').textContent ?? '';
  if (packed.trim() === '') return null;
  let loaded: Promise<LiveSolver> | null = null;
  return () => (loaded ??= LiveSolver.unpacked(packed));
}

async function start(): Promise<void> {
  try {
    const payload = await unpack(byId('data').textContent ?? '');
    byId('version').textContent = `stationary ${payload.version}`;
    byId('title').textContent = payload.title;
    byId('main').hidden = payload.tables.length === 0;
    const solver = solverSource();
    const page = payload.tables.length > 0 ? new Page(payload.tables, solver) : null;
    prepareLive(payload, page, solver);
    document.body.dataset['state'] = 'ready';
    performance.mark('ready');
  } catch (error) {
    byId('failure').textContent = error instanceof Error ? error.message : String(error);
    byId('failure').hidden = false;
    byId('page').hidden = true;
    document.body.dataset['state'] = 'failed';
  }
}

void start();
