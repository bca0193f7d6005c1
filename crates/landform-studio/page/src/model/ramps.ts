// Ramps of colours that are safe for colour-blind eyes: lightness runs one way (after cividis, viridis, batlow's order of lightness).

export type Rgb = [number, number, number];

const STOPS: { [name: string]: string[] } = {
  height: ["#3c6152", "#5b7a59", "#82915f", "#b0a16d", "#d2bb90", "#ebdac3", "#fcf7f0"],
  cividis: ["#00224e", "#1f3d6d", "#4d566d", "#73736e", "#9b9274", "#c9b66b", "#fee838"],
  viridis: ["#440154", "#443a83", "#31688e", "#21908d", "#35b779", "#8fd744", "#fde725"],
  depth: ["#e6eef2", "#9fc4dc", "#5b95c2", "#2d679f", "#173f76", "#0a1f47"],
  signed: ["#2c4d8c", "#6f93c4", "#c3d2e3", "#f2efe9", "#e6c49a", "#c08a4d", "#7a4a1c"],
};

export type RampName = keyof typeof STOPS;

function parse(hex: string): Rgb {
  const n = parseInt(hex.slice(1), 16);
  return [(n >> 16) & 255, (n >> 8) & 255, n & 255];
}

const tables = new Map<string, Uint8Array>();

/** 256 colours, three bytes each. */
export function rampTable(name: string): Uint8Array {
  let table = tables.get(name);
  if (!table) {
    const stops = (STOPS[name] ?? STOPS["cividis"]!).map(parse);
    table = new Uint8Array(768);
    for (let i = 0; i < 256; i++) {
      const at = (i / 255) * (stops.length - 1);
      const k = Math.min(Math.floor(at), stops.length - 2);
      for (let c = 0; c < 3; c++) table[3 * i + c] = Math.round(stops[k]![c]! + (stops[k + 1]![c]! - stops[k]![c]!) * (at - k));
    }
    tables.set(name, table);
  }
  return table;
}

export interface FieldScale {
  ramp: string;
  log: boolean;
  low: number;
  high: number;
}

/** How a field is coloured: areas by their logarithm, rates around zero, the rest from least to greatest. */
export function scaleOf(layer: string, min: number, max: number): FieldScale {
  if (layer === "elevation") return { ramp: "height", log: false, low: min, high: max };
  if (/area|discharge|flux/.test(layer) && max > 0) return { ramp: "viridis", log: true, low: Math.max(min, max * 1e-6), high: max };
  if (/depth|water/.test(layer)) return { ramp: "depth", log: false, low: Math.max(0, min), high: max };
  if (min < 0 && max > 0) {
    const most = Math.max(-min, max);
    return { ramp: "signed", log: false, low: -most, high: most };
  }
  return { ramp: layer === "slope" ? "cividis" : "viridis", log: false, low: min, high: max };
}

/** Position of a value on its scale, 0 to 1. */
export function partOf(value: number, { log, low, high }: FieldScale): number {
  if (!(high > low)) return 0.5;
  const part = log ? Math.log(Math.max(value, low) / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.min(1, Math.max(0, part));
}
