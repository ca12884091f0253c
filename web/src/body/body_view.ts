// The body in space: the ellipsoid that turns about its axis, which stands upright, with its momentum and principal axes.

import { bodyOf, inWords, type Body } from './body';
import { circle, head, shaft, sphere, square, type Mesh } from './body_meshes';
import { fragmentShader, vertexShader } from './body_shaders';
import { byId, element, fitCanvas, styleValue } from '../dom';
import { displacement, growthTime, modeTime, type MovingMode } from './modes';
import { aboutThird, applied, diagonal, identity, inverse, norm, product, sum, scaled, transposed, unit, upright, type Matrix, type Vector } from './matrix';
import { shown } from '../table/quantities';
import type { Table } from '../table/table';

interface Loaded {
  array: WebGLVertexArrayObject;
  count: number;
}

const uniformNames = ['shape', 'normals', 'offset', 'camera', 'kind', 'colour', 'eye', 'material', 'stretch', 'reference', 'strain', 'longer', 'neutral', 'shorter'] as const;
type UniformName = (typeof uniformNames)[number];

/** A colour of the style sheet as the shaders take it. */
function colourOf(name: string): [number, number, number] {
  const value = parseInt(styleValue(name).replace('#', ''), 16);
  return [((value >> 16) & 255) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

export class BodyView {
  private readonly canvas = byId<HTMLCanvasElement>('body');
  private readonly labels = byId('body-labels');
  private readonly gl = this.canvas.getContext('webgl2', { antialias: true, premultipliedAlpha: true, alpha: true });
  private readonly uniforms = new Map<UniformName, WebGLUniformLocation | null>();
  private readonly meshes: { sphere: Loaded; shaft: Loaded; head: Loaded; circle: Loaded; square: Loaded } | null;
  private body: Body | null = null;
  private yaw = 0.6;
  private pitch = 0.38;
  private clock = 0;
  private last: number | null = null;
  private running = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  /** Units of time in a second of the page. */
  private pace = 1;
  private asMass = false;
  private mode: MovingMode | null = null;
  private modeClock = 0;
  modeRuns = false;
  private queued = false;

  constructor() {
    this.meshes = this.gl ? this.prepare(this.gl) : null;
    if (!this.gl) byId('body-note').textContent = 'This browser has no WebGL 2, so the body is not drawn. Its stretches stand in the table.';
    this.listen();
    new ResizeObserver(() => this.queue()).observe(this.canvas);
  }

  show(table: Table, row: number | null): void {
    this.body = row === null ? null : bodyOf(table, row);
    const fastest = table.has('|nu|') ? Math.max(...sample(table.column('|nu|'))) : 1;
    this.pace = fastest > 0 && Number.isFinite(fastest) ? 10 ** Math.round(Math.log10(0.9 / fastest)) : 1;
    const choice = byId<HTMLInputElement>('as-mass');
    choice.disabled = !this.body?.reference;
    const words = this.body ? inWords(this.body) : 'This row has no ellipsoid.';
    this.canvas.setAttribute('aria-label', words + ' Arrow keys turn the view.');
    if (this.gl) byId('body-note').textContent = this.body ? this.caption(this.body) : words;
    this.queue();
  }

  /** Beside the motion of the row; null: none. It runs at once, unless less motion is asked for. */
  showMode(mode: MovingMode | null): void {
    this.mode = mode;
    this.modeRuns = mode !== null && !matchMedia('(prefers-reduced-motion: reduce)').matches;
    // One that grows is first seen at all of its size where it stands.
    const growth = mode ? growthTime(mode) : Infinity;
    this.modeClock = mode && mode.re > 0 && !this.modeRuns ? 0.999 * growth : 0;
    this.last = null;
    if (this.gl && this.body) byId('body-note').textContent = this.caption(this.body);
    this.queue();
  }

  /** Whether it runs, then. */
  runMode(runs: boolean): boolean {
    this.modeRuns = runs && this.mode !== null;
    this.last = null;
    this.queue();
    return this.modeRuns;
  }

  private caption(body: Body): string {
    const [lambda, mu, rho] = body.stretches.map((each) => shown(Number(each.toPrecision(5))));
    const pace = this.shownPace();
    const time = pace === 1 ? '1 s is a unit of time' : `1 s is ${shown(pace)} units of time`;
    const moves = body.turning !== 0 || body.flow !== 0;
    return `λ ${lambda}, μ ${mu}, ϱ ${rho}` + (moves ? '' : body.spinIsTold ? ', at rest' : ', its spin not told') + (moves || this.mode ? `; ${time}` : '');
  }

  /** Units of time in a second: with a mode, those in which a period takes two to five. */
  private shownPace(): number {
    if (!this.mode) return this.pace;
    const wanted = modeTime(this.mode) / 2;
    const ten = 10 ** Math.floor(Math.log10(wanted));
    return ten * (wanted >= 5 * ten ? 5 : wanted >= 2 * ten ? 2 : 1);
  }

  private prepare(gl: WebGL2RenderingContext): BodyView['meshes'] {
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]] as const) {
      const shader = gl.createShader(type);
      if (!shader) return null;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.bindAttribLocation(program, 0, 'place');
    gl.bindAttribLocation(program, 1, 'normal');
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(`the body's shaders: ${gl.getProgramInfoLog(program)}`);
    gl.useProgram(program);
    for (const name of uniformNames) this.uniforms.set(name, gl.getUniformLocation(program, name));
    const load = (mesh: Mesh): Loaded => {
      const array = gl.createVertexArray();
      gl.bindVertexArray(array);
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, mesh.vertices, gl.STATIC_DRAW);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.indices, gl.STATIC_DRAW);
      for (const place of [0, 1]) {
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, 12 * place);
      }
      return { array, count: mesh.indices.length };
    };
    return { sphere: load(sphere()), shaft: load(shaft()), head: load(head()), circle: load(circle()), square: load(square()) };
  }

  private listen(): void {
    const turn = byId<HTMLButtonElement>('turn');
    const name = (): void => {
      turn.textContent = this.running ? 'Stop turning' : 'Turn';
      turn.setAttribute('aria-pressed', String(this.running));
    };
    name();
    turn.addEventListener('click', () => {
      this.running = !this.running;
      this.last = null;
      name();
      this.queue();
    });
    byId<HTMLInputElement>('as-mass').addEventListener('change', (event) => {
      this.asMass = (event.target as HTMLInputElement).checked;
      this.queue();
    });
    for (const id of ['show-axes', 'show-momentum', 'show-unit']) byId(id).addEventListener('change', () => this.queue());
    let from: { x: number; y: number } | null = null;
    this.canvas.addEventListener('pointerdown', (event) => {
      from = { x: event.clientX, y: event.clientY };
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (!from) return;
      this.look(-(event.clientX - from.x) * 0.01, (event.clientY - from.y) * 0.01);
      from = { x: event.clientX, y: event.clientY };
    });
    this.canvas.addEventListener('pointerup', () => (from = null));
    this.canvas.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (!step) return;
      event.preventDefault();
      this.look(step[0], step[1]);
    });
    document.addEventListener('visibilitychange', () => this.queue());
  }

  private look(yaw: number, pitch: number): void {
    this.yaw += yaw;
    this.pitch = Math.min(Math.max(this.pitch + pitch, -1.5), 1.5);
    this.queue();
  }

  private queue(): void {
    if (this.queued) return;
    this.queued = true;
    requestAnimationFrame((now) => {
      this.queued = false;
      const turns = this.running && this.body !== null && (this.body.turning !== 0 || this.body.flow !== 0);
      const moves = (turns || this.modeRuns) && !document.hidden;
      if (moves && this.last !== null) {
        const step = (this.shownPace() * Math.min(now - this.last, 100)) / 1000;
        if (turns) this.clock += step;
        if (this.modeRuns) this.modeClock += step;
      }
      this.last = moves ? now : null;
      this.draw();
      if (moves) this.queue();
    });
  }

  private draw(): void {
    const { gl, meshes, body } = this;
    if (!gl || !meshes) return;
    const { width, height } = fitCanvas(this.canvas);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.labels.replaceChildren();
    if (!body) return;
    const reference: Vector = this.asMass && body.reference ? body.reference : [1, 1, 1];
    const rest = diagonal(...reference);
    const turned = product(aboutThird(body.turning * this.clock), upright(body.axis));
    const extent = Math.max(...body.axes.map((axis) => norm(applied(transposed(product(body.S, rest)), axis))), 1e-9);
    const moved = this.mode ? sum(body.S, displacement(this.mode, this.modeClock)) : body.S;
    const deformed = product(moved, rest);
    const scale = 1 / extent;
    const shape = product(turned, matrixScaled(deformed, scale));

    const distance = 6.2;
    const eye: Vector = [distance * Math.cos(this.pitch) * Math.sin(this.yaw), -distance * Math.cos(this.pitch) * Math.cos(this.yaw), distance * Math.sin(this.pitch)];
    const camera = cameraOf(eye, width / height);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.uniformMatrix4fv(this.at('camera'), true, camera);
    gl.uniform3fv(this.at('eye'), eye);

    this.drawShadow(gl, meshes.square, shape);
    gl.uniform3fv(this.at('longer'), colourOf('--longer'));
    gl.uniform3fv(this.at('neutral'), colourOf('--neutral'));
    gl.uniform3fv(this.at('shorter'), colourOf('--shorter'));
    gl.uniformMatrix3fv(this.at('material'), true, aboutThird(-body.flow * this.clock));
    gl.uniformMatrix3fv(this.at('stretch'), true, deformed);
    gl.uniform3fv(this.at('reference'), reference);
    gl.uniform1f(this.at('strain'), Math.max(...body.stretches.map((each) => Math.abs(Math.log(each))), 1e-3));
    this.drawMesh(gl, meshes.sphere, 0, [1, 1, 1, 1], shape, transposed(inverse(shape)), [0, 0, 0]);

    if (byId<HTMLInputElement>('show-unit').checked) this.drawUnit(gl, meshes.circle, product(turned, matrixScaled(rest, scale)));
    if (byId<HTMLInputElement>('show-axes').checked) {
      const names = ['λ', 'μ', 'ϱ'];
      body.axes.forEach((axis, k) => {
        // What lay along the axis, where a mode has moved it.
        const along = unit(applied(moved, axis));
        const reach = scale * norm(applied(transposed(deformed), along));
        const tip = this.drawArrow(gl, applied(turned, along), reach + 0.24, 0.016, colourOf(`--axis-${k + 1}`));
        this.label(names[k], tip, camera, width, height, `axis-${k + 1}`);
        this.drawArrow(gl, applied(turned, scaled(along, -1)), reach + 0.1, 0.016, colourOf(`--axis-${k + 1}`), false);
      });
    }
    if (byId<HTMLInputElement>('show-momentum').checked && norm(body.momentum) > 0) {
      const up = applied(upright(body.axis), unit(body.momentum));
      const tip = this.drawArrow(gl, up, 1.36, 0.032, colourOf('--momentum'));
      this.label('π', tip, camera, width, height, 'momentum');
    }
  }

  private at(name: UniformName): WebGLUniformLocation | null {
    return this.uniforms.get(name) ?? null;
  }

  private drawMesh(gl: WebGL2RenderingContext, mesh: Loaded, kind: number, colour: readonly number[], shape: Matrix, normals: Matrix, offset: Vector): void {
    gl.uniform1i(this.at('kind'), kind);
    gl.uniform4fv(this.at('colour'), colour);
    gl.uniformMatrix3fv(this.at('shape'), true, shape);
    gl.uniformMatrix3fv(this.at('normals'), true, normals);
    gl.uniform3fv(this.at('offset'), offset);
    gl.bindVertexArray(mesh.array);
    gl.drawElements(kind === 2 ? gl.LINE_LOOP : gl.TRIANGLES, mesh.count, gl.UNSIGNED_SHORT, 0);
  }

  /** Below the body, with the outline of its projection. */
  private drawShadow(gl: WebGL2RenderingContext, mesh: Loaded, shape: Matrix): void {
    const g = product(shape, transposed(shape));
    const l11 = Math.sqrt(g[0]);
    const l21 = g[3] / l11;
    const l22 = Math.sqrt(Math.max(g[4] - l21 * l21, 1e-6));
    gl.depthMask(false);
    this.drawMesh(gl, mesh, 3, [0, 0, 0, 0.3], [l11, 0, 0, l21, l22, 0, 0, 0, 1], identity, [0, 0, -1.3]);
    gl.depthMask(true);
  }

  /** The body before it was deformed, as three circles. */
  private drawUnit(gl: WebGL2RenderingContext, mesh: Loaded, rest: Matrix): void {
    const colour = [...colourOf('--ink'), 0.4];
    for (const plane of [identity, [0, 0, 1, 1, 0, 0, 0, 1, 0] as Matrix, [1, 0, 0, 0, 0, -1, 0, 1, 0] as Matrix])
      this.drawMesh(gl, mesh, 2, colour, product(rest, plane), identity, [0, 0, 0]);
  }

  /** From the middle outwards; returns where its name goes. */
  private drawArrow(gl: WebGL2RenderingContext, direction: Vector, length: number, radius: number, colour: readonly number[], pointed = true): Vector {
    if (!this.meshes) return direction;
    const frame = transposed(upright(direction));
    const tip = pointed ? 4.6 * radius : 0;
    this.drawMesh(gl, this.meshes.shaft, 1, [...colour, 1], product(frame, diagonal(radius, radius, length - tip)), frame, [0, 0, 0]);
    if (pointed) this.drawMesh(gl, this.meshes.head, 1, [...colour, 1], product(frame, diagonal(2.3 * radius, 2.3 * radius, tip)), frame, scaled(direction, length - tip));
    return scaled(direction, length + 0.1);
  }

  private label(text: string, at: Vector, camera: readonly number[], width: number, height: number, kind: string): void {
    const w = camera[12] * at[0] + camera[13] * at[1] + camera[14] * at[2] + camera[15];
    const x = (camera[0] * at[0] + camera[1] * at[1] + camera[2] * at[2] + camera[3]) / w;
    const y = (camera[4] * at[0] + camera[5] * at[1] + camera[6] * at[2] + camera[7]) / w;
    const out = element('span', { class: `body-label ${kind}` }, text);
    out.style.left = `${(0.5 + 0.5 * x) * width}px`;
    out.style.top = `${(0.5 - 0.5 * y) * height}px`;
    this.labels.append(out);
  }
}

/** Some thousand of the values: a maximum of millions need not be exact. */
function sample(values: Float64Array): number[] {
  const step = Math.max(1, Math.floor(values.length / 5000));
  const out = [0];
  for (let k = 0; k < values.length; k += step) if (Number.isFinite(values[k])) out.push(values[k]);
  return out;
}

const matrixScaled = (m: Matrix, by: number): Matrix => m.map((each) => each * by) as unknown as Matrix;

/** Perspective from the eye to the middle, axis 3 upward; row by row. */
function cameraOf(eye: Vector, aspect: number): number[] {
  const back = unit(eye);
  const right = unit([-eye[1], eye[0], 0]);
  const up: Vector = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0]];
  const distance = norm(eye);
  const [near, far] = [distance - 3, distance + 3];
  // A sphere of radius 1.65 fits into the shorter side.
  const focal = (distance / 1.66) * Math.min(1, aspect);
  const row = (v: Vector, by: number): number[] => [v[0] * by, v[1] * by, v[2] * by, 0];
  const a = (far + near) / (far - near);
  const depth = [back[0] * -a, back[1] * -a, back[2] * -a, a * distance - (2 * far * near) / (far - near)];
  return [...row(right, focal / aspect), ...row(up, focal), ...depth.map((each) => each), -back[0], -back[1], -back[2], distance];
}
