// What the shown ground can be written as. Each file is written at full size, and then offered.
import { useSignal } from "@preact/signals";
import { bytesText } from "../form/quantity.ts";
import { ask } from "../model/actions.ts";
import { built, dialog, failed, run, welcome } from "../model/store.ts";
import type { Table } from "../protocol/messages.ts";
import { Modal } from "./parts.tsx";
import { words } from "./words.ts";

interface Form {
  name: string;
  help: string;
  use: string;
  parameters: Table;
}

const FORMS: Form[] = [
  { name: "Unreal Engine", help: "16-bit PNG height map, with a card of the numbers to type", use: "write_heightmap", parameters: { preset: "unreal", path: "unreal.png" } },
  { name: "Unity", help: "16-bit RAW height map, with its card", use: "write_heightmap", parameters: { preset: "unity", path: "unity.raw" } },
  { name: "Godot", help: "Height map for Terrain3D (EXR), with its card", use: "write_heightmap", parameters: { preset: "godot", path: "godot.exr" } },
  { name: "Blender", help: "Height map for displacement (EXR)", use: "write_heightmap", parameters: { preset: "blender", path: "blender.exr" } },
  { name: "Mesh (GLB)", help: "For any program that reads glTF", use: "write_mesh", parameters: { path: "land.glb" } },
  { name: "GeoTIFF", help: "Elevations as numbers, for QGIS and other GIS", use: "write_raster", parameters: { field: "elevation", path: "elevation.tif" } },
  { name: "Weight maps", help: "Rock, soil, sand and snow as weights that sum to 255", use: "write_weights", parameters: { path: "weights.png" } },
  { name: "Contours", help: "Lines of equal height (GeoJSON)", use: "write_contours", parameters: {} },
  { name: "Report", help: "One page with pictures, charts and the report card (HTML)", use: "write_report", parameters: { path: "report.html" } },
];

export function Export() {
  const busy = useSignal<string | null>(null);
  const work = run.value?.building || null;
  const files = built.value?.files ?? [];
  const write = async (form: Form) => {
    busy.value = form.name;
    failed.value = null;
    const answer = await ask({ do: "export", use: form.use, parameters: form.parameters });
    busy.value = null;
    if (!answer.ok) failed.value = answer.hint ? `${answer.what}. ${answer.hint}` : answer.what;
  };
  return (
    <Modal title="Export" wide test="export" onClose={() => (dialog.value = null)}>
      <p class="dim lead">The land is first built at full size. Files go to <b>{welcome.value?.output ?? "the output folder"}</b>, and can be taken from here.</p>
      <ul class="forms">
        {FORMS.map((f) => (
          <li key={f.name}>
            <button type="button" class="form-card" disabled={busy.value !== null || work?.what === "export"} data-testid={`export-${f.name.split(" ")[0]!.toLowerCase()}`} onClick={() => void write(f)}>
              <b>{f.name}</b>
              <small>{busy.value === f.name ? "writing…" : f.help}</small>
            </button>
          </li>
        ))}
      </ul>
      {failed.value && <p class="fault" role="alert">{failed.value}</p>}
      {work && <p class="busy" role="status">{work.name ? words(work.name) : "Building"} at full size{work.part ? `: ${Math.round(work.part * 100)} %` : "…"}</p>}
      {files.length > 0 && (
        <section class="files">
          <h3>Written</h3>
          <ul>
            {files.map((f) => (
              <li key={f.path}><a href={`/files?path=${encodeURIComponent(f.path)}`} download={f.path.split("/").at(-1)}>{f.path}</a> <small class="dim">{bytesText(f.bytes)}</small></li>
            ))}
          </ul>
        </section>
      )}
    </Modal>
  );
}
