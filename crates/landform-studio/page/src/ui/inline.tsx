import { useSignal } from "@preact/signals";
import { parseToml, tomlText } from "../form/toml.ts";
import { setValue } from "../model/actions.ts";
import type { Value } from "../protocol/messages.ts";
import type { Held } from "./field_props.ts";

/** Anything else, as the text of the recipe has it. */
export function Inline({ id, field, place, held, disabled }: Held<Value | undefined>) {
  const trouble = useSignal("");
  const text = held === undefined || held === null ? "" : tomlText(held);
  const type = (typed: string) => {
    try {
      const value = typed.trim() === "" ? null : parseToml(typed);
      trouble.value = "";
      setValue(place, value, false);
    } catch (error) {
      trouble.value = (error as Error).message;
    }
  };
  return (
    <div class="inline">
      <textarea id={id} class={`field code ${trouble.value ? "wrong" : ""}`} rows={Math.min(8, Math.max(1, Math.ceil(text.length / 34)))} spellcheck={false} value={text} disabled={disabled} placeholder={field.optional ? "none" : ""} onChange={(e) => type(e.currentTarget.value)} />
      {trouble.value && <p class="fault">{trouble.value}</p>}
    </div>
  );
}
