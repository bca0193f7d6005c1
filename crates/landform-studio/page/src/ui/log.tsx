// One line that says how things are, and the lines before it.
import { useEffect, useRef } from "preact/hooks";
import { bytesText } from "../form/quantity.ts";
import { connected, latency, log, logOpen, run, welcome } from "../model/store.ts";
import { Button } from "./parts.tsx";

export function LogPanel() {
  const last = log.value.findLast((l) => l.kind !== "latency");
  const state = run.value;
  const lag = latency.value;
  const lines = useRef<HTMLDivElement>(null);
  useEffect(() => lines.current?.scrollTo(0, lines.current.scrollHeight), [log.value, logOpen.value]);
  return (
    <footer class="log" data-testid="log">
      {logOpen.value && (
        <div ref={lines} class="log-lines" role="log" aria-live="off" aria-label="Log" tabIndex={0}>
          {log.value.length === 0 && <p class="dim">Nothing has been noted yet.</p>}
          {log.value.slice(-200).map((l, i) => (
            <p key={i} class={l.kind}>
              <time>{new Date(l.at).toLocaleTimeString()}</time> {l.text}
            </p>
          ))}
        </div>
      )}
      <div class="log-strip">
        <Button icon={logOpen.value ? "down" : "up"} label="Log" text kind="quiet" test="log-button" pressed={logOpen.value} onClick={() => (logOpen.value = !logOpen.value)} />
        <span class={`log-last ${last?.kind ?? ""}`}>{last?.text ?? (connected.value ? "Ready." : "Connecting…")}</span>
        {lag && Number.isFinite(lag.whole) && <span title="From the last event to its picture">{lag.whole.toFixed(0)} ms to picture</span>}
        {state?.memory_bytes ? <span title="Memory of the server">{bytesText(state.memory_bytes)}</span> : null}
        <span class="dim">{welcome.value?.version ? `landform ${welcome.value.version}` : ""}</span>
      </div>
    </footer>
  );
}
