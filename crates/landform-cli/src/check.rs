//! `landform check`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::core::Result;
use landform::core::error::bytes_text;
use landform::io::memory;
use landform::recipe::{Cache, Override, Plan, PlannedStage, Recipe};

use crate::part::Part;
use crate::run::salt;
use crate::show_error::{Failure, about};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// The recipe.
    recipe: PathBuf,
    /// Output folder whose cache is searched.
    #[arg(short, long)]
    output: Option<PathBuf>,
    /// Sets a key: LABEL_OR_STAGE.key=value.
    #[arg(long = "set", value_name = "STAGE.KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    part: Part,
    /// As in `run`: lets stages write outside of the output folder.
    #[arg(long)]
    allow_outside: bool,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let overrides = args.set.iter().map(|s| Override::parse(s)).collect::<Result<Vec<_>>>()?;
    let mut recipe = args.part.of(Recipe::load(&args.recipe, &overrides)).map_err(about(&args.recipe))?;
    recipe.allow_outside = args.allow_outside;
    let cache = args.output.as_ref().map(|o| Cache::on_disk(&o.join(".landform/cache")));
    let plan = recipe.plan(cache.as_ref(), &salt()).map_err(about(&args.recipe))?;
    say!("{} (seed {})", recipe.title, recipe.seed);
    let of_stages = plan.stages.iter().flat_map(|stage| &stage.notes);
    recipe.notes.iter().chain(&recipe.file_notes()).chain(of_stages).for_each(|note| say!("note: {note}"));
    print_plan(&plan, cache.as_ref());
    let free = memory::available().map(|m| format!(" of {} free", bytes_text(m))).unwrap_or_default();
    say!("memory: about {}{free}", bytes_text(plan.bytes));
    Ok(ExitCode::SUCCESS)
}

/// What is known of a stage in the cache.
fn cached_text(stage: &PlannedStage, cache: Option<&Cache>) -> String {
    match cache.filter(|_| stage.cached).map(|cache| stage.check_kept(cache)) {
        None => String::new(),
        Some(Err(e)) => format!("  damaged in the cache ({e}); made again where it is needed"),
        Some(Ok(())) if stage.watched => "  cached, but runs again for `watch`".into(),
        Some(Ok(())) => "  cached".into(),
    }
}

fn print_plan(plan: &Plan, cache: Option<&Cache>) {
    for (k, stage) in plan.stages.iter().enumerate() {
        let label = stage.label.as_ref().map(|l| format!("{l}: ")).unwrap_or_default();
        let cached = cached_text(stage, cache);
        say!(
            "{:>3}  {:<8} {:<52} {:>10} nodes  {:<12} {:>10}{cached}",
            k + 1,
            stage.verb.title(),
            format!("{label}{}", stage.name),
            stage.nodes,
            stage.kind.map_or("", |k| k.name()),
            bytes_text(stage.bytes)
        );
    }
}
