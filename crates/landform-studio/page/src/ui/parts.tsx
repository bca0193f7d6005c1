// Buttons, dialogs and choices that all panels use.
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "./icons.tsx";

interface ButtonProps {
  icon?: string;
  label: string;
  /** Whether the label is shown, or only told. */
  text?: boolean;
  title?: string;
  disabled?: boolean;
  pressed?: boolean;
  kind?: "plain" | "strong" | "quiet";
  test?: string;
  onClick: () => void;
}

export function Button({ icon, label, text, title, disabled, pressed, kind = "plain", test, onClick }: ButtonProps) {
  return (
    <button
      type="button" class={`button ${kind}`} disabled={disabled} aria-pressed={pressed} data-testid={test}
      aria-label={text ? undefined : label} title={title ?? (text ? undefined : label)} onClick={onClick}
    >
      {icon && <Icon name={icon} />}
      {text && <span>{label}</span>}
    </button>
  );
}

interface DialogProps {
  title: string;
  wide?: boolean;
  test?: string;
  onClose: () => void;
  children: ComponentChildren;
}

export function Modal({ title, wide, test, onClose, children }: DialogProps) {
  const box = useRef<HTMLDialogElement>(null);
  const gone = useRef(false);
  useEffect(() => {
    const dialog = box.current!;
    if (!dialog.open) dialog.showModal();
    // Closing gives the focus back to what opened it.
    return () => {
      gone.current = true;
      dialog.close();
    };
  }, []);
  return (
    <dialog
      ref={box} class={wide ? "modal wide" : "modal"} aria-label={title} data-testid={test}
      onClose={() => gone.current || onClose()} onClick={(e) => e.target === box.current && box.current?.close()}
    >
      <header class="modal-head">
        <h2>{title}</h2>
        <Button icon="close" label="Close" kind="quiet" onClick={() => box.current!.close()} />
      </header>
      <div class="modal-body">{children}</div>
    </dialog>
  );
}

interface SegmentsProps<T extends string> {
  label: string;
  value: T;
  choices: { value: T; label: string }[];
  onChange: (value: T) => void;
}

/** A few choices side by side, one of which holds. */
export function Segments<T extends string>({ label, value, choices, onChange }: SegmentsProps<T>) {
  return (
    <div class="segments" role="group" aria-label={label}>
      {choices.map((c) => (
        <button key={c.value} type="button" aria-pressed={c.value === value} data-testid={`${label}-${c.value}`} onClick={() => onChange(c.value)}>
          {c.label}
        </button>
      ))}
    </div>
  );
}

interface SliderProps {
  label: string;
  value: number;
  low: number;
  high: number;
  step: number;
  text: string;
  onInput: (value: number) => void;
}

/** A labelled slider of the view (not of the recipe). */
export function ViewSlider({ label, value, low, high, step, text, onInput }: SliderProps) {
  return (
    <label class="view-slider">
      <span>{label}</span>
      <input
        type="range" min={low} max={high} step={step} value={value} aria-valuetext={text}
        style={{ "--part": String((value - low) / (high - low)) }} onInput={(e) => onInput(Number(e.currentTarget.value))}
      />
      <output>{text}</output>
    </label>
  );
}
