//! The landform command line: one file a subcommand.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command line speaks")]

/// Prints a line to standard error; a run goes on when that is closed.
macro_rules! complain {
    ($($arg:tt)*) => {{
        use std::io::Write;
        writeln!(std::io::stderr(), $($arg)*).ok();
    }};
}

/// Prints a line; ends quietly when the output is closed (`landform stages | head`), with an error
/// when it cannot be written.
macro_rules! say {
    ($($arg:tt)*) => {{
        use std::io::Write;
        if !crate::how::is_quiet()
            && let Err(e) = writeln!(std::io::stdout(), $($arg)*) {
            if e.kind() == std::io::ErrorKind::BrokenPipe {
                std::process::exit(0);
            }
            complain!("error: cannot write to standard output: {e}");
            std::process::exit(1);
        }
    }};
}

mod analyze;
mod cache;
mod check;
mod cite;
mod compare;
mod completions;
mod convert;
mod fit;
mod ground;
mod how;
mod man;
mod new;
mod part;
mod progress;
mod render;
mod run;
mod schema;
mod show_error;
mod stages;
#[cfg(feature = "studio")]
mod studio;
mod vary;

use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};
use how::Work;

/// Grows landscapes from natural processes.
#[derive(Parser)]
#[command(
    name = "landform",
    version = concat!(env!("CARGO_PKG_VERSION"), " (", env!("LANDFORM_BUILD"), ")"),
    about,
    after_help = "Begin with: landform new alpine_range; landform run alpine_range.toml -o out"
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Writes a recipe from the gallery to start from.
    New(new::Args),
    /// Validates a recipe and prints its plan: stages, sizes, memory, what is cached.
    Check(check::Args),
    /// Runs a recipe.
    Run(run::Args),
    /// Runs a recipe for many seeds and values of keys: a contact sheet and a table of results.
    Vary(vary::Args),
    /// Finds values of keys with which a number of a recipe's end comes to a target, or is least or
    /// greatest. Prints a table of all runs and the best values as arguments of `landform run`.
    ///
    /// One key: where values at both ends of the range, or at neighbours of five even places, lie
    /// on both sides of the target, the range is halved again and again; else golden sections close
    /// in on the best. More keys: a simplex moves towards the best (Nelder and Mead). Ranges above
    /// 0 whose ends differ ten times or more are gone through by ratios. Nothing is random: the
    /// same command makes the same runs. Stages before the first key are run once.
    ///
    /// A target is reached within a thousandth of it; if it is 0, of the greatest value met. If it
    /// is not reached, the nearest values are printed, and the command fails.
    Fit(fit::Args),
    /// Lists the stages, or one stage's parameters with units, defaults, ranges, sources.
    Stages(stages::Args),
    /// Prints the JSON schema of recipes, for editors.
    Schema,
    /// Prints the papers behind a recipe.
    Cite(cite::Args),
    /// Measures an elevation file: report card, report, numbers, maps. Also the dimension of coasts
    /// (GeoJSON).
    Analyze(Work<analyze::Args>),
    /// Compares two elevation files: volumes removed and added, and all measures side by side.
    Compare(Work<compare::Args>),
    /// Draws an elevation file.
    Render(Work<render::Args>),
    /// Turns a raster into another raster, or into a mesh.
    Convert(Work<convert::Args>),
    /// Shows or clears the terrains that runs have kept in an output folder.
    Cache(cache::Args),
    /// Opens a studio in the browser: the landscape, in three dimensions, while its recipe changes.
    #[cfg(feature = "studio")]
    Studio(studio::Args),
    /// Prints completions for a shell.
    Completions(completions::Args),
    /// Writes man pages into a folder.
    Man(man::Args),
}

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(usage) => return show_error::show_usage(&usage),
    };
    let result = match cli.command {
        Command::New(args) => new::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Run(args) => run::run(&args),
        Command::Vary(args) => vary::run(&args),
        Command::Fit(args) => fit::run(&args),
        Command::Stages(args) => stages::run(&args),
        Command::Schema => schema::run(),
        Command::Cite(args) => cite::run(&args),
        Command::Analyze(work) => work.run(analyze::run),
        Command::Compare(work) => work.run(compare::run),
        Command::Render(work) => work.run(render::run),
        Command::Convert(work) => work.run(convert::run),
        Command::Cache(args) => cache::run(&args),
        #[cfg(feature = "studio")]
        Command::Studio(args) => studio::run(&args),
        Command::Completions(args) => completions::run(&args, Cli::command()),
        Command::Man(args) => man::run(&args, Cli::command()),
    };
    result.unwrap_or_else(|failure| {
        show_error::show(&failure);
        ExitCode::FAILURE
    })
}
