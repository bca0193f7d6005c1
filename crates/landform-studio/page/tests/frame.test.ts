import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { Assembler } from "../src/model/raster.ts";
import { decodeFrame, FrameError, undoDifferences, type FrameHeader } from "../src/protocol/frame.ts";

const HEADER: FrameHeader = {
  protocol: 1, session: "s", revision: 1, frame: 1, layer: "elevation", level: "1/4", rows: 3, cols: 4, row0: 0, band_rows: 3, last: true, cell_size: [10, 20],
  origin: [0, 0], time: 31_557_600, stage: null, encoding: "f32", quantum: 0.5, offset: -10, nodata: null, min: 0, max: 1, sea_level: null, stamp: null,
};

function message(header: Partial<FrameHeader>, data: Uint8Array): ArrayBuffer {
  const head = new TextEncoder().encode(JSON.stringify({ ...HEADER, ...header }));
  const start = Math.ceil((4 + head.length) / 8) * 8;
  const out = new Uint8Array(start + data.length);
  new DataView(out.buffer).setUint32(0, head.length, true);
  out.set(head, 4);
  out.set(data, start);
  return out.buffer;
}

const bytes = (a: Float32Array | Uint16Array) => new Uint8Array(a.buffer, a.byteOffset, a.byteLength);

test("f32 gives the numbers themselves, nodata becomes NaN", async () => {
  const values = Float32Array.from({ length: 12 }, (_, i) => i * 1.25);
  values[5] = -9999;
  const { samples } = await decodeFrame(message({ nodata: -9999 }, bytes(values)));
  assert.ok(Number.isNaN(samples[5]));
  assert.equal(samples[7], 8.75);
});

test("u16 is offset + quantum n, 65535 is nodata", async () => {
  const steps = Uint16Array.from([0, 1, 2, 3, 65534, 65535, 6, 7, 8, 9, 10, 11]);
  const { samples } = await decodeFrame(message({ encoding: "u16" }, bytes(steps)));
  assert.deepEqual([...samples.slice(0, 5)], [-10, -9.5, -9, -8.5, 32757]);
  assert.ok(Number.isNaN(samples[5]));
});

test("differences along rows wrap, and the first column follows from above", async () => {
  const steps = Uint16Array.from([65000, 10, 65535, 3, 1, 0, 65535, 65535, 30000, 1, 2, 3]);
  const differences = steps.map((n, i) => n - (i % 4 ? steps[i - 1]! : i ? steps[i - 4]! : 0));
  const { samples } = await decodeFrame(message({ encoding: "u16_delta_deflate" }, deflateSync(bytes(differences))));
  const expected = [...steps].map((n) => (n === 65535 ? NaN : Math.fround(-10 + 0.5 * n)));
  assert.deepEqual([...samples], expected);
  undoDifferences(differences, 3, 4);
  assert.deepEqual([...differences], [...steps]);
});

test("hostile frames are refused, not believed", async () => {
  const full = new Uint8Array(48);
  const cases: [Partial<FrameHeader>, Uint8Array][] = [
    [{ rows: 1e9, cols: 1e9, band_rows: 1 }, full],
    [{ row0: 2 }, full],
    [{ band_rows: -1 }, full],
    [{ rows: 1.5 }, full],
    [{ encoding: "zip" as never }, full],
    [{}, new Uint8Array(8)],
    [{ encoding: "u16" }, new Uint8Array(8)],
    [{ encoding: "u16_delta_deflate" }, deflateSync(new Uint8Array(1 << 20))],
    [{ encoding: "u16_delta_deflate" }, deflateSync(new Uint8Array(3))],
  ];
  for (const [header, data] of cases) await assert.rejects(async () => decodeFrame(message(header, data)), FrameError);
  await assert.rejects(async () => decodeFrame(message({ encoding: "u16_delta_deflate" }, new Uint8Array([1, 2, 3]))));
  await assert.rejects(async () => decodeFrame(new ArrayBuffer(2)), FrameError);
  const long = new Uint8Array(16);
  new DataView(long.buffer).setUint32(0, 4_000_000_000, true);
  await assert.rejects(async () => decodeFrame(long.buffer), FrameError);
});

test("bands and layers of one picture come together at its last message", async () => {
  const all = new Assembler();
  const band = async (h: Partial<FrameHeader>, value: number) => {
    const header = { ...HEADER, ...h };
    return all.add(await decodeFrame(message(h, bytes(new Float32Array(header.band_rows * header.cols).fill(value)))));
  };
  assert.equal(await band({ frame: 7, band_rows: 1, last: false }, 1), null);
  assert.equal(await band({ frame: 7, row0: 1, band_rows: 2, last: false }, 2), null);
  const whole = await band({ frame: 7, layer: "slope", last: true }, 3);
  assert.deepEqual(whole?.map((r) => r.layer), ["elevation", "slope"]);
  assert.deepEqual([...whole![0]!.z], [1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2]);
  assert.equal(whole![0]!.time, 1);
  // A picture that was cut off leaves nothing behind.
  assert.equal(await band({ frame: 8, band_rows: 1, last: false }, 9), null);
  assert.deepEqual((await band({ frame: 9, last: true }, 4))?.map((r) => r.max), [4]);
});
