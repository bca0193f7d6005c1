// Landscapes to begin with, as pictures.
import { openGallery } from "../model/actions.ts";
import { dialog, gallery } from "../model/store.ts";
import { Modal } from "./parts.tsx";

export function Welcome() {
  return (
    <main class="welcome">
      <h1>Choose a landscape to begin with</h1>
      <p class="dim">Each is a recipe. It grows before your eyes; every value in it can be changed.</p>
      <Pictures />
    </main>
  );
}

export function Gallery() {
  return (
    <Modal title="Open a landscape" wide test="gallery" onClose={() => (dialog.value = null)}>
      <Pictures />
    </Modal>
  );
}

function Pictures() {
  return (
    <ul class="pictures">
      {gallery.value.map((entry) => (
        <li key={entry.name}>
          <button type="button" class="picture" data-testid={`open-${entry.name}`} onClick={() => openGallery(entry.name)}>
            <img src={entry.picture} alt="" width="360" height="240" />
            <span class="picture-title">{entry.title}</span>
            <span class="picture-look">{entry.text ?? entry.look}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
