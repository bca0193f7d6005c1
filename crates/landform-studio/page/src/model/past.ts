// Pictures of the past, for scrubbing.
import type { Raster } from "./raster.ts";
import * as store from "./store.ts";

const MOST_PAST_BYTES = 192 * 2 ** 20;

/** Keeps a run's pictures: a new level, revision or an earlier time begins a new run. */
export function keepPast(next: Map<string, Raster>): void {
  const ground = next.get("elevation");
  if (!ground) return;
  const past = store.past.value;
  const last = past.at(-1)?.get("elevation");
  const sameRun = last && last.level === ground.level && last.revision === ground.revision;
  const goesOn = sameRun && ground.time > last.time;
  const again = sameRun && ground.time === last.time;
  const kept = goesOn ? [...past, next] : again ? [...past.slice(0, -1), next] : [next];
  const bytes = ground.z.byteLength * next.size;
  // Every other picture goes when there are too many, so that the whole course stays.
  const most = Math.max(8, Math.floor(MOST_PAST_BYTES / bytes));
  store.past.value = kept.length > most ? kept.filter((_, i) => i % 2 === 0 || i === kept.length - 1) : kept;
  if (!goesOn && !again) store.pastAt.value = null;
}
