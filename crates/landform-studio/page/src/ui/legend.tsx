// What the colours mean.
import { useEffect, useRef } from "preact/hooks";
import { areaText, numberText } from "../form/quantity.ts";
import { landScale } from "../map/paint.ts";
import { rampTable } from "../model/ramps.ts";
import { colourField, fields, land, viewing } from "../model/store.ts";
import { words } from "./words.ts";

const UNITS: { [name: string]: string } = { elevation: "m", slope: "°", drainage_area: "m²", lake_depth: "m" };

export function Legend() {
  const state = land.value;
  const bar = useRef<HTMLCanvasElement>(null);
  const field = state?.field ?? null;
  const scale = field?.scale ?? (state && viewing.value !== "land" ? landScale(state) : null);
  const ramp = scale?.ramp;
  useEffect(() => {
    const canvas = bar.current;
    if (!canvas || !ramp) return;
    const table = rampTable(ramp);
    const context = canvas.getContext("2d")!;
    const image = context.createImageData(256, 1);
    for (let i = 0; i < 256; i++) {
      for (let c = 0; c < 3; c++) image.data[4 * i + c] = table[3 * i + c]!;
      image.data[4 * i + 3] = 255;
    }
    context.putImageData(image, 0, 0);
  }, [ramp]);
  if (!scale) return null;
  const name = field ? colourField.value : "elevation";
  const unit = UNITS[name] ?? fields.value.find((f) => f.name === name)?.unit.replace("m2", "m²") ?? "";
  const end = (v: number, digits: number) => (unit === "m²" ? areaText(v) : numberText(v, digits));
  return (
    <div class="legend" data-testid="legend">
      <span class="legend-name">{words(name)}{unit && unit !== "1" && unit !== "m²" ? `, ${unit}` : ""}{scale.log ? " (log)" : ""}</span>
      <canvas ref={bar} width={256} height={1} />
      <span class="legend-ends"><span>{end(scale.low, 3)}</span><span>{end(scale.high, 4)}</span></span>
    </div>
  );
}
