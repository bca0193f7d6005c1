// What client and server say to each other, as JSON text. See README.md for the words.

/** A value as the text of a recipe holds it. */
export type Value = number | string | boolean | null | Value[] | { [key: string]: Value };
export type Table = { [key: string]: Value };

export interface Fault {
  line: number | null;
  column: number | null;
  what: string;
  hint?: string | null;
  stage: number | null;
}

export interface Step {
  use: string;
  label?: string | null;
  given: Table;
  values: Table;
}

export interface Stage extends Step {
  index: number;
  verb?: string;
  on: boolean;
  line: number;
  processes: Step[];
  seconds: number | null;
  nodes: number | null;
  notes: string[];
}

export interface Recipe {
  revision: number;
  title: string | null;
  path: string | null;
  text: string;
  saved: boolean;
  seed: number | string | null;
  can_undo: boolean;
  can_redo: boolean;
  command: string;
  errors: Fault[];
  stages: Stage[];
  /** The recipe's own keys (seed, title, environment), as the text holds them. */
  given?: Table;
}

export interface RunState {
  running: boolean;
  paused: boolean;
  settling: boolean;
  level: string | null;
  stage: number | null;
  of: number | null;
  name: string | null;
  steps: number | null;
  time: number | null;
  part: number | null;
  residual: number | null;
  memory_bytes: number | null;
  seconds: number | null;
  seconds_left: number | null;
  building: Background | null | false;
  /** What the last run failed with. */
  error?: string | null;
}

/** Work beside the preview. */
export interface Background {
  what: "build" | "export" | "contact";
  stage: number | null;
  of: number | null;
  name: string | null;
  part: number | null;
  seconds: number | null;
  waiting: number | null;
}

export interface CardRow {
  name: string;
  value: number | null;
  low: number | null;
  high: number | null;
  unit: string | null;
  verdict: string | null;
  meaning?: string | null;
  source?: string | null;
  decides?: boolean;
}

export interface Charts {
  revision: number;
  level: string | null;
  summary: { [name: string]: number | null };
  histogram: { edges: number[]; counts: number[] } | null;
  hypsometry: [number, number][] | null;
  slope_area: [number, number][] | null;
  card: CardRow[] | null;
  verdict?: { title: string; reason: string } | null;
}

export interface Welcome {
  protocol: number;
  version: string;
  session: string;
  root: string;
  output: string;
  /** What else the server understands: "paint", "stroke". */
  can?: string[];
}

export interface BuiltFile {
  path: string;
  bytes: number;
}

export type Told =
  | ({ tell: "welcome" } & Welcome)
  | ({ tell: "recipe" } & Recipe)
  | ({ tell: "state" } & RunState)
  | ({ tell: "charts" } & Charts)
  | { tell: "fields"; names: { name: string; unit: string }[] }
  | { tell: "log"; kind: "note" | "error" | "latency"; text: string }
  | { tell: "latency"; stamp: number; received: number; computed: number; sent: number }
  | { tell: "failed"; what: string; error: string; hint?: string | null }
  | { tell: "built"; files: BuiltFile[]; seconds: number }
  | { tell: "contact"; seed: number; png: string }
  | { tell: "done"; request: number; text?: string }
  | { tell: "refused"; request: number; what: string; hint?: string | null };

/** Where a value stands in a recipe: whole-recipe keys have no stage. */
export interface Place {
  stage: number | null;
  process: number | null;
  key: (string | number)[];
}

export type Asked =
  | { do: "hello"; protocol: 1 }
  | { do: "open"; gallery: string }
  | { do: "open"; path: string }
  | { do: "text"; text: string }
  | ({ do: "set"; value: Value; dragging: boolean; stamp: number } & Place)
  | { do: "insert"; at: number; use: string; process_of: number | null }
  | { do: "remove"; stage: number; process: number | null }
  | { do: "move"; stage: number; to: number }
  | { do: "toggle"; stage: number }
  | { do: "undo" | "redo" | "pause" | "step" | "stop" | "build" | "cancel_build" | "command" }
  | { do: "run"; level: string }
  | { do: "play"; pace?: number }
  | { do: "show"; fields: string[]; stage: number | null }
  | { do: "ack"; frame: number }
  | { do: "paint"; field: string; tool: string; radius: number; strength: number; points: number[][] }
  | ({ do: "stroke"; tool: string; radius: number; strength: number; points: number[][] } & Place)
  | { do: "export"; use: string; parameters: Table }
  | { do: "contact"; seeds: number[] }
  | { do: "save"; path?: string };

export interface StageInfo {
  name: string;
  verb: string;
  folder: string;
  summary: string;
  text: string;
  sources: { authors: string; title: string; doi?: string | null }[];
}

export interface GalleryEntry {
  name: string;
  title: string;
  look: string;
  /** What it is, in a sentence. */
  text?: string;
  picture: string;
}
