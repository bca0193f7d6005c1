// The map's picture: colours of a field, darkened and lightened by light from four sides, water by its depth.
import type { LandState } from "../land/state.ts";
import { partOf, rampTable, scaleOf, type FieldScale } from "../model/ramps.ts";

/** Four bytes a node, row 0 in the north. */
export function mapPixels(state: LandState): Uint8ClampedArray<ArrayBuffer> {
  const { ground, depth, field } = state;
  const { rows, cols, z, cell } = ground;
  const scale: FieldScale = field?.scale ?? landScale(state);
  const values = field && field.raster.z.length === z.length ? field.raster.z : z;
  const table = rampTable(scale.ramp);
  const water = rampTable("depth");
  const deepest = depth ? Math.max(1e-6, ...sampled(depth)) : 1;
  const out = new Uint8ClampedArray(rows * cols * 4);
  const vivid = reliefFactor(state);
  for (let r = 0; r < rows; r++) {
    const up = Math.max(0, r - 1) * cols, down = Math.min(rows - 1, r + 1) * cols;
    for (let c = 0; c < cols; c++) {
      const i = r * cols + c;
      const v = values[i]!;
      if (Number.isNaN(z[i]!)) continue;
      const x = ((z[r * cols + Math.min(cols - 1, c + 1)]! - z[r * cols + Math.max(0, c - 1)]!) / (2 * cell[0])) * vivid;
      const y = ((z[up + c]! - z[down + c]!) / (2 * cell[1])) * vivid;
      const wet = depth !== null && depth[i]! > 0 && !field;
      const at = wet ? 3 * Math.round(255 * (0.25 + 0.7 * Math.sqrt(Math.min(1, depth[i]! / deepest)))) : 3 * Math.round(255 * partOf(v, scale));
      const from = wet ? water : table;
      const light = wet ? 0.86 : shade(x, y);
      const o = 4 * i;
      for (let k = 0; k < 3; k++) out[o + k] = from[at + k]! * light;
      out[o + 3] = 255;
    }
  }
  return out;
}

/** Colours of heights begin at the sea where there is one, so that land is not all of one colour. */
export function landScale({ ground }: LandState): FieldScale {
  const low = ground.sea !== null && ground.sea > ground.min && ground.sea < ground.max ? ground.sea : ground.min;
  return scaleOf("elevation", low, ground.max);
}

function* sampled(depth: Float32Array): Generator<number> {
  const step = Math.max(1, Math.floor(depth.length / 4096));
  for (let i = 0; i < depth.length; i += step) yield depth[i]!;
}

/** Gentle land is shaded as if it were steeper. */
function reliefFactor({ ground }: LandState): number {
  const typical = (ground.max - ground.min) / (Math.min(ground.cols * ground.cell[0], ground.rows * ground.cell[1]) || 1);
  return Math.min(40, Math.max(0.8, 0.12 / Math.max(typical, 1e-6)));
}

const SUNS: [number, number, number, number][] = [315, 270, 360, 225].map((azimuth, i) => {
  const a = (azimuth * Math.PI) / 180, height = (38 * Math.PI) / 180;
  return [Math.sin(a) * Math.cos(height), Math.cos(a) * Math.cos(height), Math.sin(height), [0.55, 0.15, 0.2, 0.1][i]!];
});

/** Brightness of ground that rises by x eastwards and y northwards; level ground has 1. */
function shade(x: number, y: number): number {
  const long = Math.sqrt(x * x + y * y + 1);
  let sum = 0;
  for (const [sx, sy, sz, weight] of SUNS) sum += (weight * Math.max(0, -x * sx - y * sy + sz)) / long;
  return 0.40 + 0.97 * sum;
}
