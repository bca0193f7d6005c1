//! How commands work: with how many threads, and how much they say.

use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

use landform::core::parallel::with_threads;

use crate::show_error::Failure;

static QUIET: AtomicBool = AtomicBool::new(false);

/// Whether errors alone are printed.
pub(crate) fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Options of all commands that work long.
#[derive(clap::Args)]
pub(crate) struct How {
    /// Number of threads; all cores if not given. Results do not depend on it.
    #[arg(long, default_value_t = 0)]
    pub(crate) threads: usize,
    /// Prints errors only.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// A command on files, with these options.
#[derive(clap::Args)]
pub(crate) struct Work<A: clap::Args> {
    #[command(flatten)]
    args: A,
    #[command(flatten)]
    how: How,
}

impl<A: clap::Args + Sync> Work<A> {
    pub(crate) fn run(&self, command: fn(&A) -> Result<ExitCode, Failure>) -> Result<ExitCode, Failure> {
        QUIET.store(self.how.quiet, Ordering::Relaxed);
        with_threads(self.how.threads, || command(&self.args))?
    }
}
