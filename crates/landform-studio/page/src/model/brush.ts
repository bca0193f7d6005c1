// Painting: on the ground that is shown, in pieces while the hand moves; on a value of the recipe, one stroke when it lifts.
import { numberText } from "../form/quantity.ts";
import { ask } from "./actions.ts";
import { extent } from "./raster.ts";
import * as store from "./store.ts";

/** Places of the brush that are not yet sent: x, y, pressure, seconds. */
let points: number[][] = [];
let began = 0;
let timer = 0;
/** Distance between points of a stroke that is kept in the text, in parts of the radius. */
const SPARSE = 0.25;

/** The brush's radius, metres. */
export function radius(): number {
  const g = store.ground.value;
  return g ? Math.min(...extent(g)) * store.brushRadius.value : 0;
}

/** What a stroke does at its middle: metres, or the unit of the painted value. */
export function strength(): number {
  const target = store.paintTarget.value;
  if (target) return (target.typical * store.brushStrength.value) / 0.3;
  const g = store.ground.value;
  return g ? Math.max(1, g.max - g.min) * store.brushStrength.value * 0.2 : 0;
}

export function strokePoint(at: [number, number], pressure: number): void {
  const g = store.ground.value;
  const tool = store.painting.value;
  if (!g || !tool || tool === "probe") return;
  if (points.length === 0 && timer === 0) began = performance.now();
  const [w, h] = extent(g);
  const point = [g.origin[0] + at[0] + w / 2, g.origin[1] + at[1] + h / 2, pressure || 0.5, (performance.now() - began) / 1000];
  if (store.paintTarget.value) {
    const last = points.at(-1);
    if (!last || Math.hypot(point[0]! - last[0]!, point[1]! - last[1]!) > SPARSE * radius()) points.push(point.map((v) => Number(v.toFixed(2))));
    return;
  }
  points.push(point);
  timer ||= window.setTimeout(flush, 40);
}

function flush(): void {
  timer = 0;
  const tool = store.painting.value;
  const target = store.paintTarget.value;
  if (!points.length || !tool) return;
  const sent = points;
  points = [];
  if (!target) {
    void ask({ do: "paint", field: "elevation", tool, radius: radius(), strength: strength(), points: sent });
    return;
  }
  const amount = Number(numberText(strength(), 3));
  void ask({ do: "stroke", ...target.place, tool, radius: Math.round(radius() * 10) / 10, strength: amount, points: sent }).then((answer) => {
    if (answer.ok) store.say(`A stroke of ${target.label} is in the recipe.`);
  });
}

export function endStroke(): void {
  window.clearTimeout(timer);
  flush();
}
