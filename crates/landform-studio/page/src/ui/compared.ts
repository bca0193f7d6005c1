// Which state or states the views draw.
import { computed } from "@preact/signals";
import type { LandState } from "../land/state.ts";
import type { Beside } from "../land/view.ts";
import { comparing, flickered, keptA, keptB, land, split } from "../model/store.ts";

export const drawnStates = computed<{ state: LandState | null; beside: Beside | null }>(() => {
  const now = land.value;
  const a = keptA.value?.state ?? null;
  const b = keptB.value?.state ?? now;
  if (!comparing.value || !a || !b) return { state: now, beside: null };
  if (comparing.value === "flicker") return { state: flickered.value ? b : a, beside: null };
  return { state: a, beside: { state: b, split: split.value } };
});
