//! `landform cite`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::recipe::{Recipe, cite};

use crate::show_error::{Failure, about};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// The recipe.
    recipe: PathBuf,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let recipe = Recipe::load(&args.recipe, &[]).map_err(about(&args.recipe))?;
    for c in cite(&recipe) {
        let doi = if c.doi.is_empty() { String::new() } else { format!(" doi:{}", c.doi) };
        say!("{}: {}.{doi} (for {})", c.authors, c.title, c.stages.join(", "));
    }
    Ok(ExitCode::SUCCESS)
}
