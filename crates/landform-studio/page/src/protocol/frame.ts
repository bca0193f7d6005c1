// Binary frames: u32 length of the header, header (JSON), zeros to a multiple of 8, samples. Rows run from the north.

export interface FrameHeader {
  protocol: number;
  session: string;
  revision: number;
  frame: number;
  layer: string;
  level: string;
  rows: number;
  cols: number;
  row0: number;
  band_rows: number;
  last: boolean;
  cell_size: [number, number];
  origin: [number, number];
  time: number;
  stage: number | null;
  encoding: "f32" | "u16" | "u16_delta_deflate";
  quantum: number;
  offset: number;
  nodata: number | null;
  min: number;
  max: number;
  sea_level: number | null;
  stamp: number | null;
}

export interface Frame {
  header: FrameHeader;
  /** Samples of the band; NaN where there is no data. */
  samples: Float32Array;
}

const NO_SAMPLE = 65535;
const MOST_NODES = 1 << 26;

export class FrameError extends Error {}

/** Splits a message into header and bytes of samples. */
export function splitFrame(message: ArrayBuffer): { header: FrameHeader; data: Uint8Array<ArrayBuffer> } {
  if (message.byteLength < 4) throw new FrameError("a frame is shorter than its length");
  const length = new DataView(message).getUint32(0, true);
  const start = Math.ceil((4 + length) / 8) * 8;
  if (start > message.byteLength) throw new FrameError("a frame's header runs past its end");
  let header: FrameHeader;
  try {
    header = JSON.parse(new TextDecoder().decode(new Uint8Array(message, 4, length))) as FrameHeader;
  } catch {
    throw new FrameError("a frame's header is not JSON");
  }
  const { rows, cols, row0, band_rows } = header;
  const whole = [rows, cols, row0, band_rows].every((n) => Number.isInteger(n) && n >= 0);
  if (!whole || rows * cols > MOST_NODES || row0 + band_rows > rows) throw new FrameError("a frame's band lies outside its layer");
  return { header, data: new Uint8Array(message, start) };
}

/** Decodes a frame. Only deflated frames take more than one turn of the event loop. */
export function decodeFrame(message: ArrayBuffer): Frame | Promise<Frame> {
  const { header, data } = splitFrame(message);
  const count = header.band_rows * header.cols;
  switch (header.encoding) {
    case "f32":
      return { header, samples: fromFloats(data, count, header.nodata) };
    case "u16":
      return { header, samples: fromSteps(words(data, count), header) };
    case "u16_delta_deflate":
      return inflate(data, count * 2).then((bytes) => {
        const steps = words(bytes, count);
        undoDifferences(steps, header.band_rows, header.cols);
        return { header, samples: fromSteps(steps, header) };
      });
    default:
      throw new FrameError(`encoding \`${String(header.encoding)}\` is not known`);
  }
}

function fromFloats(data: Uint8Array<ArrayBuffer>, count: number, nodata: number | null): Float32Array {
  if (data.byteLength < count * 4) throw new FrameError("a frame has too few samples");
  const out = new Float32Array(data.slice(0, count * 4).buffer);
  if (nodata !== null && !Number.isNaN(nodata)) {
    const none = Math.fround(nodata);
    for (let i = 0; i < count; i++) if (out[i] === none) out[i] = NaN;
  }
  return out;
}

function words(data: Uint8Array<ArrayBuffer>, count: number): Uint16Array {
  if (data.byteLength < count * 2) throw new FrameError("a frame has too few samples");
  return new Uint16Array(data.slice(0, count * 2).buffer);
}

function fromSteps(steps: Uint16Array, { offset, quantum }: FrameHeader): Float32Array {
  const out = new Float32Array(steps.length);
  for (let i = 0; i < steps.length; i++) {
    const n = steps[i]!;
    out[i] = n === NO_SAMPLE ? NaN : offset + quantum * n;
  }
  return out;
}

/** Differences along rows; the first column is the difference from the row above. Sums wrap at 65536. */
export function undoDifferences(steps: Uint16Array, rows: number, cols: number): void {
  for (let r = 0; r < rows; r++) {
    const at = r * cols;
    if (r > 0) steps[at] = steps[at]! + steps[at - cols]!;
    for (let c = 1; c < cols; c++) steps[at + c] = steps[at + c]! + steps[at + c - 1]!;
  }
}

/** Inflates zlib data, and stops at `most` bytes: a hostile frame cannot fill the memory. */
async function inflate(data: Uint8Array<ArrayBuffer>, most: number): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([data]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();
  const out = new Uint8Array(most);
  let filled = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    if (filled + value.length > most) {
      await reader.cancel();
      throw new FrameError("a frame inflates to more than its band");
    }
    out.set(value, filled);
    filled += value.length;
  }
  if (filled < most) throw new FrameError("a frame has too few samples");
  return out;
}
