// The bar at the top: the recipe as a whole.
import { ask, keep } from "../model/actions.ts";
import { comparing, connected, dialog, hasRecipe, keptA, note, recipe, run, say, tab } from "../model/store.ts";
import { Icon } from "./icons.tsx";
import { Button } from "./parts.tsx";

export function TopBar() {
  const r = recipe.value;
  const open = hasRecipe.value;
  const building = run.value?.building ? run.value.building.what === "build" : false;
  return (
    <header class="top">
      <div class="brand"><Icon name="build" /><span>landform</span></div>
      <Button icon="folder" label="Open" text test="gallery-button" onClick={() => (dialog.value = "gallery")} />
      {open && (
        <>
          <h1 class="title" title={r?.path ?? undefined}>
            <b>{r?.title ?? "Untitled"}</b>
            {!r?.saved && <span class="dim"> · not saved</span>}
          </h1>
          <Button icon="undo" label="Undo" title="Undo (Ctrl+Z)" kind="quiet" disabled={!r?.can_undo} test="undo" onClick={() => void ask({ do: "undo" })} />
          <Button icon="redo" label="Redo" title="Redo (Ctrl+Shift+Z)" kind="quiet" disabled={!r?.can_redo} test="redo" onClick={() => void ask({ do: "redo" })} />
          <span class="space" />
          <Button icon="grid" label="Seeds" text title="Pictures of several seeds" test="contact-button" onClick={() => (dialog.value = "contact")} />
          <Button icon="compare" label="Compare" text test="compare-button" pressed={comparing.value !== null} onClick={toggleCompare} />
          <Button icon="text" label="Text" text test="text-button" pressed={tab.value === "text"} onClick={() => (tab.value = tab.value === "text" ? "step" : "text")} />
          <Button icon="save" label="Save" text title="Save (Ctrl+S)" test="save" disabled={r?.saved} onClick={() => void save()} />
          <Button icon="copy" label="Copy command" text title={r?.command} test="copy" onClick={() => void copy(r?.command ?? "")} />
          <Button icon="export" label="Export" text test="export-button" onClick={() => (dialog.value = "export")} />
          <Button
            icon={building ? "stop" : "build"} label={building ? "Cancel build" : "Build"} text kind="strong" test="build"
            disabled={(r?.errors.length ?? 0) > 0} title="Runs the whole recipe at full size and writes its files"
            onClick={() => void ask({ do: building ? "cancel_build" : "build" })}
          />
        </>
      )}
      {!open && <span class="space" />}
      <Button icon="keys" label="Keys" kind="quiet" onClick={() => (dialog.value = "keys")} />
      <span class={connected.value ? "dot on" : "dot"} role="img" aria-label={connected.value ? "connected" : "not connected"} title={connected.value ? "Connected" : "Not connected; trying again"} />
    </header>
  );
}

export async function save(): Promise<void> {
  const answer = await ask({ do: "save" });
  if (answer.ok) say("Saved.");
}

async function copy(command: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(command);
    note("note", `Copied: ${command}`);
    say("The command is copied.");
  } catch {
    note("note", command);
    say("The browser does not let the page copy; the command is in the log.");
  }
}

function toggleCompare(): void {
  if (comparing.value) {
    comparing.value = null;
    return;
  }
  if (!keptA.value) keep("A");
  comparing.value = "wipe";
}
