//! `landform vary`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use landform::core::parallel::with_threads;
use landform::core::verb::CancelToken;
use landform::core::{Error, Result};
use landform::io::export::{ViewKind, WritePicture};
use landform::io::files::write_whole;
use landform::io::format::encode_png;
use landform::io::memory;
use landform::recipe::{Axis, Recipe, Sweep, contact_sheet};

use crate::how::How;
use crate::show_error::{Failure, about};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// The recipe.
    recipe: PathBuf,
    /// Number of seeds, counted upwards from the recipe's own (or from --seed).
    #[arg(short, long, default_value_t = 1)]
    n: u64,
    /// First seed, instead of the recipe's.
    #[arg(long)]
    seed: Option<u64>,
    /// A key and its values: LABEL_OR_STAGE.key=a,b,c (or a;b;c), or a range: a..b:n, a..b:nlog.
    /// May be repeated: every combination is run.
    #[arg(long, value_name = "STAGE.KEY=A,B,C")]
    over: Vec<String>,
    /// Table of results to write (.csv); printed if not given.
    #[arg(long)]
    table: Option<PathBuf>,
    /// Contact sheet to write (.png), numbered as the table's rows.
    #[arg(long)]
    sheet: Option<PathBuf>,
    /// View of each picture of the sheet.
    #[arg(long, default_value = "map")]
    view: String,
    /// Length of the longer side of each picture, pixels.
    #[arg(long, default_value_t = 320)]
    size: usize,
    #[command(flatten)]
    how: How,
}

/// Sheets with more pixels than this are refused.
const MOST_PIXELS: usize = 400_000_000;

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let over = args.over.iter().map(|o| Axis::parse(o)).collect::<Result<Vec<_>>>()?;
    let load = |overrides: &[landform::recipe::Override]| Recipe::load(&args.recipe, overrides);
    let own = load(&[]).map_err(about(&args.recipe))?.seed;
    let first = args.seed.unwrap_or(own);
    if !(1..=10_000).contains(&args.n) {
        return Err(Error::parameter("n", args.n, "1 to 10,000 seeds").into());
    }
    args.table.as_deref().map(check_table).transpose()?;
    args.sheet.as_deref().map(check_folder).transpose()?;
    let seeds = (0..args.n).map(|k| first.wrapping_add(k)).collect();
    let sweep = Sweep { seeds, over, keep: args.sheet.is_some() };
    let runs = sweep.runs(own)?.len();
    let picture = picture(args)?;
    if args.sheet.is_some() && runs * args.size * args.size > MOST_PIXELS {
        let value = format!("{runs} pictures of {} pixels", args.size);
        return Err(Error::parameter("size", value, "fewer or smaller pictures").into());
    }
    let cancel = cancelled_by_signal();
    let (rows, failure) = with_threads(args.how.threads, || {
        sweep.run(load, memory::available(), &cancel, |k, row| {
            if !args.how.quiet {
                let values = if row.values.is_empty() { String::new() } else { format!(" {}", row.values.join(" ")) };
                complain!(
                    "[{}/{runs}] seed {}{values}: {:.1} to {:.1} m, {:.1} s",
                    k + 1,
                    row.seed,
                    row.summary.min,
                    row.summary.max,
                    row.seconds
                );
            }
        })
    })?
    .map_err(about(&args.recipe))?;
    let table = sweep.table(&rows);
    match &args.table {
        Some(path) => write_whole(path, table.as_bytes())?,
        None => say!("{}", table.trim_end()),
    }
    if let Some(path) = args.sheet.as_ref().filter(|_| !rows.is_empty()) {
        let sheet = contact_sheet(&rows, &picture, 8)?;
        write_whole(path, &encode_png(&sheet.pixels, sheet.shape)?)?;
    }
    match failure {
        None => Ok(ExitCode::SUCCESS),
        Some(Error::Interrupted) => {
            complain!("interrupted: {} of {runs} runs were finished", rows.len());
            Ok(ExitCode::from(130))
        }
        Some(e) => Err(about(&args.recipe)(e)),
    }
}

/// A token that Ctrl-C cancels; a second one ends the program.
pub(crate) fn cancelled_by_signal() -> CancelToken {
    let cancel = CancelToken::default();
    let token = cancel.clone();
    ctrlc::set_handler(move || {
        if token.is_cancelled() {
            std::process::exit(130);
        }
        token.cancel();
    })
    .ok();
    cancel
}

/// Refuses a file in a folder that does not exist, before the runs start.
/// Refuses a path at which no table can be written, or where one would take the place of something
/// else, such as the recipe.
pub(crate) fn check_table(path: &Path) -> Result<()> {
    if path.extension().is_none_or(|end| !end.eq_ignore_ascii_case("csv")) {
        return Err(Error::extension("table", &path.display().to_string(), &["csv"]));
    }
    check_folder(path)
}

fn check_folder(path: &Path) -> Result<()> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    std::fs::metadata(folder).map(drop).map_err(|e| Error::io("write in", folder, e))
}

fn picture(args: &Args) -> Result<WritePicture> {
    let view = match args.view.as_str() {
        "map" => ViewKind::Map,
        "perspective" => ViewKind::Perspective,
        other => return Err(Error::parameter("view", format!("\"{other}\""), "\"map\" or \"perspective\"")),
    };
    let picture = WritePicture { view, size: args.size, ..WritePicture::default() };
    landform::core::verb::Params::validate(&picture)?;
    Ok(picture)
}
