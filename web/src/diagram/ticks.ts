// What stands at the ticks of an axis: as few digits as tell them apart, so that they have room.

import { scaleLinear } from 'd3-scale';

export interface Ticks {
  values: number[];
  text(value: number): string;
  /** What is to be added to each text; 0: nothing. */
  less: number;
}

/** Of a decimal's first digit. */
const place = (value: number): number => Math.floor(Math.log10(value) + 1e-9);

/** Round numbers. Of those that differ after more than some digits the difference from one number is told. */
export function linearTicks(low: number, high: number, count: number, most: number): Ticks {
  const values = scaleLinear([low, high], [0, 1]).ticks(count);
  const step = values.length > 1 ? values[1] - values[0] : high - low;
  const size = Math.max(Math.abs(low), Math.abs(high));
  const less = place(size) - place(step) >= most ? Number(((low + high) / 2).toPrecision(Math.max(place(size) - place(high - low), 1))) : 0;
  const decimals = Math.max(0, -place(step));
  const plain = decimals <= 4 && values.every((each) => Math.abs(each - less) < 1e5);
  const text = (value: number): string => {
    const at = Math.abs(value - less) < 1e-3 * step ? 0 : value - less;
    const written = plain ? at.toFixed(decimals) : at === 0 ? '0' : at.toExponential(Math.max(0, place(Math.abs(at)) - place(step)));
    return written.replace('e+', 'e').replaceAll('-', '−');
  };
  return { values, text, less };
}
