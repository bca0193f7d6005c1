// Inline values of TOML: read and written, for fields that hold whole tables, lists or formulas.
import type { Table, Value } from "../protocol/messages.ts";

/** The text of a value, as it stands behind `key =`. */
export function tomlText(value: Value): string {
  if (value === null) return "";
  if (typeof value === "string") return quoted(value);
  if (typeof value === "number" || typeof value === "boolean") return String(value);
  if (Array.isArray(value)) return `[${value.map(tomlText).join(", ")}]`;
  const rows = Object.entries(value).map(([key, v]) => `${/^[A-Za-z0-9_-]+$/.test(key) ? key : quoted(key)} = ${tomlText(v)}`);
  return rows.length ? `{ ${rows.join(", ")} }` : "{}";
}

function quoted(text: string): string {
  return JSON.stringify(text);
}

export class TomlError extends Error {}

/** Reads an inline value. */
export function parseToml(text: string): Value {
  const reader = new Reader(text);
  const value = reader.value(0);
  reader.end();
  return value;
}

class Reader {
  private at = 0;
  constructor(private readonly text: string) {}

  value(depth: number): Value {
    if (depth > 32) throw new TomlError("the value is nested too deeply");
    this.space();
    const c = this.text[this.at];
    if (c === '"' || c === "'") return this.string(c);
    if (c === "[") return this.array(depth);
    if (c === "{") return this.table(depth);
    const word = /^[^\s,\]}#]+/.exec(this.text.slice(this.at))?.[0];
    if (!word) throw new TomlError("a value is missing");
    this.at += word.length;
    if (word === "true" || word === "false") return word === "true";
    const plain = word.replaceAll("_", "");
    if (!/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(plain)) throw new TomlError(`\`${word}\` is neither a number nor in quotes`);
    return Number(plain);
  }

  end(): void {
    this.space();
    if (this.at < this.text.length) throw new TomlError(`\`${this.text.slice(this.at, this.at + 12)}\` stands after the value`);
  }

  private string(mark: string): string {
    const pattern = mark === '"' ? /^"(?:[^"\\\n]|\\.)*"/ : /^'[^'\n]*'/;
    const found = pattern.exec(this.text.slice(this.at))?.[0];
    if (!found) throw new TomlError("a quotation mark is missing");
    this.at += found.length;
    if (mark === "'") return found.slice(1, -1);
    try {
      return JSON.parse(found) as string;
    } catch {
      throw new TomlError("a string has an unknown escape");
    }
  }

  private array(depth: number): Value[] {
    const out: Value[] = [];
    this.at++;
    for (;;) {
      if (this.take("]")) return out;
      out.push(this.value(depth + 1));
      if (!this.take(",") && !this.peek("]")) throw new TomlError("`]` is missing");
    }
  }

  private table(depth: number): Table {
    const out: Table = {};
    this.at++;
    for (;;) {
      if (this.take("}")) return out;
      const key = this.key();
      if (!this.take("=")) throw new TomlError(`\`=\` is missing after \`${key}\``);
      out[key] = this.value(depth + 1);
      if (!this.take(",") && !this.peek("}")) throw new TomlError("`}` is missing");
    }
  }

  private key(): string {
    this.space();
    const c = this.text[this.at];
    if (c === '"' || c === "'") return this.string(c);
    const word = /^[A-Za-z0-9_-]+/.exec(this.text.slice(this.at))?.[0];
    if (!word) throw new TomlError("a key is missing");
    this.at += word.length;
    return word;
  }

  private space(): void {
    while (/\s/.test(this.text[this.at] ?? "")) this.at++;
  }

  private peek(c: string): boolean {
    this.space();
    return this.text[this.at] === c;
  }

  private take(c: string): boolean {
    if (!this.peek(c)) return false;
    this.at++;
    return true;
  }
}
