//! `landform stages`.

use std::process::ExitCode;

use landform::core::error::nearest;
use landform::core::{Error, Result};
use landform::recipe::{Verb, catalogue, describe, parameters, stages};

use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Name of a stage; without it, all are listed.
    name: Option<String>,
}

const VERBS: [Verb; 6] = [Verb::Generate, Verb::Edit, Verb::Process, Verb::Convert, Verb::Measure, Verb::Export];

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    match &args.name {
        Some(name) => one(name)?,
        None => all(),
    }
    Ok(ExitCode::SUCCESS)
}

fn first_sentence(text: &str) -> &str {
    text.split_inclusive(". ").next().unwrap_or(text).trim()
}

fn all() {
    for verb in VERBS {
        say!("{}", verb.title());
        if verb == Verb::Process {
            say!("  {:<18} {}", "evolve", first_sentence(&describe("evolve").unwrap_or_default()));
        }
        for (stage, kinds) in catalogue().into_iter().filter(|(s, _)| s.verb == verb) {
            let on = if kinds.is_empty() { String::new() } else { format!(" [{}]", kinds.join(", ")) };
            say!("  {:<18} {}{on}", stage.name, first_sentence(&stage.summary()));
        }
        say!();
    }
    say!("landform stages NAME shows one stage's parameters.");
}

fn one(name: &str) -> Result<()> {
    let Some(parameters) = parameters(name) else {
        let hint = nearest(name, stages().map(|s| s.name).chain(["evolve"])).map(|n| format!("did you mean `{n}`?"));
        return Err(Error::Recipe { at: None, what: format!("stage `{name}` is not known"), hint });
    };
    say!("{name}: {}\n", describe(name).unwrap_or_default());
    for p in parameters {
        let unit = if p.unit.is_empty() { String::new() } else { format!(" [{}]", p.unit) };
        let varying = if p.varying { ", may vary in space" } else { "" };
        let range = if p.range.is_empty() { String::new() } else { format!(", {}", p.range) };
        say!("  {}{unit} = {}{range}{varying}", p.name, p.default);
        say!("      {}", p.meaning);
    }
    if let Some(stage) = stages().find(|s| s.name == name) {
        if !stage.writes.is_empty() {
            say!("\n  leaves: {}", stage.writes.join(", "));
        }
        say!("\n  reach: {}", (stage.form.reach)());
        for source in stage.sources {
            say!("\n  source: {}: {}. {}", source.authors, source.title, source.doi);
        }
    }
    Ok(())
}
