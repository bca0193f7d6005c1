// Keys that work anywhere, and the list of all keys.
import { useEffect } from "preact/hooks";
import { ask } from "../model/actions.ts";
import { dialog, hasRecipe, painting, viewing } from "../model/store.ts";
import { Modal } from "./parts.tsx";
import { playOrPause } from "./time.tsx";
import { save } from "./top.tsx";

const ROWS: [string, string][] = [
  ["Ctrl+Z, Ctrl+Shift+Z", "Undo, redo"],
  ["Ctrl+S", "Save"],
  ["P", "Play or pause"],
  [".", "One step"],
  ["1, 2, 3", "3-D view, map, both"],
  ["?", "This list"],
  ["Arrows on the view", "Turn the view; on the map: move it"],
  ["Shift+arrows", "Move over the land"],
  ["+ and −", "Nearer, farther"],
  ["Home", "The whole land"],
  ["Q, W, E, R, T on the view", "Probe, raise, lower, smooth, level; Esc: none of them"],
  ["Arrows, space with a tool", "Move the brush (Shift: faster), paint"],
  ["[ and ]", "Brush smaller, larger"],
  [", and ;", "Brush weaker, stronger"],
];

export function Keys() {
  return (
    <Modal title="Keys" test="keys" onClose={() => (dialog.value = null)}>
      <dl class="keys">
        {ROWS.map(([keys, what]) => <div key={keys}><dt>{keys}</dt><dd>{what}</dd></div>)}
      </dl>
      <p class="lead"><a href="/LICENSES.txt" target="_blank" rel="noopener">Licences of the page's libraries</a></p>
    </Modal>
  );
}

export function useShortcuts(): void {
  useEffect(() => {
    const press = (e: KeyboardEvent) => {
      const target = e.target as HTMLElement;
      const typing = /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName) && (target as HTMLInputElement).type !== "range" && (target as HTMLInputElement).type !== "checkbox";
      const command = e.ctrlKey || e.metaKey;
      if (!hasRecipe.value || dialog.value) return;
      if (command && e.key.toLowerCase() === "s") return done(e, () => void save());
      if (command && e.key.toLowerCase() === "z" && target.tagName !== "TEXTAREA") return done(e, () => void ask({ do: e.shiftKey ? "redo" : "undo" }));
      if (typing || command || e.altKey) return;
      if (e.key === "p") done(e, playOrPause);
      else if (e.key === "." ) done(e, () => void ask({ do: "step" }));
      else if (e.key === "1") done(e, () => (viewing.value = "land"));
      else if (e.key === "2") done(e, () => (viewing.value = "map"));
      else if (e.key === "3") done(e, () => (viewing.value = "both"));
      else if (e.key === "?") done(e, () => (dialog.value = "keys"));
      else if (e.key === "Escape" && painting.value) done(e, () => (painting.value = null));
    };
    window.addEventListener("keydown", press);
    return () => window.removeEventListener("keydown", press);
  }, []);
}

function done(e: KeyboardEvent, act: () => void): void {
  e.preventDefault();
  act();
}
