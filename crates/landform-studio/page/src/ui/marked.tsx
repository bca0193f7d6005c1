// Texts in which names stand between backticks.

/** Names as code. */
export function Marked({ text }: { text: string }) {
  return <>{text.split("`").map((part, i) => (i % 2 ? <code key={i}>{part}</code> : part))}</>;
}

/** What is wrong, and what to do about it. */
export function Fault({ what, hint, line }: { what: string; hint?: string | null; line?: number | null }) {
  return (
    <p class="fault">
      {line ? `Line ${line}: ` : ""}
      <Marked text={hint ? `${what}. ${hint.charAt(0).toUpperCase()}${hint.slice(1)}` : what} />
    </p>
  );
}
