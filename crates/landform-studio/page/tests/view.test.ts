import assert from "node:assert/strict";
import { test } from "node:test";
import { eye, FIELD_OF_VIEW, homeView, LEAST_PITCH, MOST_PITCH, panned, turned, zoomed } from "../src/land/camera.ts";
import { pick } from "../src/land/pick.ts";
import { materialTexels } from "../src/land/state.ts";
import { covers } from "../src/model/materials.ts";
import { contourInterval, contourLine } from "../src/map/contours.ts";
import { partOf, rampTable, scaleOf } from "../src/model/ramps.ts";
import { range, sample, slopeAt, slopeRaster, toCell, type Raster } from "../src/model/raster.ts";
import { waterDepth } from "../src/model/water.ts";

/** A plane that rises 0.1 a metre eastwards. */
function ramp(rows = 21, cols = 31, cell = 10): Raster {
  const z = Float32Array.from({ length: rows * cols }, (_, i) => (i % cols) * cell * 0.1);
  const [min, max] = range(z);
  return { layer: "elevation", rows, cols, cell: [cell, cell], origin: [0, 0], z, min, max, time: 0, level: "1", revision: 1, stage: null, sea: null, stamp: null };
}

test("the home view shows all corners of the land and fills the picture in one direction", () => {
  for (const [w, h, relief, aspect] of [[20e3, 20e3, 2000, 1.6], [300, 300, 20, 0.7], [50e3, 10e3, 100, 2.2], [1000, 9000, 4000, 1]] as const) {
    const view = homeView(w, h, relief, aspect);
    const at = eye(view);
    const forward = [view.target[0] - at[0], view.target[1] - at[1], view.target[2] - at[2]].map((v) => v / view.distance);
    const right = [Math.cos(view.heading), -Math.sin(view.heading), 0];
    const up = [right[1]! * forward[2]! - right[2]! * forward[1]!, right[2]! * forward[0]! - right[0]! * forward[2]!, right[0]! * forward[1]! - right[1]! * forward[0]!];
    const dot = (a: number[], b: number[]) => a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
    let widest = 0;
    for (const x of [-w / 2, w / 2]) for (const y of [-h / 2, h / 2]) for (const z of [0, relief]) {
      const d = [x - at[0], y - at[1], z - at[2]];
      const tan = Math.tan(FIELD_OF_VIEW / 2);
      const [px, py] = [dot(d, right) / dot(d, forward) / (tan * aspect), dot(d, up) / dot(d, forward) / tan];
      assert.ok(Math.abs(px) < 1 && Math.abs(py) < 1, `${px} ${py}`);
      widest = Math.max(widest, Math.abs(px), Math.abs(py));
    }
    assert.ok(widest > 0.75, `${widest}`);
  }
});

test("turning, zooming and panning stay within their limits", () => {
  const view = homeView(1000, 1000, 100, 1.5);
  assert.equal(turned(view, 0, 9).pitch, MOST_PITCH);
  assert.equal(turned(view, 0, -9).pitch, LEAST_PITCH);
  assert.ok(Math.abs(turned(view, 4 * Math.PI, 0).heading - (view.heading + 2 * Math.PI)) < 1e-9);
  assert.equal(zoomed(view, 1e-9, 1000).distance, 4);
  assert.equal(zoomed(view, 1e9, 1000).distance, 6000);
  const north = panned({ ...view, heading: 0 }, 0, 0.1, 1000);
  assert.ok(north.target[1] > view.target[1] && Math.abs(north.target[0] - view.target[0]) < 1e-9);
  assert.equal(panned(view, 1e9, 0, 1000).target.every((v) => Math.abs(v) <= 1000), true);
});

test("a ray straight down meets the ground below it; one beside the land misses", () => {
  const ground = ramp();
  const hit = pick(ground, 1, [40, -30, 1000], [0, 0, -1])!;
  assert.ok(Math.abs(hit[0] - 40) < 1e-6 && Math.abs(hit[1] + 30) < 1e-6);
  assert.equal(pick(ground, 1, [900, 0, 1000], [0, 0, -1]), null);
  assert.equal(pick(ground, 1, [0, 0, 1000], [0, 0, 1]), null);
  const slanted = pick(ground, 2, [-1000, 0, 300], [0.958, 0, -0.287])!;
  assert.ok(Number.isFinite(slanted[0]));
});

test("samples, slopes and places", () => {
  const ground = ramp();
  assert.deepEqual(toCell(ground, 0, 0), [15, 10]);
  assert.ok(Math.abs(sample(ground, 3.5, 2) - 3.5) < 1e-6);
  assert.ok(Number.isNaN(sample(ground, -1, 0)));
  assert.ok(Math.abs(slopeAt(ground, 15, 10) - 0.1) < 1e-5);
  const slopes = slopeRaster(ground);
  assert.ok(Math.abs(slopes.z[40]! - (Math.atan(0.1) * 180) / Math.PI) < 1e-3);
});

test("contours of a plane are straight and stand where they should", () => {
  const line = contourLine(ramp(), 7.5);
  assert.equal(line.length, 20 * 4);
  assert.ok(line.every((v, i) => i % 2 === 1 || Math.abs(v - 7.5) < 1e-5));
  assert.equal(contourInterval(1400, 14), 100);
  assert.equal(contourInterval(0), 0);
  assert.deepEqual(contourLine(ramp(), 99), []);
});

test("water: the sea by its level, lakes by their depth, dry ground beside a lake knows its level", () => {
  const ground = ramp();
  assert.equal(waterDepth(ground, null), null);
  const sea = waterDepth({ ...ground, sea: 5 }, null)!;
  assert.equal(sea[0], 5);
  assert.ok(sea[30]! < 0);
  const lakes = { ...ground, z: new Float32Array(ground.z.length), max: 2 };
  lakes.z[40] = 2;
  const depth = waterDepth(ground, lakes)!;
  assert.equal(depth[40], 2);
  assert.ok(depth[42]! < -10 && depth[41]! < 0);
});

test("ramps run one way in lightness, scales hold their ends", () => {
  for (const name of ["height", "cividis", "viridis"]) {
    const t = rampTable(name);
    const light = (i: number) => 0.2126 * t[3 * i]! + 0.7152 * t[3 * i + 1]! + 0.0722 * t[3 * i + 2]!;
    for (let i = 8; i < 256; i += 8) assert.ok(light(i) > light(i - 8), `${name} ${i}`);
  }
  const area = scaleOf("drainage_area", 100, 1e8);
  assert.equal(area.log, true);
  assert.equal(partOf(1e8, area), 1);
  assert.equal(partOf(0, area), 0);
  assert.equal(scaleOf("erosion_rate", -2, 1).low, -2);
});

test("materials have their colours, also where whole numbers came nearly whole or are not known", () => {
  const ground = ramp(1, 4);
  const raster = { ...ground, z: Float32Array.from([0, 3.9996, 11, 200]) };
  const texels = materialTexels({ ground, depth: null, drainage: null, field: null, material: { raster, covers: covers(["ash"]) } })!;
  assert.deepEqual([texels[3], texels[7], texels[11], texels[15]], [0, 128, 255, 128]);
  assert.deepEqual([...texels.slice(4, 7)], [0xc4, 0x8a, 0x5a]);
  assert.ok(texels.slice(12, 15).every((v) => v > 0));
  assert.equal(covers(["ash", "sand"]).length, 14);
});
