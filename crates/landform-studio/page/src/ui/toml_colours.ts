// Colours of TOML: comments, strings, keys, numbers and headings.

export interface Piece {
  text: string;
  kind: "" | "comment" | "string" | "key" | "number" | "head";
}

const TOKEN = /(#.*$)|("(?:[^"\\]|\\.)*"|'[^']*')|([A-Za-z_][\w-]*(?=\s*=))|([+-]?\b\d[\d_]*(?:\.\d+)?(?:[eE][+-]?\d+)?\b|\b(?:true|false)\b)/g;

export function colourToml(text: string): Piece[][] {
  return text.split("\n").map(colourLine);
}

function colourLine(line: string): Piece[] {
  if (/^\s*\[.*\]\s*(#.*)?$/.test(line) && !/=/.test(line.split("#")[0]!)) return [{ text: line, kind: "head" }];
  const out: Piece[] = [];
  let at = 0;
  for (const match of line.matchAll(TOKEN)) {
    if (match.index > at) out.push({ text: line.slice(at, match.index), kind: "" });
    const kind = match[1] ? "comment" : match[2] ? "string" : match[3] ? "key" : "number";
    out.push({ text: match[0], kind });
    at = match.index + match[0].length;
  }
  if (at < line.length) out.push({ text: line.slice(at), kind: "" });
  return out;
}
