// The text of the recipe: the whole truth. What is typed is sent after a pause; mistakes are marked at their lines.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { ask } from "../model/actions.ts";
import { recipe } from "../model/store.ts";
import { Fault } from "./marked.tsx";
import { colourToml } from "./toml_colours.ts";

export function Editor() {
  const r = recipe.value;
  const area = useRef<HTMLTextAreaElement>(null);
  const back = useRef<HTMLPreElement>(null);
  const gutter = useRef<HTMLOListElement>(null);
  const text = useSignal(r?.text ?? "");
  const sent = useRef(r?.text ?? "");
  const timer = useRef(0);

  useEffect(() => {
    // The server's text wins unless something typed here is still on its way.
    if (r && timer.current === 0 && r.text !== text.value) {
      text.value = r.text;
      sent.current = r.text;
    }
  }, [r?.revision, r?.text]);
  useEffect(() => () => { if (timer.current) { window.clearTimeout(timer.current); send(); } }, []);

  const send = () => {
    timer.current = 0;
    if (text.value === sent.current) return;
    sent.current = text.value;
    void ask({ do: "text", text: text.value });
  };
  const type = (typed: string) => {
    text.value = typed;
    window.clearTimeout(timer.current);
    timer.current = window.setTimeout(send, 350);
  };
  const follow = () => {
    const { scrollTop, scrollLeft } = area.current!;
    back.current!.scrollTop = gutter.current!.scrollTop = scrollTop;
    back.current!.scrollLeft = scrollLeft;
  };
  const wrongLines = new Map((r?.errors ?? []).filter((e) => e.line !== null).map((e) => [e.line, e.what]));
  const lines = text.value.split("\n");
  return (
    <div class="editor" data-testid="editor">
      <div class="editor-box">
        <ol class="gutter" ref={gutter} aria-hidden="true">
          {lines.map((_, i) => <li key={i} class={wrongLines.has(i + 1) ? "wrong" : ""} title={wrongLines.get(i + 1)}>{i + 1}</li>)}
        </ol>
        <div class="editor-text">
          <pre ref={back} aria-hidden="true">
            {colourToml(text.value).map((line, i) => (
              <div key={i} class={wrongLines.has(i + 1) ? "wrong" : ""}>{line.map((p, k) => (p.kind ? <span key={k} class={`t-${p.kind}`}>{p.text}</span> : p.text))}{"\n"}</div>
            ))}
          </pre>
          <textarea
            ref={area} aria-label="Text of the recipe" spellcheck={false} autocomplete="off" wrap="off" value={text.value} data-testid="text"
            onInput={(e) => type(e.currentTarget.value)} onScroll={follow} onBlur={() => { if (timer.current) { window.clearTimeout(timer.current); send(); } }}
          />
        </div>
      </div>
      <div class="editor-faults" role="alert">
        {(r?.errors ?? []).map((e) => (
          <div class="editor-fault" key={`${e.line} ${e.what}`}>
            {e.line !== null && <button type="button" class="link" onClick={() => goTo(area.current!, e.line!, e.column ?? 1)}>Line {e.line}</button>}
            <Fault what={e.what} hint={e.hint} />
          </div>
        ))}
      </div>
    </div>
  );
}

function goTo(area: HTMLTextAreaElement, line: number, column: number): void {
  const lines = area.value.split("\n");
  const at = lines.slice(0, line - 1).reduce((sum, l) => sum + l.length + 1, 0) + column - 1;
  area.focus();
  area.setSelectionRange(at, at + Math.max(1, (lines[line - 1]?.length ?? 0) - column + 1));
  area.scrollTop = Math.max(0, (line - 6) * 19);
}
