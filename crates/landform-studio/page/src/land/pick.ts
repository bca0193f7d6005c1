// Where a ray meets the ground.
import { extent, sample, toCell, type Raster } from "../model/raster.ts";

type Point = [number, number, number];

/** East and north of the land's middle, metres; null where the ray misses. */
export function pick(ground: Raster, tall: number, from: Point, way: Point): [number, number] | null {
  const [w, h] = extent(ground);
  const top = (ground.max - ground.min) * tall;
  const [enter, leave] = span(from, way, [-w / 2, -h / 2, -1e-6], [w / 2, h / 2, top + 1e-6]);
  if (!(leave > enter)) return null;
  const step = Math.max((leave - enter) / 600, 1e-9);
  let before = enter;
  for (let t = enter; t <= leave + step; t += step) {
    if (above(ground, tall, from, way, t) <= 0) return refine(ground, tall, from, way, before, t);
    before = t;
  }
  return null;
}

function above(ground: Raster, tall: number, from: Point, way: Point, t: number): number {
  const [col, row] = toCell(ground, from[0] + way[0] * t, from[1] + way[1] * t);
  const z = sample(ground, Math.min(Math.max(col, 0), ground.cols - 1), Math.min(Math.max(row, 0), ground.rows - 1));
  return from[2] + way[2] * t - (z - ground.min) * tall;
}

function refine(ground: Raster, tall: number, from: Point, way: Point, low: number, high: number): [number, number] {
  for (let i = 0; i < 12; i++) {
    const middle = (low + high) / 2;
    if (above(ground, tall, from, way, middle) <= 0) high = middle;
    else low = middle;
  }
  return [from[0] + way[0] * high, from[1] + way[1] * high];
}

/** Where a ray is within a box. */
function span(from: Point, way: Point, least: Point, most: Point): [number, number] {
  let enter = 0, leave = Infinity;
  for (let k = 0; k < 3; k++) {
    if (Math.abs(way[k]!) < 1e-12) {
      if (from[k]! < least[k]! || from[k]! > most[k]!) return [1, 0];
      continue;
    }
    const a = (least[k]! - from[k]!) / way[k]!, b = (most[k]! - from[k]!) / way[k]!;
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return [enter, leave];
}
