// What a picture of the land shows: its ground, water and colours. Kept states are compared with each other.
import { otherCover, type Cover } from "../model/materials.ts";
import { partOf, rampTable, type FieldScale } from "../model/ramps.ts";
import type { Raster } from "../model/raster.ts";

export interface LandState {
  ground: Raster;
  /** Depth of water (see model/water.ts). */
  depth: Float32Array | null;
  drainage: Raster | null;
  /** Numbers of the materials at the surface, and what they look like. */
  material: { raster: Raster; covers: Cover[] } | null;
  /** The field that gives the colours, and its scale. */
  field: { raster: Raster; scale: FieldScale } | null;
}

export type Look = "natural" | "field" | "clay" | "sand";

/** Height over the lowest node and depth of water, two floats a node; nodata lies far below. */
export function groundTexels(state: LandState): Float32Array {
  const { z, min } = state.ground;
  const out = new Float32Array(z.length * 2);
  for (let i = 0; i < z.length; i++) {
    const v = z[i]!;
    out[2 * i] = Number.isNaN(v) ? -1e4 : v - min;
    out[2 * i + 1] = state.depth ? state.depth[i]! : -50;
  }
  return out;
}

/** Colours of materials, and in alpha how much of them shows; null where there are none. */
export function materialTexels({ ground, material }: LandState): Uint8Array | null {
  if (!material || material.raster.z.length !== ground.z.length) return null;
  const out = new Uint8Array(ground.z.length * 4);
  for (let i = 0; i < ground.z.length; i++) {
    // Frames may come in steps, so that whole numbers come nearly whole.
    const number = Math.round(material.raster.z[i]!);
    const { colour, shows } = Number.isNaN(number) ? otherCover(0) : (material.covers[number] ?? otherCover(number));
    out[4 * i] = colour[0];
    out[4 * i + 1] = colour[1];
    out[4 * i + 2] = colour[2];
    out[4 * i + 3] = Math.round(255 * shows);
  }
  return out;
}

/** Colours of the field, and in alpha how much of a river runs at the node. */
export function colourTexels(state: LandState): Uint8Array {
  const { ground, drainage, field } = state;
  const count = ground.z.length;
  const out = new Uint8Array(count * 4);
  if (field && field.raster.z.length === count) {
    const table = rampTable(field.scale.ramp);
    for (let i = 0; i < count; i++) {
      const v = field.raster.z[i]!;
      const at = Number.isNaN(v) ? -1 : 3 * Math.round(255 * partOf(v, field.scale));
      for (let c = 0; c < 3; c++) out[4 * i + c] = at < 0 ? 60 : table[at + c]!;
    }
  }
  if (drainage && drainage.z.length === count) {
    const whole = count * ground.cell[0] * ground.cell[1];
    const [low, high] = [Math.log(whole * 0.0025), Math.log(whole * 0.06)];
    for (let i = 0; i < count; i++) {
      const part = (Math.log(Math.max(drainage.z[i]!, 1e-9)) - low) / (high - low);
      out[4 * i + 3] = part > 0 ? Math.round(255 * Math.min(1, 0.35 + 0.65 * part)) : 0;
    }
  }
  return out;
}
