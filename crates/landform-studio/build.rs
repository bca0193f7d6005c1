//! Lists the files of the page, which are in the program.

use std::fs;
use std::path::Path;

fn main() {
    let root = std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
    let assets = Path::new(&root).join("assets");
    println!("cargo::rerun-if-changed={}", assets.display());
    let mut files = Vec::new();
    for folder in ["", "gallery"] {
        let Ok(entries) = fs::read_dir(assets.join(folder)) else { continue };
        for path in entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file()) {
            let name = path.strip_prefix(&assets).map(|name| name.to_string_lossy().replace('\\', "/"));
            files.extend(
                name.map(|name| format!("    ({name:?}, include_bytes!({:?})),\n", path.display().to_string())),
            );
        }
    }
    files.sort();
    let list = format!(
        "/// Files of the page: path and content.\nstatic ASSETS: &[(&str, &[u8])] = &[\n{}];\n",
        files.concat()
    );
    let out = std::env::var("OUT_DIR").unwrap_or_default();
    fs::write(Path::new(&out).join("assets.rs"), list).unwrap_or_else(|e| println!("cargo::error={e}"));
}
