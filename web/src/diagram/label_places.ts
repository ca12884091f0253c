// Where labels go that would cover each other: apart by at least a distance, in their order, and together as near to
// what they name as can be (the least sum of squares, by pooling neighbours).

interface Block {
  sum: number;
  count: number;
}

/** Of places in any order. */
export function apart(places: readonly number[], distance: number): number[] {
  const order = [...places.keys()].sort((a, b) => places[a] - places[b]);
  const blocks: Block[] = [];
  order.forEach((at, k) => {
    blocks.push({ sum: places[at] - k * distance, count: 1 });
    while (blocks.length > 1) {
      const [before, last] = blocks.slice(-2);
      if (before.sum / before.count <= last.sum / last.count) break;
      blocks.splice(-2, 2, { sum: before.sum + last.sum, count: before.count + last.count });
    }
  });
  const out = places.map(() => 0);
  let k = 0;
  for (const { sum, count } of blocks) for (let each = 0; each < count; ++each, ++k) out[order[k]] = sum / count + k * distance;
  return out;
}
