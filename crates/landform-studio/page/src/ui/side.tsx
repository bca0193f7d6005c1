// The panel at the right: the selected step, the recipe's own keys, measures, or the text.
import type { Field } from "../form/schema.ts";
import { newSeed, setSeed, setValue } from "../model/actions.ts";
import { forms, recipe, selected, stages, tab, type Tab } from "../model/store.ts";
import type { Place, Stage, Step, Table } from "../protocol/messages.ts";
import { Measures } from "./charts.tsx";
import { Editor } from "./editor.tsx";
import { FieldRow } from "./field.tsx";
import { Fault, Marked } from "./marked.tsx";
import { Button, Segments } from "./parts.tsx";
import { words } from "./words.ts";

const TABS: { value: Tab; label: string }[] = [
  { value: "step", label: "Step" },
  { value: "recipe", label: "Recipe" },
  { value: "measures", label: "Measures" },
  { value: "text", label: "Text" },
];

export function SidePanel() {
  return (
    <aside class="side" aria-label="Values" data-testid="side">
      <Segments label="tab" value={tab.value} choices={TABS} onChange={(t) => (tab.value = t)} />
      {tab.value === "step" && <StepForm />}
      {tab.value === "recipe" && <RecipeForm />}
      {tab.value === "measures" && <Measures />}
      {tab.value === "text" && <Editor />}
    </aside>
  );
}

function StepForm() {
  const chosen = selected.value;
  const stage = chosen ? recipe.value?.stages[chosen.stage] : undefined;
  const step = stage && (chosen!.process === null ? stage : stage.processes[chosen!.process]);
  if (!stage || !step) return <div class="side-body"><p class="dim">Choose a step at the left to see its values.</p></div>;
  const inProcess = chosen!.process !== null;
  const place: Place = { stage: stage.index, process: chosen!.process, key: [] };
  const info = stages.value.find((s) => s.name === step.use);
  const fields = forms.value.stage(step.use, inProcess);
  return (
    <div class="side-body" key={`${stage.index} ${chosen!.process}`}>
      <h2>{words(step.use)}</h2>
      <p class="dim lead"><Marked text={info?.summary || forms.value.help(step.use)} /></p>
      <Faults stage={stage.index} />
      {!stage.on && <p class="step-note">This step is off. Turn it on at the left to change it.</p>}
      {!inProcess && <Clock stage={stage} place={place} />}
      <Rows fields={fields} place={place} step={step} disabled={!stage.on} />
      {info && info.sources.length > 0 && (
        <details class="sources">
          <summary>Sources</summary>
          {info.sources.map((s) => <p class="source" key={s.title}>{s.authors}: {s.title}{s.doi ? <> <span class="doi">{s.doi}</span></> : null}</p>)}
        </details>
      )}
    </div>
  );
}

function Faults({ stage }: { stage: number }) {
  const faults = recipe.value?.errors.filter((e) => e.stage === stage) ?? [];
  return <>{faults.map((f) => <Fault key={f.what} what={f.what} hint={f.hint} line={f.line} />)}</>;
}

const LATER = new Set(["options", "surroundings", "files"]);

/** What matters most first, the rest behind a fold; what the text holds is never hidden. */
function Rows({ fields, place, step, disabled }: { fields: Field[]; place: Place; step: Step; disabled: boolean }) {
  const first = fields.filter((f) => !LATER.has(f.group) || step.given[f.key] !== undefined);
  const later = fields.filter((f) => !first.includes(f));
  const row = (f: Field) => (
    <FieldRow key={f.key} field={f} place={{ ...place, key: [f.key] }} given={step.given[f.key]} value={step.values[f.key]} disabled={disabled} />
  );
  return (
    <>
      {first.map(row)}
      {later.length > 0 && (
        <details class="more">
          <summary>{first.length ? "More" : "Values"} ({later.length})</summary>
          {later.map(row)}
        </details>
      )}
    </>
  );
}

const CLOCK_FIRST = new Set(["dt", "duration", "until"]);

function Clock({ stage, place }: { stage: Stage; place: Place }) {
  const fields = forms.value.clock(stage.use);
  const given = (stage.given["clock"] ?? {}) as Table;
  const values = (stage.values["clock"] ?? given) as Table;
  if (!fields.length) return null;
  const row = (f: Field) => (
    <FieldRow key={f.key} field={f} place={{ ...place, key: ["clock", f.key] }} given={given[f.key]} value={values[f.key]} disabled={!stage.on} />
  );
  const first = (f: Field) => CLOCK_FIRST.has(f.key) || given[f.key] !== undefined;
  return (
    <fieldset class="clock-fields">
      <legend>Clock</legend>
      {fields.filter(first).map(row)}
      <details class="more">
        <summary>More of the clock</summary>
        {fields.filter((f) => !first(f)).map(row)}
      </details>
    </fieldset>
  );
}

function RecipeForm() {
  const r = recipe.value;
  if (!r) return null;
  const given = r.given ?? {};
  const environment = (given["environment"] ?? {}) as Table;
  const whole = (key: string): Place => ({ stage: null, process: null, key: [key] });
  return (
    <div class="side-body">
      <h2>Recipe</h2>
      <div class="row">
        <div class="row-head"><label for="recipe-title">Title</label></div>
        <input id="recipe-title" class="field" value={r.title ?? ""} onChange={(e) => setValue(whole("title"), e.currentTarget.value || null, false)} />
      </div>
      <div class="row">
        <div class="row-head"><label for="recipe-seed">Seed</label></div>
        <div class="amount">
          <input
            id="recipe-seed" class="field number" data-testid="seed" inputMode="numeric" value={String(r.seed ?? 0)}
            onChange={(e) => /^\d+$/.test(e.currentTarget.value.trim()) && setSeed(Number(e.currentTarget.value))}
          />
          <Button icon="dice" label="New seed" text test="new-seed" onClick={() => setSeed(newSeed())} />
        </div>
      </div>
      <h3>Environment</h3>
      <p class="dim lead">Sea, rain and wind, which all steps share.</p>
      {forms.value.environment().map((f) => (
        <FieldRow key={f.key} field={f} place={{ stage: null, process: null, key: ["environment", f.key] }} given={environment[f.key]} value={environment[f.key]} />
      ))}
    </div>
  );
}
