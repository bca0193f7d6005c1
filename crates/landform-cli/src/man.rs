//! `landform man`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use landform::core::{Error, Result};
use landform::io::files::write_whole;

use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Folder of the pages, such as `man/man1`; it is created if it does not exist.
    folder: PathBuf,
}

pub(crate) fn run(args: &Args, command: clap::Command) -> std::result::Result<ExitCode, Failure> {
    std::fs::create_dir_all(&args.folder).map_err(|e| Error::io("make", &args.folder, e))?;
    let mut pages = 1;
    page(&args.folder, "landform", &command)?;
    for sub in command.get_subcommands().filter(|s| s.get_name() != "help") {
        page(&args.folder, &format!("landform-{}", sub.get_name()), sub)?;
        pages += 1;
    }
    say!("{pages} pages in {}; read one by `man {}/landform.1`", args.folder.display(), args.folder.display());
    Ok(ExitCode::SUCCESS)
}

fn page(folder: &Path, name: &str, command: &clap::Command) -> Result<()> {
    let path = folder.join(format!("{name}.1"));
    let mut text = Vec::new();
    let command = command.clone().name(name.to_string()).version(env!("CARGO_PKG_VERSION"));
    clap_mangen::Man::new(command).render(&mut text).map_err(|e| Error::io("write", &path, e))?;
    write_whole(&path, &text)
}
