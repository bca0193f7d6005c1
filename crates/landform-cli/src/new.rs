//! `landform new`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::core::error::nearest;
use landform::core::{Error, Result};
use landform::io::files::write_whole;
use landform::recipe::GALLERY;

use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Name of the recipe; without it, all are listed.
    name: Option<String>,
    /// File to write; NAME.toml if not given.
    #[arg(short, long)]
    output: Option<PathBuf>,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let Some(name) = &args.name else {
        let mut group = "";
        for recipe in GALLERY {
            if recipe.group != group {
                say!("{}{}", if group.is_empty() { "" } else { "\n" }, recipe.group);
                group = recipe.group;
            }
            say!("  {:<26} {}", recipe.name, recipe.text.lines().next().unwrap_or_default().trim_start_matches("# "));
        }
        return Ok(ExitCode::SUCCESS);
    };
    let Some(recipe) = GALLERY.iter().find(|r| r.name == name) else {
        let names = GALLERY.iter().map(|r| r.name);
        let hint = nearest(name, names.clone()).map(|n| format!("did you mean `{n}`?"));
        let what = format!("the gallery has no `{name}`; it has {}", names.collect::<Vec<_>>().join(", "));
        return Err(Error::Recipe { at: None, what, hint }.into());
    };
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{name}.toml")));
    if path.exists() {
        let hint = Some("give another name with -o, or remove it first".into());
        return Err(Error::Recipe { at: None, what: format!("{} is already there", path.display()), hint }.into());
    }
    write_whole(&path, recipe.text.as_bytes())?;
    for (name, bytes) in recipe.data {
        let beside = path.with_file_name("").join(name);
        if let Some(folder) = beside.parent() {
            std::fs::create_dir_all(folder).map_err(|e| Error::io("create folder", folder, e))?;
        }
        if !beside.exists() {
            write_whole(&beside, bytes)?;
            say!("wrote {}", beside.display());
        }
    }
    say!("wrote {}; next: landform run {} -o out", path.display(), path.display());
    Ok(ExitCode::SUCCESS)
}
