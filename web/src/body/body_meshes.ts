// The meshes of the body's view: a unit sphere, an arrow's shaft and head along axis 3, a circle, and a square.

export interface Mesh {
  /** Three numbers of the place, three of the normal. */
  vertices: Float32Array;
  indices: Uint16Array;
}

/** A surface of revolution about axis 3, of (radius, height, outward, upward) a ring. */
function turned(profile: readonly (readonly [number, number, number, number])[], around: number): Mesh {
  const vertices: number[] = [];
  const indices: number[] = [];
  profile.forEach(([radius, height, out, up], ring) => {
    for (let k = 0; k <= around; ++k) {
      const [c, s] = [Math.cos((2 * Math.PI * k) / around), Math.sin((2 * Math.PI * k) / around)];
      vertices.push(radius * c, radius * s, height, out * c, out * s, up);
      if (ring === 0 || k === 0) continue;
      const a = ring * (around + 1) + k;
      const b = a - (around + 1);
      indices.push(b - 1, b, a, b - 1, a, a - 1);
    }
  });
  return { vertices: Float32Array.from(vertices), indices: Uint16Array.from(indices) };
}

export function sphere(): Mesh {
  const rings = 72;
  return turned(
    Array.from({ length: rings + 1 }, (_, k) => {
      const latitude = Math.PI * (k / rings - 0.5);
      const [c, s] = [Math.cos(latitude), Math.sin(latitude)];
      return [c, s, c, s] as const;
    }),
    128,
  );
}

export const shaft = (): Mesh => turned([[0, 0, 0, -1], [1, 0, 0, -1], [1, 0, 1, 0], [1, 1, 1, 0], [1, 1, 0, 1], [0, 1, 0, 1]], 24);
export const head = (): Mesh => turned([[0, 0, 0, -1], [1, 0, 0, -1], [1, 0, 0.9, 0.4], [0, 1, 0.9, 0.4]], 32);

/** Lines, not triangles. */
export function circle(): Mesh {
  const count = 160;
  const vertices: number[] = [];
  for (let k = 0; k < count; ++k) vertices.push(Math.cos((2 * Math.PI * k) / count), Math.sin((2 * Math.PI * k) / count), 0, 0, 0, 1);
  return { vertices: Float32Array.from(vertices), indices: Uint16Array.from({ length: count }, (_, k) => k) };
}

export function square(): Mesh {
  const corners = [[-1.6, -1.6], [1.6, -1.6], [1.6, 1.6], [-1.6, 1.6]];
  return { vertices: Float32Array.from(corners.flatMap(([x, y]) => [x, y, 0, 0, 0, 1])), indices: Uint16Array.from([0, 1, 2, 0, 2, 3]) };
}
