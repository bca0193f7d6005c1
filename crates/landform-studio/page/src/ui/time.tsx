// The time bar: run, pause, step, stop, and pictures of the past.
import { timeText } from "../form/quantity.ts";
import { ask } from "../model/actions.ts";
import { ground, past, pastAt, run } from "../model/store.ts";
import { Button } from "./parts.tsx";
import { words } from "./words.ts";


/** Least time from step to step while one watches, ms: quick processes are over before one sees them. */
const PACE = 40;

export function TimeBar() {
  const s = run.value;
  const going = s?.running === true && !s.paused;
  const frames = past.value.length;
  const at = pastAt.value ?? frames - 1;
  const years = ground.value?.time ?? 0;
  const part = (s?.running ? s.part : s?.building ? s.building.part : s?.part) ?? 0;
  return (
    <section class="time" aria-label="Time" data-testid="time">
      <div class="time-buttons">
        <Button icon={going ? "pause" : "play"} label={going ? "Pause" : "Play"} title={going ? "Pause (P)" : "Watch it grow (P)"} kind="strong" test="play" onClick={playOrPause} />
        <Button icon="step" label="One step" title="One step (.)" test="step" disabled={going} onClick={() => void ask({ do: "step" })} />
        <Button icon="stop" label="Stop" test="stop" disabled={!s?.running} onClick={() => void ask({ do: "stop" })} />
      </div>
      <output class="clock" data-testid="clock">{timeText(years)}</output>
      <div class="scrub">
        <input
          type="range" min={0} max={Math.max(1, frames - 1)} step={1} value={Math.max(0, at)} disabled={frames < 2} aria-label="Pictures of the past"
          aria-valuetext={timeText(years)} style={{ "--part": String(frames > 1 ? at / (frames - 1) : 0) }} data-testid="scrub"
          onInput={(e) => scrub(Number(e.currentTarget.value))}
        />
        <div class="progress" role="progressbar" aria-label="Progress" aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(part * 100)}>
          <i style={{ width: `${Math.min(100, part * 100)}%` }} class={s?.running || s?.building ? "on" : ""} />
        </div>
      </div>
      <div class="time-facts">
        {pastAt.value !== null && <Button label="To the newest" text kind="quiet" onClick={() => (pastAt.value = null)} />}
        <span>{runText()}</span>
      </div>
    </section>
  );
}

function runText(): string {
  const s = run.value;
  if (!s) return "";
  const parts: string[] = [];
  if (s.building) {
    const { what, name, part } = s.building;
    parts.push(`${what}${name ? `: ${name.replaceAll("_", " ")}` : ""}${part !== null && part !== undefined ? ` ${Math.round(part * 100)} %` : ""}`);
  }
  if (s.running && s.name) parts.push(`${words(s.name)}${s.of ? ` (${(s.stage ?? 0) + 1} of ${s.of})` : ""}`);
  if (s.running && s.steps) parts.push(`step ${s.steps}`);
  if (s.paused) parts.push("paused");
  if (s.seconds_left !== null && s.running) parts.push(`${Math.max(1, Math.round(s.seconds_left))} s left`);
  else if (s.seconds !== null && s.seconds !== undefined && !s.running) parts.push(`${s.seconds.toFixed(1)} s`);
  return parts.join(" · ");
}

function scrub(to: number): void {
  pastAt.value = to >= past.value.length - 1 ? null : to;
}

export function playOrPause(): void {
  const s = run.value;
  pastAt.value = null;
  void ask(s?.running && !s.paused ? { do: "pause" } : { do: "play", pace: PACE });
}
