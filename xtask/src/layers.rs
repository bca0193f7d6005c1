//! Who may import whom, inside the crates (between crates the compiler sees to it).

use std::fs;
use std::path::{Path, PathBuf};

/// Inside core a module may import those of lower rank, and its own.
const CORE_RANKS: &[(&str, u32)] = &[
    ("error", 0),
    ("units", 1),
    ("math", 1),
    ("random", 1),
    ("parallel", 1),
    ("grid", 2),
    ("field", 3),
    ("terrain", 4),
    ("algo", 5),
    ("agents", 6),
    ("verb", 7),
    ("analysis", 8),
    ("sim", 8),
];
/// Modules of rank 1 may use each other downwards.
const SAME_RANK_ALLOWED: u32 = 1;

/// Checks the tree; prints every breach.
pub(crate) fn check() -> bool {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates");
    let mut breaches = Vec::new();
    for (crate_name, rule) in
        [("landform-core", core as fn(&str, &str) -> bool), ("landform-process", process), ("landform-io", io)]
    {
        let src = root.join(crate_name).join("src");
        for file in sources(&src) {
            let relative = file.strip_prefix(&src).unwrap_or(&file).to_string_lossy().replace('\\', "/");
            let module = relative.split(['/', '.']).next().unwrap_or_default().to_string();
            if module == "lib" || relative.ends_with("tests.rs") || relative.contains("/tests/") {
                continue;
            }
            let text = fs::read_to_string(&file).unwrap_or_default();
            // What stands below the tests' mark may import what it likes.
            let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
            for target in imports(code) {
                if target != module && !rule(&module, &target) {
                    breaches.push(format!("{crate_name}/src/{relative} imports `{target}`"));
                }
            }
        }
    }
    for b in &breaches {
        eprintln!("layers: {b}");
    }
    println!("layers: {}", if breaches.is_empty() { "clean" } else { "broken" });
    breaches.is_empty()
}

fn core(module: &str, target: &str) -> bool {
    let rank = |m: &str| CORE_RANKS.iter().find(|r| r.0 == m).map(|r| r.1);
    match (rank(module), rank(target)) {
        (Some(m), Some(t)) => t < m || (t == m && m == SAME_RANK_ALLOWED),
        // `crate::Error` and `crate::Result`, re-exported from `error`.
        _ => target.starts_with(|c: char| c.is_uppercase()) || target == "self",
    }
}

fn process(_: &str, target: &str) -> bool {
    target == "mechanism"
}

fn io(module: &str, target: &str) -> bool {
    match module {
        "render" => target != "format",
        "format" => !["render", "report", "export"].contains(&target),
        _ => true,
    }
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let Ok(entries) = fs::read_dir(folder) else { return found };
    for path in entries.flatten().map(|e| e.path()) {
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// First names after `crate::`, in imports and in paths; comments are left out.
fn imports(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    let lines = code.lines().filter(|l| !l.trim_start().starts_with("//"));
    let code: String = lines.collect::<Vec<_>>().join("\n");
    for part in code.split("crate::").skip(1) {
        if let Some(group) = part.strip_prefix('{') {
            let group = group.split('}').next().unwrap_or_default();
            found.extend(
                group
                    .split(',')
                    .map(|n| n.trim().split("::").next().unwrap_or_default().to_string())
                    .filter(|n| !n.is_empty()),
            );
        } else {
            found.push(part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect());
        }
    }
    found
}
