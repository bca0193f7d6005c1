// What the page asks of the server, and what it does with what the server tells.
import { batch } from "@preact/signals";
import type { Frame } from "../protocol/frame.ts";
import { Newest } from "../protocol/newest.ts";
import { Session, type Answer } from "../protocol/session.ts";
import type { Asked, GalleryEntry, Place, Stage, StageInfo, Told, Value } from "../protocol/messages.ts";
import { parseQuantity } from "../form/quantity.ts";
import { Forms, type Schema } from "../form/schema.ts";
import { keepPast } from "./past.ts";
import { Assembler } from "./raster.ts";
import * as store from "./store.ts";

const assembler = new Assembler();
let session: Session;
/** Frames that are drawn next and then acknowledged. */
let toAcknowledge: number[] = [];
let stampToDraw: number | null = null;
let stampInWork: number | null = null;
/** Stamps of events whose pictures have not come yet. */
const dragStamps = new Set<number>();

export function start(): void {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  session = new Session(`${scheme}://${location.host}/session`, {
    told: hear,
    frame: take,
    connected(open) {
      store.connected.value = open;
      asked = "";
      if (open) showWanted();
      store.say(open ? "Connected." : "The connection is lost; trying again.");
    },
    trouble: (text) => store.note("error", text),
  });
  session.open();
  void load<Schema>("/schema.json", (schema) => (store.forms.value = new Forms(schema)));
  void load<StageInfo[]>("/stages.json", (stages) => (store.stages.value = stages));
  void load<GalleryEntry[]>("/gallery.json", (gallery) => (store.gallery.value = gallery));
}

async function load<T>(path: string, use: (value: T) => void): Promise<void> {
  try {
    const response = await fetch(path);
    if (!response.ok) throw new Error(`${response.status}`);
    use((await response.json()) as T);
  } catch (error) {
    store.note("error", `${path} could not be read: ${String(error)}`);
  }
}

/** Asks, and shows a refusal. */
export async function ask(message: Asked): Promise<Answer> {
  const answer = await session.ask(message);
  if (!answer.ok) {
    store.note("error", answer.hint ? `${answer.what}. ${answer.hint}` : answer.what);
    store.say(`Refused: ${answer.what}`);
  }
  return answer;
}

function hear(told: Told): void {
  batch(() => {
    switch (told.tell) {
      case "welcome": store.welcome.value = told; break;
      case "recipe": hearRecipe(told); break;
      case "state": hearState(told); break;
      case "charts": store.charts.value = told; break;
      case "fields": store.fields.value = told.names; break;
      case "log": store.note(told.kind, told.text); break;
      case "latency": store.latency.value = { server: told.sent - told.received, whole: store.latency.value?.whole ?? NaN }; break;
      case "built":
        store.built.value = told;
        store.failed.value = null;
        store.note("note", `Built ${told.files.length} files in ${told.seconds.toFixed(1)} s.`);
        store.say("The build is done.");
        break;
      case "failed":
        store.failed.value = told.hint ? `${told.error}. ${told.hint}` : told.error;
        store.say(`The ${told.what} failed: ${told.error}`);
        break;
      case "contact":
        store.contact.value = store.contact.value.map((c) => (c.seed === told.seed ? { ...c, picture: told.png } : c));
        break;
    }
  });
}

function hearRecipe(told: Extract<Told, { tell: "recipe" }>): void {
  const before = store.recipe.value;
  const opened = opening || before === null || before.path !== told.path || (before.stages.length === 0) !== (told.stages.length === 0);
  opening = false;
  store.recipe.value = told;
  const chosen = store.selected.value;
  const stage = chosen ? told.stages[chosen.stage] : undefined;
  const gone = chosen && (!stage || (chosen.process !== null && !stage.processes[chosen.process]));
  if (opened || gone) {
    store.selected.value = firstToChange(told.stages);
  }
  if (opened) {
    store.past.value = [];
    store.pastAt.value = null;
    store.keptA.value = store.keptB.value = null;
    store.comparing.value = null;
    if (before !== null) store.layers.value = new Map();
    store.homeAsked.value++;
    store.lookedAt.value = null;
  }
  if (told.errors.length) store.say(`The recipe has ${told.errors.length} mistakes: ${told.errors[0]!.what}`);
}

/** A process with a plain number in the text, which a slider can move; else the first step. */
function firstToChange(stages: Stage[]): store.Selected {
  for (const [stage, s] of stages.entries()) {
    const process = s.processes.findIndex((p) => Object.values(p.given).some((v) => parseQuantity(v)));
    if (s.on && process >= 0) return { stage, process };
  }
  return stages.length ? { stage: 0, process: null } : null;
}

function hearState(told: Extract<Told, { tell: "state" }>): void {
  const before = store.run.value;
  store.run.value = told;
  if (told.error && told.error !== before?.error) store.note("error", told.error);
  if (before?.running !== told.running || before.paused !== told.paused || before.level !== told.level) {
    store.say(told.running ? (told.paused ? "Paused." : `Running, level ${told.level ?? ""}.`) : "Ready.");
  }
}

function take(frame: Frame): void {
  const whole = assembler.add(frame);
  if (!frame.header.last) return;
  toAcknowledge.push(frame.header.frame);
  if (!whole?.length) return acknowledge();
  const { stamp } = frame.header;
  if (stamp !== null && dragStamps.delete(stamp)) {
    stampToDraw = stamp;
    drawnWaiter?.();
    for (const older of dragStamps) if (older < stamp) dragStamps.delete(older);
  }
  const next = new Map(whole.map((raster) => [raster.layer, raster]));
  batch(() => {
    store.layers.value = next;
    keepPast(next);
  });
}

/** Called when a picture of the newest state is begun: the server may send the next. */
export function begunNow(): void {
  acknowledge();
  stampInWork = stampToDraw;
  stampToDraw = null;
}

/** Called when that picture has been drawn: measures. */
export function drawnNow(): void {
  if (stampInWork === null) return;
  const whole = performance.now() - stampInWork;
  stampInWork = null;
  if (whole < 0 || whole > 60_000) return;
  store.latencies.push(whole);
  if (store.latencies.length > 400) store.latencies.shift();
  store.latency.value = { server: store.latency.value?.server ?? NaN, whole };
  const sorted = [...store.latencies].sort((a, b) => a - b);
  const p95 = sorted[Math.min(sorted.length - 1, Math.ceil(sorted.length * 0.95) - 1)]!;
  store.note("latency", `event to drawn ${whole.toFixed(0)} ms; 95 % of ${sorted.length} under ${p95.toFixed(0)} ms`);
}

function acknowledge(): void {
  const frames = toAcknowledge;
  toAcknowledge = [];
  for (const frame of frames) void session.ask({ do: "ack", frame });
}

/** Layers that the views need; those that the ground does not have are not sent. */
export function wanted(): string[] {
  const names = new Set(["elevation", "drainage_area", "lake_depth", "surface_material"]);
  const field = store.colourField.value;
  if (store.look.value === "field" && field !== "slope") names.add(field);
  return [...names];
}

let asked = "";

/** Asks for the wanted layers, if they are others than those asked for last. */
export function showWanted(): void {
  const fields = wanted();
  const stage = store.lookedAt.value;
  const key = `${stage} ${fields.join(" ")}`;
  if (key === asked) return;
  asked = key;
  void ask({ do: "show", fields, stage });
}

export function lookAfter(stage: number | null): void {
  store.lookedAt.value = stage;
  showWanted();
}

/** Longest wait for a picture before the next value of a drag is sent, ms. */
const MOST_WAIT = 600;
let drawnWaiter: (() => void) | null = null;

/** While something is dragged, the next value waits for the picture of the last: else none would ever be finished. */
const dragged = new Newest<Asked>(async (message) => {
  const answer = await ask(message);
  if (!answer.ok || message.do !== "set" || !message.dragging || !dragStamps.has(message.stamp)) return;
  await new Promise<void>((done) => {
    const timer = window.setTimeout(done, MOST_WAIT);
    drawnWaiter = () => {
      window.clearTimeout(timer);
      done();
    };
  });
  drawnWaiter = null;
});

/** One value of the text. While a slider moves, the newest value wins. */
export function setValue(place: Place, value: Value, dragging: boolean): void {
  if (!dragging) drawnWaiter?.();
  const stamp = performance.now();
  if (dragging) dragStamps.add(stamp);
  dragged.push(JSON.stringify(place), { do: "set", ...place, value, dragging, stamp });
}

/** Whether the next recipe that is told is another one, not a change. */
let opening = false;

export function openGallery(name: string): void {
  store.dialog.value = null;
  opening = true;
  void ask({ do: "open", gallery: name }).then(() => (opening = false));
}

/** A seed that nobody has seen. */
export function newSeed(): number {
  return crypto.getRandomValues(new Uint32Array(1))[0]! % 1_000_000;
}

export function setSeed(seed: number): void {
  setValue({ stage: null, process: null, key: ["seed"] }, seed, false);
}

export function askContact(count: number): void {
  const seeds = Array.from({ length: count }, newSeed);
  store.contact.value = seeds.map((seed) => ({ seed, picture: null }));
  void ask({ do: "contact", seeds });
}

/** Keeps what is shown, to compare it with something later. */
export function keep(which: "A" | "B"): void {
  const state = store.land.value;
  if (!state) return;
  const seed = store.recipe.value?.seed ?? "?";
  const name = `${which}: seed ${seed}, level ${state.ground.level}`;
  (which === "A" ? store.keptA : store.keptB).value = { name, state };
  store.say(`Kept as ${which}.`);
}
