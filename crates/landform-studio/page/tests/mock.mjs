// A stand-in for the server: the same words, a small erosion model, no files. `node tests/mock.mjs [PORT]`.
// LAND=heights.npy (32-bit floats; SEA=0: sea level, CELL=30: metres) shows these heights instead of the model's.
import { createServer } from "node:http";
import { readFile, readdir } from "node:fs/promises";
import { dirname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";
import { WebSocketServer } from "ws";
import { Ground } from "./erode.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const assets = join(here, "..", "..", "assets");
const YEAR = 31_557_600;
const KINDS = { ".html": "text/html; charset=utf-8", ".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8", ".svg": "image/svg+xml", ".jpg": "image/jpeg", ".png": "image/png" };
const STAGES = [
  ["stream_graph", "create", "ground", "An almost flat irregular mesh for rivers. Unlike a raster it prefers no direction."],
  ["spectral_fbm", "create", "ground", "Fractional Brownian ground: rough at every scale, without rivers."],
  ["evolve", "evolve", "time", "Runs several processes on one clock."],
  ["uplift", "evolve", "tectonics", "Tectonic uplift: raises every node that is not held at base level."],
  ["stream_power", "evolve", "rivers", "Stream-power erosion: rivers cut their beds and may deposit sediment."],
  ["linear_diffusion", "evolve", "slopes", "Soil creep: ground moves downhill at a rate in proportion to its slope."],
  ["crop", "change", "ground", "Cuts a part out of the land."],
  ["write_heightmap", "write", "files", "Writes elevation as a height map for an engine."],
].map(([name, verb, folder, summary]) => ({ name, verb, folder, summary, text: summary, sources: name === "stream_power" ? [{ authors: "Braun & Willett (2013)", title: "A very efficient O(n), implicit and parallel method", doi: "10.1016/j.geomorph.2012.10.008" }] : [] }));

const DEFAULTS = {
  uplift: { rate: "0.5 mm/yr" },
  stream_power: { erodibility: null, area_exponent: 0.5, slope_exponent: 1, talus_angle: null, deposition: 0 },
  linear_diffusion: { diffusivity: "0.01 m2/yr" },
};

/** Heights of a file of NumPy (little-endian 32-bit floats, rows first). */
async function readNpy(path) {
  const bytes = await readFile(path);
  const length = bytes.readUInt16LE(8);
  const [rows, cols] = /\((\d+), (\d+)/.exec(bytes.toString("latin1", 10, 10 + length)).slice(1).map(Number);
  return { rows, cols, z: new Float32Array(bytes.buffer.slice(bytes.byteOffset + 10 + length, bytes.byteOffset + 10 + length + rows * cols * 4)) };
}

const land = process.env.LAND ? await readNpy(process.env.LAND) : null;

class Studio {
  constructor(say, send) {
    Object.assign(this, { say, send, revision: 0, frame: 0, seed: 7, title: null, stages: [], undone: [], done: [], unacknowledged: 0, timer: null });
    this.run = { running: false, paused: false, settling: false, level: null, stage: null, of: null, name: null, steps: null, time: null, part: null, residual: null, memory_bytes: 61_000_000, seconds: null, seconds_left: null, building: null };
  }

  snapshot() {
    return JSON.stringify({ seed: this.seed, title: this.title, stages: this.stages });
  }

  change(act) {
    this.typed = null;
    this.done.push(this.snapshot());
    this.undone = [];
    act();
    this.tellRecipe();
  }

  text() {
    if (this.typed) return this.typed;
    const inline = (t) => Object.entries(t).map(([k, v]) => `${k} = ${JSON.stringify(v)}`).join(", ");
    const stage = (s) => {
      const rows = [`[[stage]]`, `use = "${s.use}"`, ...Object.entries(s.given).map(([k, v]) => (k === "clock" ? `clock = { ${inline(v)} }` : `${k} = ${JSON.stringify(v)}`))];
      if (s.processes.length) rows.push("process = [", ...s.processes.map((p) => `  { use = "${p.use}"${Object.keys(p.given).length ? ", " + inline(p.given) : ""} },`), "]");
      return rows.map((r) => (s.on ? r : `#off ${r}`)).join("\n");
    };
    return this.stages.length ? `# A stand-in for a recipe.\nseed = ${this.seed}\ntitle = "${this.title}"\n\n${this.stages.map(stage).join("\n\n")}\n` : "";
  }

  tellRecipe(errors = []) {
    this.revision++;
    this.say({
      tell: "recipe", revision: this.revision, title: this.title, path: null, text: this.text(), saved: this.done.length === 0, seed: this.seed, can_undo: this.done.length > 0,
      can_redo: this.undone.length > 0, command: `landform run ${(this.title ?? "land").toLowerCase().replaceAll(" ", "_")}.toml --seed ${this.seed}`, errors, given: { seed: this.seed, title: this.title },
      stages: this.stages.map((s, index) => ({ ...s, index, label: null, verb: "", line: 1, values: { ...DEFAULTS[s.use], ...s.given }, seconds: [0.021, 1.8, 0.004][index] ?? null, nodes: index ? 36_864 : null, notes: [], processes: s.processes.map((p) => ({ ...p, values: { ...DEFAULTS[p.use], ...p.given } })) })),
    });
  }

  open(title) {
    this.done = [];
    this.undone = [];
    this.title = title;
    this.stages = [
      { use: "stream_graph", on: true, given: { size: ["32768 m", "32768 m"], nodes: 20000 }, processes: [] },
      { use: "evolve", on: true, given: { clock: { dt: "100 kyr", duration: "8 Myr" } }, processes: [
        { use: "uplift", given: { rate: "0.5 mm/yr" } }, { use: "stream_power", given: { erodibility: "2e-6 1/yr", area_exponent: 0.5 } }, { use: "linear_diffusion", given: {} }] },
      { use: "write_heightmap", on: true, given: { preset: "unreal", path: "land.png" }, processes: [] },
    ];
    this.tellRecipe();
    this.start("auto");
  }

  rates() {
    const given = this.stages[1]?.processes ?? [];
    const number = (v, other) => (typeof v === "string" || typeof v === "number" ? parseFloat(v) : other);
    return { uplift: number(given.find((p) => p.use === "uplift")?.given.rate, 0) * 1e-3, erodibility: number(given.find((p) => p.use === "stream_power")?.given.erodibility, 2e-6) };
  }

  start(level, stamp = null) {
    clearTimeout(this.timer);
    if (land) return this.showLand(stamp);
    const levels = level === "auto" ? [[96, "1/4"], [192, "1/2"]] : [[192, "1/2"]];
    const grow = ([size, name], rest) => {
      const ground = new Ground(size, 32768 / size, this.seed);
      let n = 0;
      const step = () => {
        if (this.run.paused || this.unacknowledged > 2) return (this.timer = setTimeout(step, 30));
        const { uplift, erodibility } = this.rates();
        ground.step(100_000, uplift, erodibility);
        n++;
        this.ground = ground;
        this.level = name;
        const over = n >= 80;
        this.tellRun({ running: !over || rest.length > 0, level: name, stage: 1, of: 3, name: "evolve", steps: n, time: ground.time * YEAR, part: n / 80, seconds: n * 0.05, seconds_left: (80 - n) * 0.05 });
        if (level !== "auto" || over || n === 1) this.picture(ground, name, over ? stamp : null);
        if (!over) return (this.timer = setTimeout(step, level === "auto" ? 0 : 40));
        this.tellCharts(ground, name);
        if (rest.length) this.timer = setTimeout(() => grow(rest[0], rest.slice(1)), 10);
      };
      step();
    };
    this.run.paused = false;
    grow(levels[0], levels.slice(1));
  }

  showLand(stamp) {
    const { rows, cols, z } = land;
    const cell = Number(process.env.CELL ?? 30), sea = process.env.SEA === undefined ? null : Number(process.env.SEA);
    this.frame++;
    for (let row0 = 0; row0 < rows; row0 += 256) {
      const band_rows = Math.min(256, rows - row0);
      this.send(encode({
        protocol: 1, session: "mock", revision: this.revision, frame: this.frame, layer: "elevation", level: "build", rows, cols, row0, band_rows, last: row0 + band_rows === rows,
        cell_size: [cell, cell], origin: [0, 0], time: 0, stage: 1, encoding: "f32", nodata: null, sea_level: sea, stamp,
      }, z.subarray(row0 * cols, (row0 + band_rows) * cols)));
    }
    this.tellRun({ level: "build", running: false });
  }

  tellRun(change) {
    Object.assign(this.run, change);
    this.say({ tell: "state", ...this.run });
  }

  picture(ground, level, stamp) {
    this.frame++;
    this.unacknowledged++;
    const lakes = ground.z.map(() => 0);
    const layers = [["elevation", ground.z, "u16_delta_deflate"], ["drainage_area", ground.area, "f32"], ["lake_depth", lakes, "u16"]];
    layers.forEach(([layer, z, encoding], k) => {
      const half = ground.size >> 1;
      [[0, half], [half, ground.size - half]].forEach(([row0, band_rows], b) => {
        const part = z.slice(row0 * ground.size, (row0 + band_rows) * ground.size);
        this.send(encode({
          protocol: 1, session: "mock", revision: this.revision, frame: this.frame, layer, level, rows: ground.size, cols: ground.size, row0, band_rows, last: k === 2 && b === 1,
          cell_size: [ground.cell, ground.cell], origin: [0, 0], time: ground.time * YEAR, stage: 1, encoding, nodata: null, sea_level: null, stamp,
        }, part));
      });
    });
  }

  tellCharts(ground, level) {
    const sorted = [...ground.z].sort((a, b) => a - b);
    const max = sorted.at(-1);
    const counts = new Array(40).fill(0);
    for (const v of sorted) counts[Math.min(39, Math.floor((v / max) * 40))]++;
    this.say({
      tell: "charts", revision: this.revision, level, summary: { min: sorted[0], max, mean: sorted.reduce((a, b) => a + b, 0) / sorted.length, relief: max },
      histogram: { edges: Array.from({ length: 41 }, (_, i) => (max * i) / 40), counts },
      hypsometry: Array.from({ length: 51 }, (_, i) => [i / 50, sorted[Math.round((sorted.length - 1) * (1 - i / 50))]]),
      slope_area: Array.from({ length: 24 }, (_, i) => [10 ** (4 + i / 6), 3 * 10 ** (-0.45 * (4 + i / 6) + 1.4)]),
      card: [{ name: "hack_exponent", value: 0.56, low: 0.49, high: 0.6, unit: "1", verdict: "inside" }, { name: "drainage_density", value: 2.9, low: 0.5, high: 2.5, unit: "1/km", verdict: "outside" }],
    });
  }

  ask(m) {
    switch (m.do) {
      case "hello":
        this.say({ tell: "welcome", protocol: 1, version: "mock", session: "mock", root: "/mock", output: "/mock/out", can: ["paint", "stroke"] });
        this.say({ tell: "fields", names: [{ name: "elevation", unit: "m" }, { name: "drainage_area", unit: "m2" }, { name: "lake_depth", unit: "m" }] });
        this.tellRecipe();
        this.tellRun({});
        if (this.ground) this.picture(this.ground, this.level, null);
        return;
      case "open": return this.open(m.gallery.replace(/^\d+_/, "").replaceAll("_", " ").replace(/^./, (c) => c.toUpperCase()));
      case "set": return this.set(m);
      case "toggle": return this.change(() => (this.stages[m.stage].on = !this.stages[m.stage].on));
      case "remove": return this.change(() => (m.process === null ? this.stages.splice(m.stage, 1) : this.stages[m.stage].processes.splice(m.process, 1)));
      case "move": return this.change(() => this.stages.splice(m.to, 0, ...this.stages.splice(m.stage, 1)));
      case "insert": return this.change(() => (m.process_of === null ? this.stages.splice(m.at, 0, { use: m.use, on: true, given: {}, processes: [] }) : this.stages[m.process_of].processes.splice(m.at, 0, { use: m.use, given: {} })));
      case "undo": case "redo": {
        const [from, to] = m.do === "undo" ? [this.done, this.undone] : [this.undone, this.done];
        if (!from.length) return { what: `there is nothing to ${m.do}` };
        to.push(this.snapshot());
        Object.assign(this, JSON.parse(from.pop()));
        this.tellRecipe();
        return this.start("auto");
      }
      case "run": return this.start(m.level);
      case "play": if (this.run.paused && this.run.running) return this.tellRun({ paused: false }); return this.start("1/2");
      case "pause": return this.tellRun({ paused: true });
      case "step": return;
      case "stop": clearTimeout(this.timer); return this.tellRun({ running: false, paused: false });
      case "ack": this.unacknowledged = Math.max(0, this.unacknowledged - 1); return;
      case "text": this.typed = m.text; this.tellRecipe(!/\[\[stag\]\]/.test(m.text) ? [] : [{ line: 1, column: 1, what: "the key `stag` is not known", hint: "Did you mean `stage`?", stage: null }]); return;
      case "paint": return this.paint(m);
      case "stroke": return this.change(() => {
        const given = this.stages[m.stage].processes[m.process].given, held = given[m.key[0]];
        const strokes = held?.strokes ?? [];
        given[m.key[0]] = { strokes: [...strokes, { tool: m.tool, radius: m.radius, strength: m.strength, points: m.points }], base: held?.base ?? held ?? "0.5 mm/yr" };
      });
      case "contact": return m.seeds.forEach((seed, i) => setTimeout(() => this.say({ tell: "contact", seed, png: thumbnail(seed) }), 120 * (i + 1)));
      case "build": this.tellRun({ building: { what: "build", stage: 1, of: 3, name: "evolve", part: 0.4, seconds: 1, waiting: 0 } }); setTimeout(() => { this.tellRun({ building: null }); this.say({ tell: "built", files: [{ path: "land.png", bytes: 2_100_000 }], seconds: 3.2 }); }, 800); return;
      case "export": this.say({ tell: "built", files: [{ path: m.parameters.path ?? "file", bytes: 1_400_000 }], seconds: 1 }); return;
      case "show": case "save": case "command": case "cancel_build": return;
      default: return { what: `\`${m.do}\` is not known` };
    }
  }

  set(m) {
    const act = () => {
      if (m.stage === null) return m.key[0] === "seed" ? (this.seed = m.value) : m.key[0] === "title" ? (this.title = m.value) : null;
      const step = m.process === null ? this.stages[m.stage] : this.stages[m.stage].processes[m.process];
      const table = m.key.length > 1 ? (step.given[m.key[0]] ??= {}) : step.given;
      if (m.value === null) delete table[m.key.at(-1)];
      else table[m.key.at(-1)] = m.value;
    };
    if (m.dragging) { if (!this.dragging) this.done.push(this.snapshot()); this.dragging = true; act(); this.tellRecipe(); }
    else { if (this.dragging) { act(); this.tellRecipe(); } else this.change(act); this.dragging = false; }
    if (m.dragging && this.ground) {
      const { uplift, erodibility } = this.rates();
      clearTimeout(this.timer);
      this.ground.step(100_000, uplift, erodibility);
      const received = Date.now();
      this.tellRun({ running: true, settling: true });
      this.say({ tell: "latency", stamp: m.stamp, received, computed: Date.now(), sent: Date.now() });
      this.picture(this.ground, this.level, m.stamp);
    } else {
      this.tellRun({ settling: false });
      this.start("auto");
    }
  }

  paint(m) {
    const { ground } = this;
    if (!ground) return { what: "there is no ground" };
    for (const [x, y] of m.points) {
      for (let i = 0; i < ground.z.length; i++) {
        const d = Math.hypot((i % ground.size) * ground.cell - x, (ground.size - 1 - Math.floor(i / ground.size)) * ground.cell - y) / m.radius;
        if (d < 1) ground.z[i] += (m.tool === "lower" ? -1 : 1) * m.strength * 0.15 * (1 - d * d) ** 2;
      }
    }
    this.picture(ground, this.level, null);
  }
}

/** A frame as PROTOCOL describes it. */
export function encode(header, values) {
  let min = Infinity, max = -Infinity;
  for (const v of values) { min = Math.min(min, v); max = Math.max(max, v); }
  const quantum = header.encoding === "f32" ? 0 : Math.max((max - min) / 65534, 1e-6);
  let data;
  if (header.encoding === "f32") data = Buffer.from(Float32Array.from(values).buffer);
  else {
    const steps = Uint16Array.from(values, (v) => (Number.isNaN(v) ? 65535 : Math.round((v - min) / quantum)));
    if (header.encoding === "u16") data = Buffer.from(steps.buffer);
    else {
      const { cols } = header;
      const differences = steps.map((n, i) => n - (i % cols ? steps[i - 1] : i ? steps[i - cols] : 0));
      data = deflateSync(Buffer.from(differences.buffer));
    }
  }
  const head = Buffer.from(JSON.stringify({ ...header, quantum, offset: min, min, max }));
  const padding = Buffer.alloc((8 - ((4 + head.length) % 8)) % 8);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(head.length);
  return Buffer.concat([length, head, padding, data]);
}

/** A grey picture (PNG) of a small land grown with a seed. */
function thumbnail(seed) {
  const ground = new Ground(64, 512, seed);
  for (let i = 0; i < 25; i++) ground.step(200_000, 5e-4, 2e-6);
  const max = Math.max(...ground.z);
  const rows = Buffer.alloc(64 * 65);
  for (let r = 0; r < 64; r++) for (let c = 0; c < 64; c++) rows[r * 65 + 1 + c] = 30 + (200 * ground.z[r * 64 + c]) / max;
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type), data]), out = Buffer.alloc(body.length + 8);
    out.writeUInt32BE(data.length);
    body.copy(out, 4);
    out.writeUInt32BE(crc(body), body.length + 4);
    return out;
  };
  const head = Buffer.from([0, 0, 0, 64, 0, 0, 0, 64, 8, 0, 0, 0, 0]);
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", head), chunk("IDAT", deflateSync(rows)), chunk("IEND", Buffer.alloc(0))]).toString("base64");
}

function crc(bytes) {
  let c = ~0;
  for (const b of bytes) {
    c ^= b;
    for (let k = 0; k < 8; k++) c = c & 1 ? (c >>> 1) ^ 0xedb88320 : c >>> 1;
  }
  return ~c >>> 0;
}

async function gallery() {
  const names = (await readdir(join(assets, "gallery")).catch(() => [])).sort();
  return names.map((file) => {
    const name = file.replace(/\.\w+$/, "");
    return { name, title: name.replace(/^\d+_/, "").replaceAll("_", " ").replace(/^./, (c) => c.toUpperCase()), look: "Look at the valleys and the ridges between them.", picture: `/gallery/${file}` };
  });
}

export async function serve(port = 0) {
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    const json = (value) => response.setHeader("content-type", "application/json").end(JSON.stringify(value));
    response.setHeader("content-security-policy", "default-src 'self'");
    try {
      if (path === "/schema.json") return response.setHeader("content-type", "application/json").end(await readFile(join(here, "schema.json")));
      if (path === "/stages.json") return json(STAGES);
      if (path === "/gallery.json") return json(await gallery());
      const file = path === "/" ? "/index.html" : path;
      response.setHeader("content-type", KINDS[/\.\w+$/.exec(file)?.[0]] ?? "application/octet-stream");
      response.end(await readFile(join(assets, file)));
    } catch {
      response.writeHead(404).end();
    }
  });
  new WebSocketServer({ server, path: "/session" }).on("connection", (socket) => {
    const studio = new Studio((told) => socket.send(JSON.stringify(told)), (frame) => socket.send(frame));
    socket.on("message", (text) => {
      const m = JSON.parse(text);
      const refused = studio.ask(m);
      socket.send(JSON.stringify(refused?.what ? { tell: "refused", request: m.request, what: refused.what, hint: null } : { tell: "done", request: m.request }));
    });
    socket.on("close", () => clearTimeout(studio.timer));
  });
  await new Promise((ready) => server.listen(port, "127.0.0.1", ready));
  return server;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const server = await serve(Number(process.argv[2] ?? 8123));
  console.log(`http://127.0.0.1:${server.address().port}/`);
}
