// One layer of the shown ground, and the sums and samples that views need.
import type { Frame, FrameHeader } from "../protocol/frame.ts";

export interface Raster {
  layer: string;
  rows: number;
  cols: number;
  cell: [number, number];
  /** The south-west node. */
  origin: [number, number];
  /** Row 0 is the north; NaN where there is no data. */
  z: Float32Array;
  min: number;
  max: number;
  /** Years. */
  time: number;
  level: string;
  revision: number;
  stage: number | null;
  sea: number | null;
  stamp: number | null;
}

const YEAR = 31_557_600;

/** Puts the bands of a picture's layers together. All messages of one picture carry one number; the last one says so. */
export class Assembler {
  private picture = -1;
  private parts = new Map<string, { z: Float32Array; filled: number; header: FrameHeader }>();

  /** All whole layers of the picture, once its last message is in. */
  add({ header, samples }: Frame): Raster[] | null {
    if (header.frame !== this.picture) {
      this.picture = header.frame;
      this.parts = new Map();
    }
    const { layer, rows, cols, row0, band_rows } = header;
    let part = this.parts.get(layer);
    if (!part || part.z.length !== rows * cols) {
      part = { header, z: new Float32Array(rows * cols).fill(NaN), filled: 0 };
      this.parts.set(layer, part);
    }
    part.z.set(samples, row0 * cols);
    part.filled += band_rows;
    if (!header.last) return null;
    const whole = [...this.parts.values()].filter((p) => p.filled >= p.header.rows);
    this.parts = new Map();
    return whole.map(({ header: h, z }) => toRaster(h, z));
  }
}

function toRaster(h: FrameHeader, z: Float32Array): Raster {
  const [min, max] = range(z);
  return {
    layer: h.layer, rows: h.rows, cols: h.cols, cell: h.cell_size, origin: h.origin, z, min, max, time: h.time / YEAR, level: h.level,
    revision: h.revision, stage: h.stage, sea: h.sea_level, stamp: h.stamp,
  };
}

/** Least and greatest sample; 0 and 0 where there is none. */
export function range(z: Float32Array): [number, number] {
  let min = Infinity, max = -Infinity;
  for (let i = 0; i < z.length; i++) {
    const v = z[i]!;
    if (v < min) min = v;
    if (v > max) max = v;
  }
  return min <= max ? [min, max] : [0, 0];
}

/** Width and height of the land, metres. */
export function extent(r: Raster): [number, number] {
  return [Math.max(1, r.cols - 1) * r.cell[0], Math.max(1, r.rows - 1) * r.cell[1]];
}

/** Column and row (fractions) of a place given in metres from the land's middle. */
export function toCell(r: Raster, east: number, north: number): [number, number] {
  return [east / r.cell[0] + (r.cols - 1) / 2, (r.rows - 1) / 2 - north / r.cell[1]];
}

/** The sample at a column and row, linear between nodes; NaN outside. */
export function sample(r: Raster, col: number, row: number): number {
  if (!(col >= 0 && row >= 0 && col <= r.cols - 1 && row <= r.rows - 1)) return NaN;
  const c = Math.min(Math.floor(col), Math.max(0, r.cols - 2)), q = Math.min(Math.floor(row), Math.max(0, r.rows - 2));
  const c1 = Math.min(c + 1, r.cols - 1), q1 = Math.min(q + 1, r.rows - 1);
  const [u, v] = [col - c, row - q];
  const top = r.z[q * r.cols + c]! * (1 - u) + r.z[q * r.cols + c1]! * u;
  const low = r.z[q1 * r.cols + c]! * (1 - u) + r.z[q1 * r.cols + c1]! * u;
  return top * (1 - v) + low * v;
}

/** The nearest sample, for fields that jump from node to node; NaN outside. */
export function nearest(r: Raster, col: number, row: number): number {
  const c = Math.round(col), q = Math.round(row);
  return c >= 0 && q >= 0 && c < r.cols && q < r.rows ? r.z[q * r.cols + c]! : NaN;
}

/** Steepest slope (rise over run) at a column and row. */
export function slopeAt(r: Raster, col: number, row: number): number {
  const c = Math.min(Math.max(col, 1), r.cols - 2), q = Math.min(Math.max(row, 1), r.rows - 2);
  const dx = (sample(r, c + 1, q) - sample(r, c - 1, q)) / (2 * r.cell[0]);
  const dy = (sample(r, c, q + 1) - sample(r, c, q - 1)) / (2 * r.cell[1]);
  return Math.hypot(dx, dy);
}

/** Slopes of all nodes, degrees. */
export function slopeRaster(r: Raster): Raster {
  const z = new Float32Array(r.z.length);
  for (let q = 0; q < r.rows; q++) {
    const up = Math.max(0, q - 1) * r.cols, down = Math.min(r.rows - 1, q + 1) * r.cols;
    const dy = (Math.min(r.rows - 1, q + 1) - Math.max(0, q - 1)) * r.cell[1] || 1;
    for (let c = 0; c < r.cols; c++) {
      const left = Math.max(0, c - 1), right = Math.min(r.cols - 1, c + 1);
      const x = (r.z[q * r.cols + right]! - r.z[q * r.cols + left]!) / ((right - left) * r.cell[0] || 1);
      const y = (r.z[down + c]! - r.z[up + c]!) / dy;
      z[q * r.cols + c] = (Math.atan(Math.hypot(x, y)) * 180) / Math.PI;
    }
  }
  const [min, max] = range(z);
  return { ...r, layer: "slope", z, min, max };
}
