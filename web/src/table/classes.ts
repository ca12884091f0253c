// How classes and events are drawn. Each class has a dash and a width of its own beside its colour; each event a shape.

export interface ClassStyle {
  name: string;
  /** A custom property of the style sheet. */
  colour: string;
  width: number;
  dash: readonly number[];
  text: string;
}

export const classStyles: readonly ClassStyle[] = [
  { name: 'stable', colour: '--stable', width: 3.2, dash: [], text: 'stable (second variation definite)' },
  { name: 'elliptic', colour: '--elliptic', width: 1.5, dash: [], text: 'elliptic (frequencies real, second variation indefinite)' },
  { name: 'unstable', colour: '--unstable', width: 2, dash: [9, 5], text: 'unstable (a real growth rate)' },
  { name: 'oscillatory', colour: '--oscillatory', width: 2, dash: [11, 4, 2, 4], text: 'oscillatory (a growing oscillation)' },
  { name: 'marginal', colour: '--marginal', width: 2.2, dash: [2, 4], text: 'marginal (not decided within the bounds)' },
  { name: '', colour: '--no-class', width: 2, dash: [], text: 'no class computed' },
];

export function classStyle(name: string): ClassStyle {
  return classStyles.find((each) => each.name === name) ?? classStyles[classStyles.length - 1];
}

/** Rates so far as to be no bifurcation: the range asked for ends there. */
export function isEnd(event: string): boolean {
  return ['limit', 'collapse', 'escape', 'domain', 'closed', 'stalled'].includes(event);
}

type Shape = 'disc' | 'ring' | 'square' | 'box' | 'triangle' | 'wedge' | 'diamond' | 'rhomb' | 'star' | 'cross' | 'plus';

const shapes: Record<string, Shape> = {
  'fold-nu': 'disc',
  'fold-parameter': 'disc',
  'fold-momentum': 'ring',
  tilt: 'square',
  oblique: 'box',
  'hamiltonian-hopf': 'triangle',
  'krein-pass': 'wedge',
  ellipse: 'diamond',
  'ellipse-23': 'diamond',
  'ellipse-13': 'diamond',
  shear: 'rhomb',
  'inertia-exchange': 'star',
  'real-collision': 'cross',
  'zero-momentum': 'plus',
  turn: 'disc',
  cusp: 'triangle',
  double: 'star',
  'degenerate-pitchfork': 'diamond',
};

const filled: readonly Shape[] = ['disc', 'square', 'triangle', 'diamond', 'star'];

function outline(shape: Shape, r: number): readonly (readonly [number, number])[] {
  switch (shape) {
    case 'square':
    case 'box':
      return [[-r, -r], [r, -r], [r, r], [-r, r]];
    case 'triangle':
      return [[0, -1.25 * r], [1.1 * r, r * 0.8], [-1.1 * r, r * 0.8]];
    case 'wedge':
      return [[0, 1.25 * r], [1.1 * r, -r * 0.8], [-1.1 * r, -r * 0.8]];
    case 'diamond':
    case 'rhomb':
      return [[0, -1.35 * r], [1.1 * r, 0], [0, 1.35 * r], [-1.1 * r, 0]];
    case 'star':
      return Array.from({ length: 10 }, (_, k) => {
        const angle = (Math.PI * k) / 5 - Math.PI / 2;
        const at = k % 2 === 0 ? 1.5 * r : 0.65 * r;
        return [at * Math.cos(angle), at * Math.sin(angle)] as const;
      });
    default:
      return [];
  }
}

/** Draws an event's mark; ends of curves are small rings. */
export function drawEvent(context: CanvasRenderingContext2D, event: string, x: number, y: number, ink: string, paper: string): void {
  const shape: Shape = isEnd(event) ? 'ring' : (shapes[event] ?? 'cross');
  const r = isEnd(event) ? 2.6 : 4.6;
  context.setLineDash([]);
  context.lineWidth = isEnd(event) ? 1.2 : 1.6;
  context.beginPath();
  if (shape === 'cross') {
    context.moveTo(x - r, y - r);
    context.lineTo(x + r, y + r);
    context.moveTo(x - r, y + r);
    context.lineTo(x + r, y - r);
  } else if (shape === 'plus') {
    context.moveTo(x - 1.3 * r, y);
    context.lineTo(x + 1.3 * r, y);
    context.moveTo(x, y - 1.3 * r);
    context.lineTo(x, y + 1.3 * r);
  } else if (shape === 'disc' || shape === 'ring') {
    context.arc(x, y, r, 0, 2 * Math.PI);
  } else {
    outline(shape, r).forEach(([dx, dy], k) => (k === 0 ? context.moveTo(x + dx, y + dy) : context.lineTo(x + dx, y + dy)));
    context.closePath();
  }
  if (shape !== 'cross' && shape !== 'plus') {
    context.fillStyle = filled.includes(shape) ? ink : paper;
    context.fill();
  }
  context.strokeStyle = filled.includes(shape) ? paper : ink;
  context.stroke();
}
