// What the columns of a table are called and measured in. Units are consistent and of the user's choice: M, L and T stand
// for mass, length and time.

export interface Meaning {
  symbol: string;
  unit: string;
  text: string;
}

const rate = '1/T';
const inertia = 'M L²';
const momentum = 'M L²/T';
const energy = 'M L²/T²';

const meanings: Record<string, Meaning> = {
  branch: { symbol: 'branch', unit: '', text: 'the kind of motion' },
  sheet: { symbol: 'sheet', unit: '', text: 'connected piece of a family' },
  point: { symbol: 'point', unit: '', text: 'row within the sheet' },
  event: { symbol: 'event', unit: '', text: 'the located event' },
  nu1: { symbol: 'ν₁', unit: rate, text: 'spin along material axis 1' },
  nu2: { symbol: 'ν₂', unit: rate, text: 'spin along material axis 2' },
  nu3: { symbol: 'ν₃', unit: rate, text: 'spin along material axis 3' },
  '|nu|': { symbol: '|ν|', unit: rate, text: 'size of the spin' },
  alpha: { symbol: 'α', unit: '1', text: 'S₁₂, shear in the plane' },
  xi: { symbol: 'ξ', unit: '1', text: 'S₁₁' },
  zeta: { symbol: 'ζ', unit: '1', text: 'S₂₂' },
  rho: { symbol: 'ϱ', unit: '1', text: 'S₃₃, the thickness' },
  lambda: { symbol: 'λ', unit: '1', text: 'larger principal stretch of the plane' },
  mu: { symbol: 'μ', unit: '1', text: 'smaller principal stretch of the plane' },
  angle: { symbol: 'θ', unit: 'rad', text: 'from material axis 1 to the axis of λ' },
  pi1: { symbol: 'π₁', unit: momentum, text: 'angular momentum along axis 1' },
  pi2: { symbol: 'π₂', unit: momentum, text: 'angular momentum along axis 2' },
  pi3: { symbol: 'π₃', unit: momentum, text: 'angular momentum along axis 3' },
  '|pi|': { symbol: '|π|', unit: momentum, text: 'size of the angular momentum' },
  energy: { symbol: 'E', unit: energy, text: 'total energy' },
  residual: { symbol: 'residual', unit: '1', text: 'of the balance, relative to its largest term' },
  compatibility: { symbol: 'compatibility', unit: '1', text: 'of Iν × ν = 0, relative' },
  error_bound: { symbol: 'error bound', unit: '1', text: 'of S, relative' },
  class: { symbol: 'class', unit: '', text: 'stability' },
  growth: { symbol: 'growth', unit: rate, text: 'largest growth rate' },
  negative: { symbol: 'negative', unit: '', text: 'negative directions of the second variation' },
  omega: { symbol: 'ω', unit: rate, text: 'rate of the turning in space' },
  theta_dot: { symbol: 'θ̇', unit: rate, text: 'rate of the turning in the body' },
  s3: { symbol: 's₃', unit: momentum, text: 'spin momentum' },
  p_theta: { symbol: 'p_θ', unit: momentum, text: 'material momentum' },
  status: { symbol: 'status', unit: '', text: 'of the cell' },
  certified: { symbol: 'certified', unit: '', text: 'whether a proof stands behind the row' },
  class_certified: { symbol: 'class certified', unit: '', text: 'whether a proof stands behind the class' },
  segment: { symbol: 'segment', unit: '', text: 'stretch of one class' },
  criticality: { symbol: 'criticality', unit: energy, text: 'coefficient of the normal form' },
  side: { symbol: 'side', unit: '', text: 'where the motions that begin here exist, the parameter growing' },
  pressure: { symbol: 'P', unit: energy, text: 'what holds the volume' },
  nu: { symbol: 'ν', unit: rate, text: 'spin' },
  'motion.nu': { symbol: 'ν', unit: rate, text: 'spin' },
  'motion.omega': { symbol: 'ω', unit: rate, text: 'rate of the turning in space' },
  'motion.theta_dot': { symbol: 'θ̇', unit: rate, text: 'rate of the turning in the body' },
  'motion.s3': { symbol: 's₃', unit: momentum, text: 'spin momentum' },
  'motion.p_theta': { symbol: 'p_θ', unit: momentum, text: 'material momentum' },
};

const digits = ['₀', '₁', '₂', '₃', '₄', '₅'];

export function meaning(name: string): Meaning {
  if (Object.hasOwn(meanings, name)) return meanings[name];
  const mode = /^(re|im|krein)([1-5])$/.exec(name);
  if (mode) {
    const k = digits[Number(mode[2])];
    if (mode[1] === 're') return { symbol: `Re s${k}`, unit: rate, text: `growth rate of mode ${mode[2]}` };
    if (mode[1] === 'im') return { symbol: `Im s${k}`, unit: rate, text: `frequency of mode ${mode[2]}` };
    return { symbol: `Krein${k}`, unit: '', text: `Krein signature of mode ${mode[2]}` };
  }
  const axis = /^body\.J\.([0-2])$/.exec(name);
  if (axis) return { symbol: `J${digits[Number(axis[1]) + 1]}`, unit: inertia, text: `inertia along axis ${Number(axis[1]) + 1}` };
  return { symbol: name, unit: '', text: '' };
}

/** "λ", or "ν₁ (1/T)". */
export function withUnit(name: string): string {
  const { symbol, unit } = meaning(name);
  return unit === '' || unit === '1' ? symbol : `${symbol} (${unit})`;
}

/** For reading, not for going on: the exact text stands in the row's table. */
export function shown(value: number): string {
  if (!Number.isFinite(value)) return '–';
  return String(Number(value.toPrecision(10))).replace('-', '−');
}
