// Lines of equal height, by marching squares.
import type { Raster } from "../model/raster.ts";

/** A round interval that gives about `wanted` lines over a relief. */
export function contourInterval(relief: number, wanted = 14): number {
  if (!(relief > 0)) return 0;
  const raw = relief / wanted;
  const power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].map((f) => f * power).find((step) => step >= raw)!;
}

/** Pieces of lines as x, y, x, y in columns and rows. */
export function contourLine(ground: Raster, level: number): number[] {
  const { rows, cols, z } = ground;
  const out: number[] = [];
  for (let r = 0; r + 1 < rows; r++) {
    for (let c = 0; c + 1 < cols; c++) {
      const a = z[r * cols + c]!, b = z[r * cols + c + 1]!, d = z[(r + 1) * cols + c]!, e = z[(r + 1) * cols + c + 1]!;
      const which = (a >= level ? 1 : 0) | (b >= level ? 2 : 0) | (e >= level ? 4 : 0) | (d >= level ? 8 : 0);
      if (which === 0 || which === 15 || Number.isNaN(a + b + d + e)) continue;
      cross(out, which, c, r, (level - a) / (b - a), (level - b) / (e - b), (level - d) / (e - d), (level - a) / (d - a));
    }
  }
  return out;
}

/** The pieces in one square: fractions along its north, east, south and west side. */
function cross(out: number[], which: number, c: number, r: number, n: number, e: number, s: number, w: number): void {
  const north = [c + n, r], east = [c + 1, r + e], south = [c + s, r + 1], west = [c, r + w];
  const piece = (p: number[], q: number[]) => out.push(p[0]!, p[1]!, q[0]!, q[1]!);
  switch (which) {
    case 1: case 14: return void piece(west, north);
    case 2: case 13: return void piece(north, east);
    case 3: case 12: return void piece(west, east);
    case 4: case 11: return void piece(east, south);
    case 6: case 9: return void piece(north, south);
    case 7: case 8: return void piece(west, south);
    case 5: piece(west, north); return void piece(east, south);
    case 10: piece(north, east); return void piece(west, south);
  }
}
