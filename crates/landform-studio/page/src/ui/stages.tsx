// The list of stages that can be added, with their texts; typing narrows it.
import { useSignal } from "@preact/signals";
import { ask } from "../model/actions.ts";
import { addInto, dialog, forms, recipe, selected, stages } from "../model/store.ts";
import type { StageInfo } from "../protocol/messages.ts";
import { Marked } from "./marked.tsx";
import { Modal } from "./parts.tsx";
import { words } from "./words.ts";

export function AddStage() {
  const typed = useSignal("");
  const picked = useSignal<string | null>(null);
  const into = addInto.value;
  const query = typed.value.trim().toLowerCase();
  const shown = stages.value.filter((s) => (into === null || isProcess(s.name)) && matches(s, query));
  const one = stages.value.find((s) => s.name === picked.value) ?? shown[0];
  return (
    <Modal title={into === null ? "Add a step" : "Add a process"} wide test="add" onClose={() => (dialog.value = null)}>
      <div class="adder">
        <div class="adder-list">
          <input
            type="search" class="field" placeholder="Search: river, dunes, sea, mesh…" aria-label="Search stages" autofocus value={typed.value}
            onInput={(e) => { typed.value = e.currentTarget.value; picked.value = null; }}
            onKeyDown={(e) => e.key === "Enter" && one && add(one.name)}
          />
          <ul>
            {shown.map((s) => (
              <li key={s.name}>
                <button type="button" aria-current={one?.name === s.name ? "true" : undefined} onClick={() => (picked.value = s.name)} onDblClick={() => add(s.name)}>
                  <b>{words(s.name)}</b>
                  <small><Marked text={s.summary} /></small>
                </button>
              </li>
            ))}
          </ul>
          {shown.length === 0 && <p class="dim">No stage has “{typed.value}” in its name or text.</p>}
        </div>
        {one && (
          <div class="adder-text">
            <h3>{words(one.name)} <small class="dim">{one.folder}</small></h3>
            <p><Marked text={one.text || one.summary} /></p>
            {one.sources.length > 0 && <h4>Sources</h4>}
            {one.sources.map((s) => <p class="source" key={s.title}>{s.authors}: {s.title}{s.doi ? `. ${s.doi}` : ""}</p>)}
            <button type="button" class="button strong" data-testid="add-this" onClick={() => add(one.name)}>Add {words(one.name).toLowerCase()}</button>
          </div>
        )}
      </div>
    </Modal>
  );
}

function matches(s: StageInfo, query: string): boolean {
  return query === "" || [s.name.replaceAll("_", " "), s.name, s.summary, s.folder, s.verb].some((t) => t?.toLowerCase().includes(query));
}

function isProcess(name: string): boolean {
  return forms.value.isProcess(name);
}

/** Behind the selected step, or at the end of its processes. */
function add(use: string): void {
  const into = addInto.value;
  const count = recipe.value?.stages.length ?? 0;
  const at = into === null ? (selected.value ? selected.value.stage + 1 : count) : (recipe.value?.stages[into]?.processes.length ?? 0);
  dialog.value = null;
  void ask({ do: "insert", at, use, process_of: into }).then((answer) => {
    if (answer.ok) selected.value = into === null ? { stage: at, process: null } : { stage: into, process: at };
  });
}
