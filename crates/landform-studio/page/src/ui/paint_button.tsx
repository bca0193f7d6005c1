// Paints a value of the recipe onto the land.
import { numberIn, parseQuantity } from "../form/quantity.ts";
import type { Field } from "../form/schema.ts";
import { brushAt, painting, paintTarget, recipe, welcome } from "../model/store.ts";
import type { Place, Value } from "../protocol/messages.ts";
import { Button } from "./parts.tsx";
import { words } from "./words.ts";

export function PaintButton({ field, place, held, disabled }: { field: Field; place: Place; held: Value | undefined; disabled?: boolean }) {
  if (!field.varying || field.kind.is !== "quantity" || place.stage === null || !welcome.value?.can?.includes("stroke")) return null;
  const active = JSON.stringify(paintTarget.value?.place) === JSON.stringify(place);
  return (
    <Button icon="brush" label={`Paint ${words(field.key).toLowerCase()} onto the land`} kind="quiet" pressed={active} disabled={disabled} test={`paint-${field.key}`} onClick={() => begin(field, place, held, active)} />
  );
}

function begin(field: Field, place: Place, held: Value | undefined, active: boolean): void {
  if (active) {
    paintTarget.value = null;
    painting.value = null;
    return;
  }
  const unit = field.kind.is === "quantity" ? field.kind.unit : "";
  const stage = recipe.value?.stages[place.stage!];
  const use = place.process === null ? stage?.use : stage?.processes[place.process]?.use;
  paintTarget.value = { place, label: `${words(use ?? "")}: ${words(field.key).toLowerCase()}`, unit: unit === "1" ? "" : unit, typical: typical(field, held, unit) };
  painting.value = "raise";
  brushAt.value ??= [0, 0];
}

/** What is held, the base of strokes, the default or the example, in this order. */
function typical(field: Field, held: Value | undefined, unit: string): number {
  const base = held && typeof held === "object" && !Array.isArray(held) ? held["base"] : held;
  const example = field.kind.is === "quantity" ? field.kind.example : "";
  for (const value of [base, field.default, example]) {
    const quantity = parseQuantity(value);
    const number = quantity && numberIn(quantity, unit);
    if (number) return Math.abs(number);
  }
  return 1;
}
