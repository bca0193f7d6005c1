//! `cargo xtask reproduce THESIS`: runs the gallery's recipes of a thesis and writes ours beside its numbers.

mod bell;
mod pytel;

use std::path::Path;
use std::process::Command;

/// Runs, in a release build whatever this one is.
pub(crate) fn run(which: Option<&str>) -> bool {
    let Some(thesis @ ("bell" | "pytel")) = which else {
        println!("cargo xtask reproduce bell    Bell's thesis on stream power: docs/bell/README.md");
        println!("cargo xtask reproduce pytel   Pytel's figures of synthesis and analysis: docs/pytel/README.md");
        return false;
    };
    if cfg!(debug_assertions) {
        let args = ["run", "--release", "--quiet", "--package", "xtask", "--", "reproduce", thesis];
        return Command::new("cargo").args(args).status().is_ok_and(|s| s.success());
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let done = if thesis == "bell" { bell::run(&root) } else { pytel::run(&root) };
    match done {
        Ok(()) => true,
        Err(e) => {
            eprintln!("error: {e}");
            false
        }
    }
}
