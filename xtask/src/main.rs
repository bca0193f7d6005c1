//! The project's own commands: `cargo xtask COMMAND`.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command line speaks")]

mod documented;
mod fuzz;
mod instructions;
mod layers;
mod peers;
mod reproduce;
mod validate;

use std::process::{Command, ExitCode};

const HELP: &str = "cargo xtask COMMAND
  ci                  tests, fmt, clippy, docs, layers: what CI runs
  layers              checks who imports whom
  instructions [--accept]  counts instructions of hot paths against those kept, or keeps what is counted now
  documented [--accept]  counts public items without an example or a unit: the counts only fall
  gallery [--accept]  runs the gallery's goldens, or accepts what comes out now
  fuzz [SECONDS]      throws damaged files at every reader, SECONDS each (60)
  reproduce NAME      a thesis' tables and figures, ours beside its own (docs); without a name: which there are
  validate            convergence studies; prints tables
  validate card [FOLDER]  verdicts of the report card on fakes, and on crops of a folder's elevation files
  peers TASK          a task of other programs' benchmarks, one line of JSON (build with --release)
  bench               cargo bench";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let done = match args.first().map(String::as_str) {
        Some("ci") => ci(),
        Some("layers") => layers::check(),
        Some("instructions") => instructions::run(args.iter().any(|a| a == "--accept")),
        Some("documented") => documented::run(args.iter().any(|a| a == "--accept")),
        Some("gallery") => gallery(args.iter().any(|a| a == "--accept")),
        Some("fuzz") => fuzz::run(args.get(1).and_then(|s| s.parse().ok()).unwrap_or(60.0)),
        Some("reproduce") => reproduce::run(&args[1..]),
        Some("validate") => validate::run(&args[1..]),
        Some("peers") => peers::run(&args[1..]),
        Some("bench") => cargo(&["bench", "--workspace"], &[]),
        _ => {
            println!("{HELP}");
            true
        }
    };
    if done { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn cargo(args: &[&str], env: &[(&str, &str)]) -> bool {
    println!("> cargo {}", args.join(" "));
    Command::new("cargo").args(args).envs(env.iter().copied()).status().is_ok_and(|s| s.success())
}

fn gallery(accept: bool) -> bool {
    let env: &[_] = if accept { &[("LANDFORM_ACCEPT_GOLDENS", "1")] } else { &[] };
    cargo(&["test", "-p", "landform", "--test", "gallery"], env)
}

fn ci() -> bool {
    cargo(&["test", "--workspace"], &[])
        && cargo(&["fmt", "--all", "--check"], &[])
        && cargo(&["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[])
        && cargo(&["doc", "--workspace", "--no-deps", "--document-private-items"], &[("RUSTDOCFLAGS", "-D warnings")])
        && layers::check()
        && documented::run(false)
        && instructions::run(false)
}
