// Bundles the page into ../assets: studio.js (first line: SHA-256 of the sources, see README.md), studio.css, index.html.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const assets = join(here, "..", "assets");

/** Files below `folder`, as paths from the page's folder with `/`, in any order. */
async function filesBelow(folder) {
  const entries = await readdir(join(here, folder), { withFileTypes: true });
  const nested = entries.map((e) => (e.isDirectory() ? filesBelow(`${folder}/${e.name}`) : [`${folder}/${e.name}`]));
  return (await Promise.all(nested)).flat();
}

/** Of each source, in the order of the bytes of its path: path, a zero byte, length in decimal, a zero byte, bytes. */
export async function hashOfSources() {
  const paths = [...(await filesBelow("src")), "build.mjs", "package.json", "package-lock.json", "tsconfig.json"];
  const hash = createHash("sha256");
  for (const path of paths.sort((a, b) => Buffer.compare(Buffer.from(a), Buffer.from(b)))) {
    const bytes = await readFile(join(here, path));
    hash.update(`${path}\0${bytes.length}\0`).update(bytes);
  }
  return hash.digest("hex");
}

/** Licences of the libraries that are in the bundle. */
async function licences() {
  const parts = [];
  for (const name of ["three", "preact", "@preact/signals", "@preact/signals-core"]) {
    const folder = join(here, "node_modules", name);
    const { version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    const file = (await readdir(folder)).find((f) => /^licen[cs]e/i.test(f));
    const text = file ? await readFile(join(folder, file), "utf8") : "MIT";
    parts.push(`${name} ${version}\n\n${text.trim()}\n`);
  }
  return parts.join(`\n${"-".repeat(80)}\n\n`);
}

const common = { absWorkingDir: here, bundle: true, minify: true, write: false, legalComments: "none", logLevel: "warning" };
const script = await build({
  ...common,
  entryPoints: ["src/main.tsx"],
  format: "esm",
  target: "es2022",
  jsx: "automatic",
  jsxImportSource: "preact",
  charset: "utf8",
  define: { "process.env.NODE_ENV": '"production"' },
});
const style = await build({ ...common, entryPoints: ["src/style/studio.css"], charset: "utf8" });

await mkdir(assets, { recursive: true });
await writeFile(join(assets, "studio.js"), `// sources sha256 ${await hashOfSources()}\n${script.outputFiles[0].text}`);
await writeFile(join(assets, "studio.css"), style.outputFiles[0].text);
await writeFile(join(assets, "index.html"), await readFile(join(here, "src", "index.html")));
await writeFile(join(assets, "LICENSES.txt"), await licences());
console.log(`studio.js ${script.outputFiles[0].contents.length} bytes, studio.css ${style.outputFiles[0].contents.length} bytes`);
