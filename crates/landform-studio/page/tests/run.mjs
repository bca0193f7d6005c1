// Bundles the tests (TypeScript) and runs them with Node's own runner.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "..", "build", "tests");
const entryPoints = (await readdir(here)).filter((f) => f.endsWith(".test.ts")).map((f) => join(here, f));
await build({ entryPoints, outdir: out, bundle: true, platform: "node", format: "esm", outExtension: { ".js": ".mjs" }, logLevel: "warning", external: ["ws"] });
const files = (await readdir(out)).filter((f) => f.endsWith(".test.mjs")).map((f) => join(out, f));
process.exit(spawnSync(process.execPath, ["--test", ...files], { stdio: "inherit", cwd: join(here, "..") }).status ?? 1);
