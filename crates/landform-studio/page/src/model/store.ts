// All that the page shows, as signals.
import { computed, signal } from "@preact/signals";
import { Forms, type Schema } from "../form/schema.ts";
import type { Look, LandState } from "../land/state.ts";
import type { BuiltFile, Charts, GalleryEntry, Place, Recipe, RunState, StageInfo, Welcome } from "../protocol/messages.ts";
import { covers } from "./materials.ts";
import { scaleOf } from "./ramps.ts";
import { slopeRaster, type Raster } from "./raster.ts";
import { waterDepth } from "./water.ts";

export type Selected = { stage: number; process: number | null } | null;
export type Viewing = "land" | "map" | "both";
export type Dialog = "gallery" | "add" | "export" | "contact" | "keys" | null;
export type Tool = "probe" | "raise" | "lower" | "smooth" | "level";
export type Tab = "step" | "recipe" | "measures" | "text";

export interface LogLine {
  kind: "note" | "error" | "latency";
  text: string;
  at: number;
}

export interface Latency {
  server: number;
  whole: number;
}

export const connected = signal(false);
export const welcome = signal<Welcome | null>(null);
export const recipe = signal<Recipe | null>(null);
export const run = signal<RunState | null>(null);
export const charts = signal<Charts | null>(null);
export const fields = signal<{ name: string; unit: string }[]>([]);
export const stages = signal<StageInfo[]>([]);
export const forms = signal<Forms>(new Forms({} as Schema));
export const gallery = signal<GalleryEntry[]>([]);
export const built = signal<{ files: BuiltFile[]; seconds: number } | null>(null);
/** What a build, an export or a picture of a seed failed with. */
export const failed = signal<string | null>(null);
export const contact = signal<{ seed: number; picture: string | null }[]>([]);
export const log = signal<LogLine[]>([]);
export const said = signal("");
export const latency = signal<Latency | null>(null);
export const latencies: number[] = [];

export const selected = signal<Selected>(null);
export const dialog = signal<Dialog>(null);
export const addInto = signal<number | null>(null);
export const viewing = signal<Viewing>("land");
export const logOpen = signal(false);
export const tab = signal<Tab>("step");

export const look = signal<Look | "auto">("auto");
export const colourField = signal("elevation");
export const contours = signal(false);
export const mapContours = signal(true);
export const tall = signal(1);
export const sunAzimuth = signal(292);
export const sunHeight = signal(30);

/** Grows by one when the whole land shall be shown. */
export const homeAsked = signal(0);

/** Whether hollows are shown as lakes; not in deserts. */
export const showLakes = signal(true);
/** Step whose ground is looked at; null: the last. */
export const lookedAt = signal<number | null>(null);

export const painting = signal<Tool | null>(null);
/** A value of the recipe that is painted instead of the ground. */
export interface PaintTarget {
  place: Place;
  label: string;
  unit: string;
  /** A usual number of it, in the unit. */
  typical: number;
}
export const paintTarget = signal<PaintTarget | null>(null);
export const brushRadius = signal(0.06);
export const brushStrength = signal(0.3);
export const brushAt = signal<[number, number] | null>(null);

/** Layers of the newest picture. */
export const layers = signal<Map<string, Raster>>(new Map());
/** Pictures of the past, oldest first. */
export const past = signal<Map<string, Raster>[]>([]);
/** Which of them is shown; null: the newest. */
export const pastAt = signal<number | null>(null);
export const keptA = signal<Kept | null>(null);
export const keptB = signal<Kept | null>(null);
export const comparing = signal<"wipe" | "flicker" | null>(null);
export const split = signal(0.5);
export const flickered = signal(false);

export interface Kept {
  name: string;
  state: LandState;
}

export const hasRecipe = computed(() => (recipe.value?.stages.length ?? 0) > 0 || (recipe.value?.text.trim() ?? "") !== "");
export const shownLayers = computed(() => (pastAt.value === null ? layers.value : (past.value[pastAt.value] ?? layers.value)));
export const ground = computed(() => shownLayers.value.get("elevation") ?? null);
export const hasDunes = computed(() => recipe.value?.stages.some((s) => s.on && (s.use === "dunes" || s.processes.some((p) => p.use === "dunes"))) ?? false);

const ownMaterials = computed(() => Object.keys((recipe.value?.given?.["materials"] ?? {}) as object));

/** How the land is coloured. */
export const shownLook = computed<Look>(() => (look.value !== "auto" ? look.value : hasDunes.value ? "sand" : "natural"));

/** The state that views draw. */
export const land = computed<LandState | null>(() => {
  const elevation = ground.value;
  if (!elevation) return null;
  const all = shownLayers.value;
  const like = (name: string) => {
    const layer = all.get(name);
    return layer && layer.rows === elevation.rows && layer.cols === elevation.cols ? layer : null;
  };
  const material = like("surface_material");
  const depth = waterDepth(elevation, showLakes.value && !hasDunes.value ? like("lake_depth") : null);
  const name = colourField.value;
  const raster = name === "slope" ? (like("slope") ?? slopeRaster(elevation)) : like(name);
  const coloured = shownLook.value === "field" && raster;
  return {
    ground: elevation, depth, drainage: like("drainage_area"), material: material && { raster: material, covers: covers(ownMaterials.value) },
    field: coloured ? { raster, scale: scaleOf(name, raster.min, raster.max) } : null,
  };
});

/** Stages where the snow line is drawn: mountains have it, low land has none. */
export const snowLine = computed(() => {
  const g = ground.value;
  if (!g) return 2;
  const relief = g.max - Math.max(g.min, g.sea ?? g.min);
  return relief > 1500 ? 0.74 : relief > 800 ? 0.84 : 2;
});

export function note(kind: LogLine["kind"], text: string): void {
  log.value = [...log.value.slice(-399), { kind, text, at: Date.now() }];
}

/** Says something to those who cannot see it. */
export function say(text: string): void {
  said.value = text;
}
