// Painting: a stroke is the brush's places in order, sent in pieces while it is drawn.
import { ask } from "./actions.ts";
import * as store from "./store.ts";
import { extent } from "./raster.ts";

/** Points that are not yet sent: east, north (of the land's own axes), pressure, seconds. */
let points: number[][] = [];
let began = 0;
let timer = 0;

/** The brush's radius, metres. */
export function radius(): number {
  const g = store.ground.value;
  return g ? Math.min(...extent(g)) * store.brushRadius.value : 0;
}

/** How much a stroke raises at its middle, metres. */
export function strength(): number {
  const g = store.ground.value;
  return g ? Math.max(1, g.max - g.min) * store.brushStrength.value * 0.2 : 0;
}

export function strokePoint(at: [number, number], pressure: number): void {
  const g = store.ground.value;
  const tool = store.painting.value;
  if (!g || !tool || tool === "probe") return;
  if (points.length === 0 && timer === 0) began = performance.now();
  const [w, h] = extent(g);
  points.push([g.origin[0] + at[0] + w / 2, g.origin[1] + at[1] + h / 2, pressure || 0.5, (performance.now() - began) / 1000]);
  timer ||= window.setTimeout(flush, 40);
}

function flush(): void {
  timer = 0;
  const tool = store.painting.value;
  if (!points.length || !tool) return;
  const sent = points;
  points = [];
  void ask({ do: "paint", field: "elevation", tool, radius: radius(), strength: strength(), points: sent });
}

export function endStroke(): void {
  window.clearTimeout(timer);
  flush();
}
