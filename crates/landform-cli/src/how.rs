//! How commands on files work: with how many threads, and how much they say.

use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

use landform::core::parallel::with_threads;

use crate::show_error::Failure;

static QUIET: AtomicBool = AtomicBool::new(false);

/// Whether errors alone are printed.
pub(crate) fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// A command with the options that those on files share.
#[derive(clap::Args)]
pub(crate) struct Work<A: clap::Args> {
    #[command(flatten)]
    args: A,
    /// Number of threads; all cores if not given. Results do not depend on it.
    #[arg(long, default_value_t = 0)]
    threads: usize,
    /// Prints errors only.
    #[arg(short, long)]
    quiet: bool,
}

impl<A: clap::Args + Sync> Work<A> {
    pub(crate) fn run(&self, command: fn(&A) -> Result<ExitCode, Failure>) -> Result<ExitCode, Failure> {
        QUIET.store(self.quiet, Ordering::Relaxed);
        with_threads(self.threads, || command(&self.args))?
    }
}
