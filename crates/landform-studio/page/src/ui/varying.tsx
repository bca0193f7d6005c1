// A value that varies: by a formula of place, in time, by a map, near rivers.
import type { Table, Value } from "../protocol/messages.ts";
import { parseQuantity } from "../form/quantity.ts";
import { setValue } from "../model/actions.ts";
import type { Held } from "./field_props.ts";
import { Inline } from "./inline.tsx";
import { PaintButton } from "./paint_button.tsx";
import { Button } from "./parts.tsx";

export function Varying(props: Held<Value | undefined>) {
  const { field, place, held, disabled } = props;
  const table = held && typeof held === "object" && !Array.isArray(held) ? (held as Table) : null;
  const plain = table && parseQuantity(table["base"]) ? table["base"]! : parseQuantity(field.default) ? field.default! : field.kind.is === "quantity" ? field.kind.example : null;
  return (
    <div class="varying">
      <div class="varying-head">
        <span class="dim">{table ? kindOf(table) : "varies"}</span>
        <PaintButton field={field} place={place} held={held} disabled={disabled} />
        {field.kind.is === "quantity" && <Button label="Make it one number" text kind="quiet" disabled={disabled} onClick={() => setValue(place, plain, false)} />}
      </div>
      {table && Array.isArray(table["strokes"]) ? <Strokes {...props} table={table} /> : table && typeof table["formula"] === "string" ? <Formula {...props} table={table} /> : <Inline {...props} />}
    </div>
  );
}

function kindOf(table: Table): string {
  if (Array.isArray(table["strokes"])) return `painted: ${table["strokes"].length} ${table["strokes"].length === 1 ? "stroke" : "strokes"}`;
  if ("formula" in table) return "by a formula of place";
  if ("times" in table) return "changes in time";
  if ("amplitude" in table) return "rises and falls in time";
  if ("image" in table || "raster" in table) return "by a map";
  if ("feature" in table) return "near what lies in the land";
  if ("field" in table) return "by a field of the land";
  return "varies";
}

/** What was there before the first stroke; the strokes themselves are painted, not typed. */
function Strokes({ id, place, table, disabled }: Held<Value | undefined> & { table: Table }) {
  const base = table["base"];
  return (
    <label class="view-slider strokes">
      <span>on a base of</span>
      <input
        id={id} class="field number" value={base === undefined || base === null ? "" : typeof base === "object" ? "varies" : String(base)} disabled={disabled || typeof base === "object"} spellcheck={false}
        onChange={(e) => parseQuantity(e.currentTarget.value) && setValue({ ...place, key: [...place.key, "base"] }, e.currentTarget.value.trim(), false)}
      />
    </label>
  );
}

function Formula({ id, place, table, disabled }: Held<Value | undefined> & { table: Table }) {
  const formula = String(table["formula"]);
  const unit = typeof table["unit"] === "string" && table["unit"] !== "1" ? table["unit"] : "";
  return (
    <>
      <textarea
        id={id} class="field code" rows={Math.min(8, Math.max(2, Math.ceil(formula.length / 36)))} spellcheck={false} value={formula} disabled={disabled}
        onChange={(e) => setValue({ ...place, key: [...place.key, "formula"] }, e.currentTarget.value, false)}
      />
      <small class="dim">{unit && `in ${unit}; `}x, y: metres · u, v: 0 to 1 · r: from the middle</small>
    </>
  );
}
