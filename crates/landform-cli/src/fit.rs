//! `landform fit`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::core::parallel::with_threads;
use landform::core::{Error, Result};
use landform::io::files::write_whole;
use landform::io::memory;
use landform::recipe::{Aim, Fit, Override, Recipe, Span};

use crate::how::How;
use crate::show_error::{Failure, about};
use crate::vary::{cancelled_by_signal, check_table};

#[derive(clap::Args)]
#[command(
    after_help = "Example: landform fit r.toml --over \"noise.amplitude=50 m..900 m\" --column median_slope --target 0.3"
)]
#[group(id = "aim", required = true, multiple = false, args = ["column", "least", "most"])]
pub(crate) struct Args {
    /// The recipe.
    recipe: PathBuf,
    /// A key and its range: LABEL_OR_STAGE.key=LO..HI, with a unit where the key has one. May be
    /// repeated, up to four keys.
    #[arg(long, value_name = "STAGE.KEY=LO..HI", required = true)]
    over: Vec<String>,
    /// Column of the table that comes to the target: one of those of `landform vary`, numbers of
    /// the recipe's measures too.
    #[arg(long, value_name = "NAME", requires = "target")]
    column: Option<String>,
    /// Value that the column comes to.
    #[arg(long, value_name = "VALUE", allow_negative_numbers = true, requires = "column")]
    target: Option<f64>,
    /// Column that is as small as possible.
    #[arg(long, value_name = "NAME")]
    least: Option<String>,
    /// Column that is as great as possible.
    #[arg(long, value_name = "NAME")]
    most: Option<String>,
    /// Number of runs, at most.
    #[arg(long, default_value_t = 40)]
    runs: usize,
    /// Seed, instead of the recipe's.
    #[arg(long)]
    seed: Option<u64>,
    /// Table of the runs to write (.csv); printed if not given.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    how: How,
}

impl Args {
    fn fit(&self) -> Result<Fit> {
        let (column, aim) = match (&self.column, self.target, &self.least, &self.most) {
            (Some(column), Some(target), ..) => (column, Aim::Target(target)),
            (.., Some(column), _) => (column, Aim::Least),
            (.., Some(column)) => (column, Aim::Most),
            _ => return Err(Error::parameter("column", "not given", "--column with --target, --least or --most")),
        };
        let over = self.over.iter().map(|text| Span::parse(text)).collect::<Result<_>>()?;
        Ok(Fit { over, column: column.clone(), aim, runs: self.runs, seed: self.seed })
    }
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let fit = args.fit()?;
    let load = |overrides: &[Override]| Recipe::load(&args.recipe, overrides);
    if let Some(path) = &args.output {
        check_table(path)?;
    }
    let cancel = cancelled_by_signal();
    let found = with_threads(args.how.threads, || {
        fit.run(load, memory::available(), &cancel, |k, row, value| {
            if !args.how.quiet {
                let value = value.map_or("unknown".into(), |v| v.to_string());
                complain!("[{}] {}: {} {value}", k + 1, row.values.join(" "), fit.column);
            }
        })
    })?
    .map_err(about(&args.recipe))?;
    match &args.output {
        Some(path) => write_whole(path, found.table.as_bytes())?,
        None => say!("{}", found.table.trim_end()),
    }
    if let Some(line) = &found.set {
        say!("{line}");
    }
    match found.failure {
        None => Ok(ExitCode::SUCCESS),
        Some(Error::Interrupted) => {
            complain!("interrupted after {} runs", found.rows.len());
            Ok(ExitCode::from(130))
        }
        Some(e) => Err(about(&args.recipe)(e)),
    }
}
