// Fields of a form, made from the JSON schema of recipes. Words that begin with x- are landform's own.
import type { Value } from "../protocol/messages.ts";

export interface Schema {
  $ref?: string;
  $defs?: { [name: string]: Schema };
  type?: string | string[];
  const?: Value;
  enum?: Value[];
  oneOf?: Schema[];
  anyOf?: Schema[];
  items?: Schema;
  minItems?: number;
  maxItems?: number;
  properties?: { [name: string]: Schema };
  required?: string[];
  description?: string;
  title?: string;
  default?: Value;
  minimum?: number;
  maximum?: number;
  "x-unit"?: string;
  "x-example"?: string;
  "x-min"?: number;
  "x-max"?: number;
  "x-above"?: number;
  "x-below"?: number;
  "x-soft-min"?: number;
  "x-soft-max"?: number;
  "x-scale"?: string;
  "x-group"?: string;
  "x-role"?: string;
  "x-varying"?: boolean;
}

export type Kind =
  | { is: "quantity"; unit: string; example: string; bare: boolean }
  | { is: "number"; whole: boolean }
  | { is: "switch" }
  | { is: "choice"; choices: Choice[] }
  | { is: "choices"; choices: Choice[] }
  | { is: "text" }
  | { is: "list"; count: number; unit: string; bare: boolean }
  | { is: "group"; fields: Field[] }
  | { is: "any" };

export interface Choice {
  value: string;
  help: string;
}

export interface Field {
  key: string;
  kind: Kind;
  /** Whether a formula, a map or a course in time may stand here too. */
  varying: boolean;
  /** Whether "none" is a value. */
  optional: boolean;
  help: string;
  group: string;
  default: Value | undefined;
  least: number | null;
  most: number | null;
  slider: { low: number; high: number; log: boolean } | null;
}

/** Keys of a stage that are not parameters. */
const STRUCTURE = new Set(["use", "label", "from", "with", "clock", "watch", "process"]);

export class Forms {
  constructor(private readonly schema: Schema) {}

  /** Parameters of a stage, or of a process within `evolve`. */
  stage(use: string, inProcess = false): Field[] {
    const defs = this.schema.$defs ?? {};
    const def = (inProcess ? defs[`process_${use}`] : undefined) ?? defs[use];
    return def ? this.fields(def, STRUCTURE) : [];
  }

  /** Fields of the clock, where the stage has one. */
  clock(use: string): Field[] {
    const def = this.schema.$defs?.[use]?.properties?.["clock"];
    return def ? this.fields(this.resolve(def), new Set()) : [];
  }

  environment(): Field[] {
    const def = this.schema.properties?.["environment"];
    return def ? this.fields(this.resolve(def), new Set()) : [];
  }

  /** Whether a stage can stand in `evolve`. */
  isProcess(use: string): boolean {
    return this.schema.$defs?.[`process_${use}`] !== undefined;
  }

  help(use: string): string {
    return this.schema.$defs?.[use]?.description ?? "";
  }

  private fields(def: Schema, without: Set<string>): Field[] {
    return Object.entries(def.properties ?? {})
      .filter(([key]) => !without.has(key))
      .map(([key, property]) => this.field(key, property));
  }

  private field(key: string, property: Schema): Field {
    const { inner, optional } = this.unwrap(property);
    const kind = this.kind(inner);
    const limits = { ...inner, ...property };
    return {
      key,
      kind,
      varying: inner["x-varying"] === true,
      optional,
      help: (property.description ?? inner.description ?? "").replaceAll("\n", " "),
      group: property["x-group"] ?? "main",
      default: property.default,
      least: limits["x-min"] ?? limits.minimum ?? limits["x-above"] ?? null,
      most: limits["x-max"] ?? limits.maximum ?? limits["x-below"] ?? null,
      slider: sliderOf(property, inner, kind),
    };
  }

  private resolve(schema: Schema): Schema {
    if (!schema.$ref) return schema;
    return this.schema.$defs?.[schema.$ref.split("/").at(-1)!] ?? {};
  }

  /** Without the "or null" around it. */
  private unwrap(property: Schema): { inner: Schema; optional: boolean } {
    const schema = this.resolve(property);
    const others = schema.anyOf?.filter((s) => s.type !== "null");
    if (schema.anyOf && others && others.length === schema.anyOf.length - 1 && others.length === 1) {
      return { inner: this.resolve(others[0]!), optional: true };
    }
    return { inner: schema, optional: types(schema).includes("null") };
  }

  private kind(schema: Schema): Kind {
    const choices = this.choices(schema);
    if (choices) return { is: "choice", choices };
    if (schema["x-varying"]) return this.kind(this.resolve(schema.anyOf?.[0] ?? {}));
    const is = types(schema);
    const unit = schema["x-unit"];
    if (unit !== undefined && !is.includes("array")) return quantity(schema, unit);
    if (is.includes("number")) return { is: "number", whole: false };
    if (is.includes("integer")) return { is: "number", whole: true };
    if (is.includes("boolean")) return { is: "switch" };
    if (is.includes("string")) return { is: "text" };
    if (is.includes("array")) return this.list(schema);
    if (schema.properties) return { is: "group", fields: this.fields(schema, new Set()) };
    return { is: "any" };
  }

  private list(schema: Schema): Kind {
    const items = this.resolve(schema.items ?? {});
    const choices = this.choices(items);
    if (choices) return { is: "choices", choices };
    const fixed = schema.minItems !== undefined && schema.minItems === schema.maxItems && schema.minItems <= 4;
    const simple = items["x-unit"] !== undefined || types(items).some((t) => t === "number" || t === "integer");
    if (!fixed || !simple) return { is: "any" };
    return { is: "list", count: schema.minItems!, unit: items["x-unit"] ?? "", bare: types(items).some((t) => t !== "string") };
  }

  private choices(schema: Schema): Choice[] | null {
    if (schema.enum?.every((v) => typeof v === "string")) return schema.enum.map((value) => ({ value: String(value), help: "" }));
    const words = schema.oneOf?.flatMap((s) => s.enum?.map(String) ?? (typeof s.const === "string" ? [s.const] : []));
    if (!schema.oneOf || !words || words.length < schema.oneOf.length) return null;
    return schema.oneOf.flatMap((s) =>
      (s.enum?.map(String) ?? [String(s.const)]).map((value) => ({ value, help: s.description ?? "" })),
    );
  }
}

function types(schema: Schema): string[] {
  return schema.type === undefined ? [] : Array.isArray(schema.type) ? schema.type : [schema.type];
}

function quantity(schema: Schema, unit: string): Kind {
  return { is: "quantity", unit, example: schema["x-example"] ?? "", bare: types(schema).includes("number") };
}

function sliderOf(property: Schema, inner: Schema, kind: Kind): Field["slider"] {
  if (kind.is !== "quantity" && kind.is !== "number") return null;
  const low = property["x-soft-min"] ?? inner["x-soft-min"];
  const high = property["x-soft-max"] ?? inner["x-soft-max"];
  if (low === undefined || high === undefined || !(high > low)) return guess(property, kind);
  const log = (property["x-scale"] ?? inner["x-scale"]) === "log" && low > 0;
  return { low, high, log };
}

/** Hard limits serve where they are near; angles go round; erodibility has a customary range. */
function guess(property: Schema, kind: Kind): Field["slider"] {
  const unit = kind.is === "quantity" ? kind.unit : "";
  if (unit === "1/yr") return { low: 1e-8, high: 1e-3, log: true };
  const low = property["x-min"] ?? property.minimum ?? property["x-above"];
  const high = property["x-max"] ?? property.maximum ?? property["x-below"];
  if (low !== undefined && high !== undefined && high > low && high - low <= 100) return { low, high, log: false };
  return null;
}
