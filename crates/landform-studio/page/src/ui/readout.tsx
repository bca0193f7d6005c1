// What is under the cursor, as text.
import { signal } from "@preact/signals";
import { areaText, numberText } from "../form/quantity.ts";
import { extent, nearest, sample, slopeAt, toCell } from "../model/raster.ts";
import { brushAt, colourField, ground, land, look, painting, shownLayers } from "../model/store.ts";
import { words } from "./words.ts";

/** East and north of the land's middle, metres. */
export const hover = signal<[number, number] | null>(null);

export function Readout() {
  const at = hover.value ?? (painting.value ? brushAt.value : null);
  const g = ground.value;
  if (!g) return null;
  return <output class="readout" data-testid="readout">{at ? facts(at) : <span class="dim">Drag to turn · Shift-drag to move · Wheel to come nearer · Point to read</span>}</output>;
}

function facts([east, north]: [number, number]) {
  const g = ground.value!;
  const [w, h] = extent(g);
  const [col, row] = toCell(g, east, north);
  const z = sample(g, col, row);
  const area = shownLayers.value.get("drainage_area");
  const drained = area && area.rows === g.rows ? nearest(area, col, row) : NaN;
  const depth = land.value?.depth ? nearest({ ...g, z: land.value.depth }, col, row) : NaN;
  const rows: [string, string][] = [
    ["x", `${Math.round(g.origin[0] + east + w / 2).toLocaleString("en")} m`],
    ["y", `${Math.round(g.origin[1] + north + h / 2).toLocaleString("en")} m`],
    ["elevation", Number.isNaN(z) ? "none" : `${numberText(z, 5)} m`],
    ["slope", `${((Math.atan(slopeAt(g, col, row)) * 180) / Math.PI).toFixed(1)}°`],
  ];
  if (Number.isFinite(drained)) rows.push(["drains", areaText(drained)]);
  if (depth > 0) rows.push(["water", `${numberText(depth, 3)} m deep`]);
  const name = colourField.value;
  const field = look.value === "field" && !["elevation", "slope", "drainage_area"].includes(name) ? shownLayers.value.get(name) : undefined;
  if (field) rows.push([words(name), numberText(nearest(field, col, row), 4)]);
  return rows.map(([k, v]) => <span key={k}><i>{k}</i> {v}</span>);
}
