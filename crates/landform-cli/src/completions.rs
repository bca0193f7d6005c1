//! `landform completions`.

use std::io::Write;
use std::process::ExitCode;

use clap_complete::Shell;

use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Shell for which completions are printed.
    shell: Shell,
}

pub(crate) fn run(args: &Args, mut command: clap::Command) -> Result<ExitCode, Failure> {
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut command, "landform", &mut text);
    // The last line may wait for its end.
    let mut stdout = std::io::stdout();
    match stdout.write_all(&text).and_then(|()| stdout.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            complain!("error: cannot write to standard output: {e}");
            Ok(ExitCode::FAILURE)
        }
        _ => Ok(ExitCode::SUCCESS),
    }
}
