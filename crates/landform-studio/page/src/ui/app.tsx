import { hasRecipe, connected, dialog, land, recipe, said, tab, welcome } from "../model/store.ts";
import { Contact } from "./contact.tsx";
import { Export } from "./export.tsx";
import { Gallery, Welcome } from "./gallery.tsx";
import { Keys, useShortcuts } from "./keys.tsx";
import { LogPanel } from "./log.tsx";
import { SidePanel } from "./side.tsx";
import { AddStage } from "./stages.tsx";
import { StepList } from "./steps.tsx";
import { TimeBar } from "./time.tsx";
import { TopBar } from "./top.tsx";
import { Views } from "./views.tsx";

export function App() {
  useShortcuts();
  const empty = connected.value && recipe.value !== null && !hasRecipe.value;
  return (
    <div class={`app ${empty ? "empty" : ""} ${tab.value === "text" ? "texting" : ""}`} data-testid="app" data-ready={recipe.value && (empty || land.value) ? "true" : "false"}>
      <TopBar />
      {empty ? (
        <Welcome />
      ) : (
        <>
          <StepList />
          <Views />
          <SidePanel />
          <TimeBar />
        </>
      )}
      {!connected.value && welcome.value && (
        <p class="lost" role="alert">The studio does not answer. The page tries again; if the program has ended, start it and open the address that it prints.</p>
      )}
      <LogPanel />
      <div class="said" role="status" aria-live="polite">{said.value}</div>
      {dialog.value === "gallery" && <Gallery />}
      {dialog.value === "add" && <AddStage />}
      {dialog.value === "export" && <Export />}
      {dialog.value === "contact" && <Contact />}
      {dialog.value === "keys" && <Keys />}
    </div>
  );
}
