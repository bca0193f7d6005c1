// The list of steps: what the land is made of, in order.
import { signal } from "@preact/signals";
import { ask, lookAfter } from "../model/actions.ts";
import { addInto, dialog, lookedAt, recipe, run, selected, tab } from "../model/store.ts";
import type { Stage } from "../protocol/messages.ts";
import { Icon } from "./icons.tsx";
import { Fault, Marked } from "./marked.tsx";
import { Button } from "./parts.tsx";
import { secondsText, words } from "./words.ts";

const carried = signal<number | null>(null);
const over = signal<number | null>(null);

export function StepList() {
  const stages = recipe.value?.stages ?? [];
  return (
    <nav class="steps" aria-label="Steps" data-testid="steps">
      <div class="panel-head">
        <h2>Steps</h2>
        <Button icon="plus" label="Add" text kind="quiet" test="add-step" onClick={() => openAdd(null)} />
      </div>
      <ol class="step-list">
        {stages.map((s) => <Step key={`${s.index} ${s.use}`} stage={s} count={stages.length} />)}
      </ol>
      {stages.length === 0 && <p class="dim pad">The recipe has no steps yet.</p>}
    </nav>
  );
}

function openAdd(into: number | null): void {
  addInto.value = into;
  dialog.value = "add";
}

function choose(stage: number, process: number | null): void {
  selected.value = { stage, process };
  if (tab.value !== "text") tab.value = "step";
}

function Step({ stage, count }: { stage: Stage; count: number }) {
  const chosen = selected.value?.stage === stage.index;
  const faults = recipe.value?.errors.filter((e) => e.stage === stage.index) ?? [];
  const busy = run.value?.running && run.value.stage === stage.index;
  const shown = lookedAt.value === stage.index;
  return (
    <li
      class={`step ${chosen ? "chosen" : ""} ${stage.on ? "" : "off"} ${busy ? "busy" : ""} ${over.value === stage.index ? "over" : ""}`}
      draggable
      onDragStart={(e) => { carried.value = stage.index; e.dataTransfer?.setData("text/plain", stage.use); }}
      onDragOver={(e) => { if (carried.value !== null) { e.preventDefault(); over.value = stage.index; } }}
      onDragEnd={() => (carried.value = over.value = null)}
      onDrop={(e) => { e.preventDefault(); drop(stage.index); }}
    >
      <div class="step-row">
        <span class="grip"><Icon name="grip" /></span>
        <input type="checkbox" class="switch" checked={stage.on} aria-label={`${words(stage.use)} is on`} onChange={() => void ask({ do: "toggle", stage: stage.index })} />
        <button type="button" class="step-name" aria-current={chosen && selected.value?.process === null ? "true" : undefined} data-testid={`step-${stage.index}`} onClick={() => choose(stage.index, null)}>
          <span>{words(stage.use)}</span>
          {stage.label && <small>{stage.label}</small>}
        </button>
        {stage.seconds !== null && stage.seconds !== undefined && <small class="cost" title="Time that this step took last">{secondsText(stage.seconds)}</small>}
        <Button icon="eye" label={shown ? "Look at the last step's ground" : "Look at the ground after this step"} kind="quiet" pressed={shown} onClick={() => lookAfter(shown ? null : stage.index)} />
      </div>
      {stage.processes.length > 0 && (
        <ul class="processes">
          {stage.processes.map((p, i) => (
            <li key={`${i} ${p.use}`} class="process-row">
              <button
                type="button" class="step-name" data-testid={`step-${stage.index}-${i}`}
                aria-current={chosen && selected.value?.process === i ? "true" : undefined} onClick={() => choose(stage.index, i)}
              >
                <span>{words(p.use)}</span>
              </button>
              <Button icon="trash" label={`Remove ${words(p.use)}`} kind="quiet" onClick={() => void ask({ do: "remove", stage: stage.index, process: i })} />
            </li>
          ))}
          {chosen && stage.use === "evolve" && (
            <li><Button icon="plus" label="Add a process" text kind="quiet" onClick={() => openAdd(stage.index)} /></li>
          )}
        </ul>
      )}
      {faults.map((f) => <Fault key={f.what} what={f.what} hint={f.hint} />)}
      {stage.notes.map((n) => <p class="step-note" key={n}><Marked text={n} /></p>)}
      {chosen && (
        <div class="step-tools">
          <Button icon="up" label="Move up" kind="quiet" disabled={stage.index === 0} onClick={() => void ask({ do: "move", stage: stage.index, to: stage.index - 1 })} />
          <Button icon="down" label="Move down" kind="quiet" disabled={stage.index === count - 1} onClick={() => void ask({ do: "move", stage: stage.index, to: stage.index + 1 })} />
          <Button icon="trash" label="Remove this step" kind="quiet" onClick={() => void ask({ do: "remove", stage: stage.index, process: null })} />
          {stage.nodes ? <small class="dim">{stage.nodes.toLocaleString("en")} nodes</small> : null}
        </div>
      )}
    </li>
  );
}

function drop(to: number): void {
  const from = carried.value;
  carried.value = over.value = null;
  if (from !== null && from !== to) void ask({ do: "move", stage: from, to });
}
