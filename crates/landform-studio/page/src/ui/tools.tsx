// Tools at the left of the view: the brush, light, height, contours.
import { signal } from "@preact/signals";
import { lengthText, numberText } from "../form/quantity.ts";
import { endStroke, radius, strength, strokePoint } from "../model/brush.ts";
import { extent } from "../model/raster.ts";
import { brushAt, brushRadius, brushStrength, contours, ground, homeAsked, mapContours, paintTarget, painting, showLakes, sunAzimuth, sunHeight, tall, viewing, welcome, type Tool } from "../model/store.ts";
import { Button, ViewSlider } from "./parts.tsx";

const TOOLS: { tool: Tool; label: string; key: string }[] = [
  { tool: "probe", label: "Probe: read the ground at a place", key: "q" },
  { tool: "raise", label: "Raise", key: "w" },
  { tool: "lower", label: "Lower", key: "e" },
  { tool: "smooth", label: "Smooth", key: "r" },
  { tool: "level", label: "Level", key: "t" },
];

/** Tools of which the server knows what to do. */
function offered(): typeof TOOLS {
  const can = welcome.value?.can ?? [];
  if (paintTarget.value) return TOOLS.filter((t) => t.tool !== "smooth");
  return can.includes("paint") ? TOOLS : TOOLS.filter((t) => t.tool === "probe");
}

const lightOpen = signal(false);

export function Tools() {
  const tool = painting.value;
  const target = paintTarget.value;
  return (
    <div class="tools" role="toolbar" aria-label="Tools" aria-orientation="vertical">
      <Button icon="home" label="The whole land (Home)" kind="quiet" onClick={() => homeAsked.value++} />
      <Button icon="sun" label="Light and height" kind="quiet" test="light" pressed={lightOpen.value} onClick={() => (lightOpen.value = !lightOpen.value)} />
      <hr />
      {offered().map((t) => (
        <Button key={t.tool} icon={t.tool} label={`${t.label} (${t.key.toUpperCase()})`} kind="quiet" test={`tool-${t.tool}`} pressed={tool === t.tool} onClick={() => choose(tool === t.tool ? null : t.tool)} />
      ))}
      {(lightOpen.value || (tool && tool !== "probe")) && (
        <div class="tool-panel">
          {lightOpen.value && (
            <>
              <ViewSlider label="Sun from" value={sunAzimuth.value} low={0} high={360} step={2} text={`${sunAzimuth.value}°`} onInput={(v) => (sunAzimuth.value = v)} />
              <ViewSlider label="Sun height" value={sunHeight.value} low={4} high={80} step={1} text={`${sunHeight.value}°`} onInput={(v) => (sunHeight.value = v)} />
              <ViewSlider label="Heights" value={Math.log2(tall.value)} low={-1} high={4} step={0.25} text={`× ${Number(tall.value.toFixed(2))}`} onInput={(v) => (tall.value = 2 ** v)} />
              <label class="check"><input type="checkbox" class="switch" checked={viewing.value === "map" ? mapContours.value : contours.value} onChange={(e) => setContours(e.currentTarget.checked)} /> Contours</label>
              <label class="check"><input type="checkbox" class="switch" checked={showLakes.value} onChange={(e) => (showLakes.value = e.currentTarget.checked)} /> Lakes in hollows</label>
            </>
          )}
          {tool && tool !== "probe" && (
            <>
              {target && (
                <p class="painting">
                  <span>Painting <b>{target.label}</b></span>
                  <Button label="Ground instead" text kind="quiet" onClick={() => (paintTarget.value = null)} />
                </p>
              )}
              <ViewSlider label="Radius" value={brushRadius.value} low={0.005} high={0.3} step={0.005} text={lengthText(radius())} onInput={(v) => (brushRadius.value = v)} />
              <ViewSlider label="Strength" value={brushStrength.value} low={0.02} high={1} step={0.02} text={strengthText(tool)} onInput={(v) => (brushStrength.value = v)} />
            </>
          )}
        </div>
      )}
    </div>
  );
}

function strengthText(tool: Tool): string {
  if (paintTarget.value) return `${numberText(strength(), 2)} ${paintTarget.value.unit}`;
  return tool === "smooth" ? `${Math.round(brushStrength.value * 100)} %` : lengthText(strength());
}

function setContours(on: boolean): void {
  if (viewing.value !== "land") mapContours.value = on;
  if (viewing.value !== "map") contours.value = on;
}

function choose(tool: Tool | null): void {
  painting.value = tool;
  if (!tool || tool === "probe") paintTarget.value = null;
  if (tool && !brushAt.value) brushAt.value = [0, 0];
}

/** Keys of the brush on a view; true where the key was one. */
export function brushKey(e: KeyboardEvent): boolean {
  if (e.ctrlKey || e.metaKey || e.altKey) return false;
  const chosen = offered().find((t) => t.key === e.key.toLowerCase());
  if (chosen) {
    choose(painting.value === chosen.tool ? null : chosen.tool);
    return true;
  }
  const g = ground.value;
  if (!painting.value || !g) return false;
  const arrows: { [key: string]: [number, number] } = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const way = arrows[e.key];
  if (way) {
    const [w, h] = extent(g);
    const step = Math.max(w, h) * (e.shiftKey ? 0.05 : 0.01);
    const [x, y] = brushAt.value ?? [0, 0];
    const within = (v: number, half: number) => Math.min(half, Math.max(-half, v));
    brushAt.value = [within(x + way[0] * step, w / 2), within(y + way[1] * step, h / 2)];
    return true;
  }
  switch (e.key) {
    case " ":
      if (brushAt.value && painting.value !== "probe") {
        strokePoint(brushAt.value, 0.5);
        endStroke();
      }
      return true;
    case "[": brushRadius.value = Math.max(0.005, brushRadius.value / 1.15); return true;
    case "]": brushRadius.value = Math.min(0.3, brushRadius.value * 1.15); return true;
    case ",": brushStrength.value = Math.max(0.02, brushStrength.value / 1.2); return true;
    case ";": brushStrength.value = Math.min(1, brushStrength.value * 1.2); return true;
    default: return false;
  }
}
