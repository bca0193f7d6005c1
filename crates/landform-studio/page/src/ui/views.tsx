// The middle: the land in three dimensions, the map, or both.
import { useEffect, useRef } from "preact/hooks";
import { colourField, comparing, fields, flickered, hasDunes, keptA, keptB, land, look, lookedAt, recipe, run, shownLook, split, viewing, pastAt, type Viewing } from "../model/store.ts";
import { keep, showWanted } from "../model/actions.ts";
import { LandPane } from "./land_pane.tsx";
import { Legend } from "./legend.tsx";
import { MapPane } from "./map_pane.tsx";
import { Readout } from "./readout.tsx";
import { Button, Segments } from "./parts.tsx";
import { Tools } from "./tools.tsx";
import { words } from "./words.ts";

const VIEWS: { value: Viewing; label: string }[] = [
  { value: "land", label: "3-D" },
  { value: "map", label: "Map" },
  { value: "both", label: "Both" },
];

export function Views() {
  return (
    <main class="views">
      <div class={`panes ${viewing.value}`}>
        {viewing.value !== "map" && <LandPane />}
        {viewing.value !== "land" && <MapPane />}
        {comparing.value === "wipe" && <Wipe />}
        {!land.value && <p class="no-land">{recipe.value?.errors.length ? "The recipe has a mistake; mend it and the land grows again." : "The first preview is on its way…"}</p>}
      </div>
      <Level />
      <div class="view-choices">
        <Colours />
        <Segments label="view" value={viewing.value} choices={VIEWS} onChange={(v) => (viewing.value = v)} />
      </div>
      <Tools />
      <Readout />
      <Legend />
      {comparing.value && <CompareBar />}
    </main>
  );
}

/** What is shown is always said. */
function Level() {
  const s = run.value;
  const g = land.value?.ground;
  const after = lookedAt.value !== null ? recipe.value?.stages[lookedAt.value] : null;
  return (
    <div class="level" data-testid="level">
      <b>{levelText(g?.level ?? s?.level ?? null)}</b>
      {g && <span>{g.cols} × {g.rows}</span>}
      {s?.settling && <span class="settling">settling</span>}
      {s?.running && !s.paused && !s.settling && <span class="busy">working</span>}
      {pastAt.value !== null && <span class="settling">a picture of the past</span>}
      {after && <span class="settling">after {words(after.use).toLowerCase()}</span>}
    </div>
  );
}

function levelText(level: string | null): string {
  if (!level) return "no picture yet";
  return level === "build" || level === "1" || level === "1/1" ? "full size" : `preview ${level}`;
}

function Colours() {
  const names = new Map(fields.value.map((f) => [f.name, f.unit]));
  for (const n of ["elevation", "slope", "drainage_area"]) if (!names.has(n)) names.set(n, "");
  const value = look.value === "field" ? `field:${colourField.value}` : look.value;
  const choose = (v: string) => {
    if (v.startsWith("field:")) {
      colourField.value = v.slice(6);
      look.value = "field";
      showWanted();
    } else look.value = v as typeof look.value;
  };
  return (
    <select class="field compact" aria-label="Colours" data-testid="colours" value={value} onChange={(e) => choose(e.currentTarget.value)}>
      <option value="auto">{hasDunes.value ? "Sand (by the recipe)" : "Natural"}</option>
      {shownLook.value !== "sand" && <option value="sand">Sand</option>}
      {hasDunes.value && <option value="natural">Natural</option>}
      <option value="clay">Clay</option>
      <optgroup label="Fields">
        {[...names.keys()].map((n) => <option key={n} value={`field:${n}`}>{words(n)}</option>)}
      </optgroup>
    </select>
  );
}

/** A line that is dragged between two kept states. */
function Wipe() {
  const bar = useRef<HTMLDivElement>(null);
  const drag = (e: PointerEvent) => {
    const box = bar.current!.parentElement!.getBoundingClientRect();
    split.value = Math.min(1, Math.max(0, (e.clientX - box.left) / box.width));
  };
  return (
    <div
      ref={bar} class="wipe" role="slider" tabIndex={0} aria-label="Wipe between A and B" aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(split.value * 100)}
      style={{ left: `${split.value * 100}%` }}
      onPointerDown={(e) => { e.currentTarget.setPointerCapture(e.pointerId); e.preventDefault(); }}
      onPointerMove={(e) => e.buttons & 1 && drag(e)}
      onKeyDown={(e) => {
        const by = { ArrowLeft: -0.02, ArrowRight: 0.02, Home: -1, End: 1 }[e.key];
        if (by !== undefined) { e.preventDefault(); split.value = Math.min(1, Math.max(0, split.value + by)); }
      }}
    ><i /><b class="chip at-left">A</b><b class="chip at-right">B</b></div>
  );
}

function CompareBar() {
  useEffect(() => {
    if (comparing.value !== "flicker") return;
    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    const timer = window.setInterval(() => (flickered.value = !flickered.value), still ? 2500 : 700);
    return () => window.clearInterval(timer);
  }, [comparing.value]);
  const name = (k: typeof keptA.value, none: string) => k?.name ?? none;
  return (
    <div class="compare-bar" data-testid="compare">
      <span><b class="chip">A</b> {name(keptA.value, "nothing kept").replace(/^A: /, "")}</span>
      <Button label="Keep as A" text kind="quiet" test="keep-a" onClick={() => keep("A")} />
      <span><b class="chip">B</b> {keptB.value ? keptB.value.name.replace(/^B: /, "") : "what is shown now"}</span>
      <Button label="Keep as B" text kind="quiet" test="keep-b" onClick={() => keep("B")} />
      {keptB.value && <Button label="B follows" text kind="quiet" title="B is what is shown now" onClick={() => (keptB.value = null)} />}
      <Segments label="compare" value={comparing.value!} choices={[{ value: "wipe", label: "Wipe" }, { value: "flicker", label: "Flicker" }]} onChange={(v) => (comparing.value = v)} />
      <Button icon="close" label="End the comparison" kind="quiet" onClick={() => (comparing.value = null)} />
    </div>
  );
}
