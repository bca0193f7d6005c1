// Grids of triangles: the surface, and the four walls where the land is cut off.
import { BufferAttribute, BufferGeometry } from "three";

/** A grid of `across` by `down` squares, parts from the north-west corner. */
export function surfaceGrid(across: number, down: number): BufferGeometry {
  const cols = across + 1, rows = down + 1;
  const part = new Float32Array(cols * rows * 2);
  for (let r = 0, k = 0; r < rows; r++) {
    for (let c = 0; c < cols; c++) {
      part[k++] = c / across;
      part[k++] = r / down;
    }
  }
  const index = new Uint32Array(across * down * 6);
  for (let r = 0, k = 0; r < down; r++) {
    for (let c = 0; c < across; c++) {
      const a = r * cols + c, b = a + cols;
      // The diagonal alternates, so that it prefers no direction.
      const quad = (r + c) % 2 === 0 ? [a, b, a + 1, a + 1, b, b + 1] : [a, b, b + 1, a, b + 1, a + 1];
      for (const i of quad) index[k++] = i;
    }
  }
  return geometry(part, new Float32Array(cols * rows), index);
}

/** Walls from the rim down to the foot, all the way round. */
export function wallStrip(across: number, down: number): BufferGeometry {
  const rim: [number, number][] = [];
  for (let c = 0; c < across; c++) rim.push([c / across, 1]);
  for (let r = down; r > 0; r--) rim.push([1, r / down]);
  for (let c = across; c > 0; c--) rim.push([c / across, 0]);
  for (let r = 0; r <= down; r++) rim.push([0, r / down]);
  const part = new Float32Array(rim.length * 4);
  const deep = new Float32Array(rim.length * 2);
  rim.forEach(([x, y], i) => {
    part.set([x, y, x, y], 4 * i);
    deep.set([0, 1], 2 * i);
  });
  const index = new Uint32Array((rim.length - 1) * 6);
  for (let i = 0; i + 1 < rim.length; i++) index.set([2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 2, 2 * i + 1, 2 * i + 3], 6 * i);
  return geometry(part, deep, index);
}

/** A rectangle over the whole picture. */
export function fullPicture(): BufferGeometry {
  return geometry(new Float32Array([0, 0, 1, 0, 0, 1, 1, 1]), new Float32Array(4), new Uint32Array([0, 1, 2, 2, 1, 3]));
}

function geometry(part: Float32Array, deep: Float32Array, index: Uint32Array): BufferGeometry {
  const made = new BufferGeometry();
  made.setAttribute("part", new BufferAttribute(part, 2));
  made.setAttribute("deep", new BufferAttribute(deep, 1));
  made.setIndex(new BufferAttribute(index, 1));
  return made;
}
