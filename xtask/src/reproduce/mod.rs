//! `cargo xtask reproduce THESIS`: runs the gallery's recipes of a thesis and writes ours beside
//! its numbers.

mod bell;
mod cave_numbers;
mod caves;
mod pytel;
mod rivers;
mod self_organised;

use std::path::Path;
use std::process::Command;

/// Names of what can be reproduced, with what that is.
const THESES: &[(&str, &str)] = &[
    ("bell", "Bell's thesis on stream power: docs/bell/README.md"),
    ("pytel", "Pytel's figures of synthesis and analysis: docs/pytel/README.md"),
    ("pytel-dunes", "Pytel's dunes: docs/pytel/dunes.md"),
    ("pytel-coasts", "Pytel's coasts: docs/pytel/coasts.md"),
    ("pytel-rivers", "Pytel's rivers and two-stage terrains: docs/pytel/rivers.md"),
    ("pytel-caves", "Pytel's caves: docs/pytel/caves.md"),
    ("koh-dunes", "Koh's dunes: docs/koh/README.md"),
    ("koh-streams", "Koh's streams: docs/koh/streams.md"),
];

/// Runs, in a release build whatever this one is.
pub(crate) fn run(which: &[String]) -> bool {
    let known = |name: &String| THESES.iter().any(|t| t.0 == name);
    if which.is_empty() || !which.iter().all(known) {
        for (name, what) in THESES {
            println!("cargo xtask reproduce {name:<13} {what}");
        }
        return false;
    }
    if cfg!(debug_assertions) {
        let args = ["run", "--release", "--quiet", "--package", "xtask", "--", "reproduce"];
        return Command::new("cargo").args(args).args(which).status().is_ok_and(|s| s.success());
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for name in which {
        let done = match name.as_str() {
            "bell" => bell::run(&root),
            "pytel" => pytel::run(&root),
            "pytel-dunes" => self_organised::run(&root, &self_organised::PYTEL_DUNES),
            "pytel-coasts" => self_organised::run(&root, &self_organised::PYTEL_COASTS),
            "pytel-rivers" => self_organised::run(&root, &rivers::PYTEL_RIVERS),
            "pytel-caves" => self_organised::run(&root, &caves::PYTEL_CAVES),
            "koh-streams" => self_organised::run(&root, &rivers::KOH_STREAMS),
            _ => self_organised::run(&root, &self_organised::KOH_DUNES),
        };
        if let Err(e) = done {
            eprintln!("error: {e}");
            return false;
        }
    }
    true
}
