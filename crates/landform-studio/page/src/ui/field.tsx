// One value of the recipe: slider, number with unit, choice, switch, list, table, or text.
import { useSignal } from "@preact/signals";
import { numberIn, numberText, parseQuantity, quantityValue } from "../form/quantity.ts";
import type { Field } from "../form/schema.ts";
import { numberAt, positionOf, SLIDER_STEPS, widened } from "../form/slider.ts";
import { parseToml, tomlText } from "../form/toml.ts";
import { setValue } from "../model/actions.ts";
import type { Table, Value } from "../protocol/messages.ts";
import { Marked } from "./marked.tsx";
import { Button } from "./parts.tsx";
import type { Held, Props } from "./field_props.ts";
import { Inline } from "./inline.tsx";
import { PaintButton } from "./paint_button.tsx";
import { Varying } from "./varying.tsx";
import { words } from "./words.ts";

export function FieldRow(props: Props) {
  const { field, place, given, disabled } = props;
  const helping = useSignal(false);
  const id = `f-${place.stage}-${place.process}-${place.key.join("-")}`;
  return (
    <div class={`row ${given !== undefined ? "given" : ""}`} data-testid={`row-${place.key.join(".")}`}>
      <div class="row-head">
        <label for={id} title={field.help}>{words(field.key)}</label>
        {given !== undefined && place.key.length > 0 && (
          <Button icon="reset" label={`Back to default: ${words(field.key)}`} kind="quiet" disabled={disabled} onClick={() => setValue(place, null, false)} />
        )}
        <button type="button" class="button quiet help-button" aria-expanded={helping.value} aria-label={`About ${words(field.key)}`} onClick={() => (helping.value = !helping.value)}>?</button>
      </div>
      <Control {...props} id={id} />
      {helping.value && <p class="help"><Marked text={`${field.help} ${limitsText(field)}`} /></p>}
    </div>
  );
}

function limitsText({ least, most, default: normal }: Field): string {
  const parts = [
    normal !== undefined && normal !== null ? `Default ${tomlText(normal)}.` : "",
    least !== null ? `At least ${numberText(least)}.` : "",
    most !== null ? `At most ${numberText(most)}.` : "",
  ];
  return parts.filter(Boolean).join(" ");
}

function Control(props: Props & { id: string }) {
  const { field, given, value } = props;
  const held = given !== undefined ? given : value !== undefined ? value : field.default;
  const plain = held === null || held === undefined || typeof held !== "object";
  if (field.varying && !plain) return <Varying {...props} held={held} />;
  const { kind } = field;
  switch (kind.is) {
    case "quantity":
    case "number":
      return plain ? <Amount {...props} held={held} /> : <Inline {...props} held={held} />;
    case "switch":
      return <Switch {...props} on={held === true} />;
    case "choice":
      return <Choose {...props} held={held} choices={kind.choices.map((c) => c.value)} />;
    case "choices":
      return <ChooseMany {...props} held={Array.isArray(held) ? held.map(String) : []} choices={kind.choices.map((c) => c.value)} />;
    case "list":
      return Array.isArray(held) ? <List {...props} held={held} /> : <Inline {...props} held={held} />;
    case "group":
      return <Group {...props} fields={kind.fields} />;
    case "text":
      return <TextField {...props} held={typeof held === "string" ? held : ""} />;
    default:
      return <Inline {...props} held={held} />;
  }
}

/** A slider between soft limits, and the number with its unit as the text has it. */
function Amount({ field, place, id, held, disabled }: Held<Value | undefined>) {
  const drag = useSignal<number | null>(null);
  const wrong = useSignal(false);
  const unit = field.kind.is === "quantity" ? field.kind.unit : "";
  const whole = field.kind.is === "number" && field.kind.whole;
  const known = parseQuantity(held);
  const shownUnit = known?.unit || (unit === "1" ? "" : unit);
  const number = known ? numberIn(known, unit) : null;
  const scale = field.slider && widened(field.slider, number);
  const toValue = (n: number): Value => {
    if (field.kind.is === "number" || unit === "1") return n;
    const other = known && known.unit && known.unit !== unit ? numberIn({ number: n, unit }, known.unit) : null;
    return other !== null ? quantityValue(other, known!.unit) : quantityValue(n, unit);
  };
  const dragged = drag.value !== null && scale ? numberAt(drag.value, scale, whole) : null;
  const text = dragged !== null ? valueText(toValue(dragged)) : held === null || held === undefined ? "" : valueText(held);
  const position = drag.value ?? (scale && number !== null ? positionOf(number, scale) : 0);
  const move = (at: number, dragging: boolean) => {
    if (!scale) return;
    drag.value = dragging ? at : null;
    setValue(place, toValue(numberAt(at, scale, whole)), dragging);
  };
  const type = (typed: string) => {
    const value = typedValue(typed, field, shownUnit);
    wrong.value = value === undefined;
    if (value !== undefined) setValue(place, value, false);
  };
  return (
    <div class="amount">
      {scale && (
        <input
          type="range" min={0} max={SLIDER_STEPS} step={1} value={Math.round(position * SLIDER_STEPS)} disabled={disabled} aria-label={words(field.key)}
          aria-valuetext={text || "none"} class={number === null && drag.value === null ? "none" : ""} style={{ "--part": String(position) }}
          data-testid={`slider-${place.key.join(".")}`}
          onInput={(e) => move(Number(e.currentTarget.value) / SLIDER_STEPS, true)}
          onChange={(e) => move(Number(e.currentTarget.value) / SLIDER_STEPS, false)}
        />
      )}
      <input
        id={id} class={`field number ${wrong.value ? "wrong" : ""}`} type="text" inputMode="decimal" spellcheck={false} disabled={disabled} value={text}
        placeholder={field.optional ? "none" : ""} aria-invalid={wrong.value} onChange={(e) => type(e.currentTarget.value)}
      />
      <PaintButton field={field} place={place} held={held} disabled={disabled} />
      {field.varying && <Button label="ƒ" text kind="quiet" title="Let it vary: a formula of place" disabled={disabled} onClick={() => setValue(place, formulaOf(held, unit), false)} />}
    </div>
  );
}

function valueText(value: Value): string {
  return typeof value === "number" ? numberText(value, 6) : String(value);
}

/** The value that was typed: with the shown unit where it has none; undefined where it is not one. */
function typedValue(typed: string, field: Field, unit: string): Value | undefined {
  const text = typed.trim();
  if (text === "" || text === "none") return field.optional || field.default !== undefined ? null : undefined;
  if (/^[{[]/.test(text)) {
    try {
      return parseToml(text);
    } catch {
      return undefined;
    }
  }
  const q = parseQuantity(text);
  if (!q) return undefined;
  if (field.kind.is === "number" || (field.kind.is === "quantity" && field.kind.unit === "1")) return q.unit === "" ? q.number : undefined;
  if (q.unit === "") return unit ? `${text} ${unit}` : q.number;
  return field.kind.is === "quantity" && numberIn(q, field.kind.unit) === null ? undefined : text;
}

function formulaOf(held: Value | undefined, unit: string): Table {
  const known = parseQuantity(held);
  const number = known ? numberText(numberIn(known, unit) ?? 1) : "1";
  return { formula: `${number}*(1 + 0.5*noise(x/3000, y/3000))`, unit };
}

function Switch({ id, place, on, disabled }: Props & { id: string; on: boolean }) {
  return <input id={id} type="checkbox" class="switch" checked={on} disabled={disabled} onChange={(e) => setValue(place, e.currentTarget.checked, false)} />;
}

function Choose({ id, field, place, held, choices, disabled }: Held<Value | undefined> & { choices: string[] }) {
  return (
    <select id={id} class="field" value={held === null || held === undefined ? "" : String(held)} disabled={disabled} onChange={(e) => setValue(place, e.currentTarget.value || null, false)}>
      {field.optional && <option value="">none</option>}
      {choices.map((c) => <option key={c} value={c}>{c.replaceAll("_", " ")}</option>)}
    </select>
  );
}

function ChooseMany({ place, held, choices, disabled }: Held<string[]> & { choices: string[] }) {
  const flip = (c: string) => setValue(place, choices.filter((x) => (x === c ? !held.includes(c) : held.includes(x))), false);
  return (
    <div class="many">
      {choices.map((c) => (
        <label key={c}><input type="checkbox" checked={held.includes(c)} disabled={disabled} onChange={() => flip(c)} />{c.replaceAll("_", " ")}</label>
      ))}
    </div>
  );
}

function List({ id, field, place, held, disabled }: Held<Value[]>) {
  const wrong = useSignal(-1);
  if (field.kind.is !== "list") return null;
  const { unit } = field.kind;
  const type = (i: number, typed: string) => {
    const q = parseQuantity(typed);
    wrong.value = q ? -1 : i;
    if (!q) return;
    const one: Value = unit === "" || unit === "1" ? q.number : q.unit === "" ? `${typed.trim()} ${unit}` : typed.trim();
    setValue(place, held.map((v, k) => (k === i ? one : v)), false);
  };
  return (
    <div class="list">
      {held.map((v, i) => (
        <input
          key={i} id={i === 0 ? id : undefined} class={`field number ${wrong.value === i ? "wrong" : ""}`} value={valueText(v)} disabled={disabled}
          aria-label={`${words(field.key)} ${i + 1}`} spellcheck={false} onChange={(e) => type(i, e.currentTarget.value)}
        />
      ))}
    </div>
  );
}

function Group({ place, given, value, field, fields, disabled }: Props & { fields: Field[] }) {
  const table = (v: Value | undefined): Table => (v && typeof v === "object" && !Array.isArray(v) ? v : {});
  const normal = table(field.default);
  const [have, hold] = [table(given), table(value)];
  return (
    <div class="group">
      {fields.map((f) => (
        <FieldRow
          key={f.key} field={f} place={{ ...place, key: [...place.key, f.key] }} given={have[f.key]} value={hold[f.key] ?? have[f.key] ?? normal[f.key]} disabled={disabled}
        />
      ))}
    </div>
  );
}

function TextField({ id, place, held, disabled }: Held<string>) {
  return <input id={id} class="field" type="text" spellcheck={false} value={held} disabled={disabled} onChange={(e) => setValue(place, e.currentTarget.value || null, false)} />;
}
