// Depth of water over every node: positive under water, negative by as much as the ground stands over the water beside it.
import type { Raster } from "./raster.ts";

export const DRY = -50;

/** Lakes come as a layer of depths; the sea lies wherever ground at its level is open to it. Null where there is no water. */
export function waterDepth(ground: Raster, lakes: Raster | null): Float32Array | null {
  const fits = lakes && lakes.rows === ground.rows && lakes.cols === ground.cols && lakes.max > 0;
  const sea = ground.sea !== null && ground.min < ground.sea ? ground.sea : null;
  if (!fits && sea === null) return null;
  const depth = new Float32Array(ground.z.length).fill(DRY);
  if (sea !== null) for (let i = 0; i < depth.length; i++) depth[i] = Math.max(DRY, sea - ground.z[i]!);
  if (fits) addLakes(depth, ground, lakes);
  return depth;
}

function addLakes(depth: Float32Array, ground: Raster, lakes: Raster): void {
  const { rows, cols, z } = ground;
  for (let i = 0; i < depth.length; i++) if (lakes.z[i]! > 0) depth[i] = Math.max(depth[i]!, lakes.z[i]!);
  for (let r = 0; r < rows; r++) {
    for (let c = 0; c < cols; c++) {
      const i = r * cols + c;
      if (depth[i]! > 0) continue;
      for (let q = Math.max(0, r - 1); q <= Math.min(rows - 1, r + 1); q++) {
        for (let p = Math.max(0, c - 1); p <= Math.min(cols - 1, c + 1); p++) {
          const j = q * cols + p;
          const lake = lakes.z[j]!;
          if (lake > 0) depth[i] = Math.min(-0.01, Math.max(depth[i]!, z[j]! + lake - z[i]!));
        }
      }
    }
  }
}
