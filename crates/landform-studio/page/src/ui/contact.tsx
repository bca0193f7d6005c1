// A sheet of pictures of several seeds; a click takes one.
import { useEffect, useRef } from "preact/hooks";
import { askContact, setSeed } from "../model/actions.ts";
import { contact, dialog, recipe, say } from "../model/store.ts";
import { Button, Modal } from "./parts.tsx";

const COUNT = 10;

export function Contact() {
  useEffect(() => {
    if (contact.value.length === 0) askContact(COUNT);
  }, []);
  return (
    <Modal title="Seeds" wide test="contact" onClose={() => (dialog.value = null)}>
      <p class="dim lead">The same recipe with other seeds. Click one to take it; the seed now is {String(recipe.value?.seed ?? 0)}.</p>
      <ul class="sheet">
        {contact.value.map(({ seed, picture }) => (
          <li key={seed}>
            <button type="button" class="picture" disabled={!picture} data-testid="contact-picture" aria-label={`Take seed ${seed}`} onClick={() => take(seed)}>
              {picture ? <Png data={picture} /> : <span class="waiting">growing…</span>}
              <span class="picture-title">{seed}</span>
            </button>
          </li>
        ))}
      </ul>
      <Button icon="dice" label="Other seeds" text test="other-seeds" onClick={() => askContact(COUNT)} />
    </Modal>
  );
}

function take(seed: number): void {
  dialog.value = null;
  setSeed(seed);
  say(`Seed ${seed} is taken.`);
}

/** Drawn on a canvas: the page's rules forbid addresses that hold data. */
function Png({ data }: { data: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    void createImageBitmap(new Blob([bytes], { type: "image/png" })).then((bitmap) => {
      const c = canvas.current;
      if (!c) return;
      c.width = bitmap.width;
      c.height = bitmap.height;
      c.getContext("2d")!.drawImage(bitmap, 0, 0);
    });
  }, [data]);
  return <canvas ref={canvas} />;
}
