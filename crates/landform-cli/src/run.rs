//! `landform run`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use landform::core::parallel::with_threads;
use landform::core::units::Duration;
use landform::core::verb::CancelToken;
use landform::core::{Error, Result};
use landform::io::files::Folder;
use landform::io::memory;
use landform::recipe::{Cache, Options, Override, Ran, Recipe, Signal};

use crate::cache::Size;
use crate::how::How;
use crate::part::Part;
use crate::progress::{Reporter, Style};
use crate::show_error::{Failure, about};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// The recipe.
    recipe: PathBuf,
    /// Output folder.
    #[arg(short, long, default_value = "out")]
    output: PathBuf,
    /// Seed, instead of the recipe's.
    #[arg(long)]
    seed: Option<u64>,
    /// Sets a key: LABEL_OR_STAGE.key=value. May be repeated.
    #[arg(long = "set", value_name = "STAGE.KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    part: Part,
    #[command(flatten)]
    how: How,
    /// Goes on where an interrupted run stopped.
    #[arg(long)]
    resume: bool,
    /// Wall-clock time between two saves of the state of a running stage, for --resume.
    #[arg(long, value_name = "TIME", default_value = "1 min", value_parser = interval)]
    checkpoint_every: Duration,
    /// Runs even if the memory seems too small.
    #[arg(long)]
    force: bool,
    /// Runs every stage anew, and keeps no terrain in the cache.
    #[arg(long)]
    no_cache: bool,
    /// Greatest size on disk of the terrains of earlier stages; the least recently used are removed
    /// first.
    #[arg(long, value_name = "SIZE", default_value = "4 GiB")]
    cache_limit: Size,
    /// How progress is shown.
    #[arg(long, value_enum, default_value_t = Style::Auto)]
    progress: Style,
    /// Lets stages write outside the output folder: by `..`, absolute paths or links.
    #[arg(long)]
    allow_outside: bool,
}

/// A time such as "30 s" or "10 min".
fn interval(text: &str) -> Result<Duration, String> {
    match Duration::parse(text) {
        Ok(time) if time.si() >= 0.0 => Ok(time),
        Ok(_) => Err("a time cannot be negative; write 30 s or 10 min".into()),
        Err(e) => Err(format!("{e}; write 30 s or 10 min")),
    }
}

/// Text that differs between builds of this program, so that the cache of an older build is not
/// used.
pub(crate) fn salt() -> String {
    let meta = std::env::current_exe().and_then(std::fs::metadata);
    let modified = meta.as_ref().ok().and_then(|m| m.modified().ok());
    let since = modified.and_then(|t| t.duration_since(std::time::UNIX_EPOCH).ok());
    format!("{:?} {:?}", since, meta.map(|m| m.len()).ok())
}

/// Refuses what would write outside of the folder over a link, or over a file that the recipe
/// reads.
fn check_files(recipe: &Recipe, folder: &Folder, args: &Args) -> Result<()> {
    if !args.allow_outside {
        // Nothing is kept beyond a link either.
        let state = args.output.join(".landform");
        if std::fs::symlink_metadata(&state).is_ok_and(|meta| meta.is_symlink()) {
            let what =
                format!("{} is a link, and would keep the run's state outside of the output folder", state.display());
            let hint = Some("remove the link, or allow it with --allow-outside".into());
            return Err(Error::Recipe { at: None, what, hint });
        }
    }
    let inputs: Vec<PathBuf> = recipe.inputs().filter_map(|path| path.canonicalize().ok()).collect();
    for path in recipe.outputs() {
        folder.check(&path)?;
        if args.output.join(&path).canonicalize().is_ok_and(|target| inputs.contains(&target)) {
            return Err(over_input(&path));
        }
    }
    let root = args.output.canonicalize().map_err(|e| Error::io("find", &args.output, e))?;
    let mut inside = inputs.iter().filter_map(|input| input.strip_prefix(&root).ok()?.to_str());
    inside.find(|path| recipe.is_frame(path)).map_or(Ok(()), |path| Err(over_input(path)))
}

fn over_input(path: &str) -> Error {
    let what = format!("`{path}` would be written over a file that the recipe reads");
    Error::Recipe { at: None, what, hint: Some("give it another `path`, or another folder by -o".into()) }
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let start = Instant::now();
    let mut overrides = args.set.iter().map(|s| Override::parse(s)).collect::<Result<Vec<_>>>()?;
    if let Some(seed) = args.seed {
        if i64::try_from(seed).is_err() {
            return Err(Error::parameter("seed", seed, "at most 9223372036854775807, as in recipes").into());
        }
        overrides.push(Override::parse(&format!("seed={seed}"))?);
    }
    let mut recipe = args.part.of(Recipe::load(&args.recipe, &overrides)).map_err(about(&args.recipe))?;
    recipe.allow_outside = args.allow_outside;
    let state = args.output.join(".landform");
    let cache = (!args.no_cache).then(|| Cache::on_disk(&state.join("cache")).with_limit(args.cache_limit.bytes()));
    let salt = salt();
    let plan = recipe.plan(cache.as_ref(), &salt).map_err(about(&args.recipe))?;
    if let Some(available) = memory::available().filter(|a| plan.bytes > *a && !args.force) {
        return Err(Error::Memory { what: "this recipe".into(), needed: plan.bytes, available }.into());
    }
    let mut folder = Folder::create(&args.output)?.may_leave(args.allow_outside);
    check_files(&recipe, &folder, args).map_err(about(&args.recipe))?;
    let cancel = CancelToken::default();
    let token = cancel.clone();
    let stepping = Arc::new(AtomicBool::new(false));
    let in_steps = stepping.clone();
    ctrlc::set_handler(move || {
        // Only processes have a state worth saving; and a second signal does not wait for the step
        // to end.
        if token.is_cancelled() || !in_steps.load(Ordering::Relaxed) {
            complain!("interrupted: run again to go on from the cache");
            std::process::exit(130);
        }
        token.cancel();
    })
    .ok();
    let style = if args.how.quiet { Style::None } else { args.progress };
    let reporter = Reporter::new(style);
    let options = Options {
        cache: cache.as_ref(),
        checkpoint: Some(state.join("checkpoint.lfc")),
        resume: args.resume,
        checkpoint_every: args.checkpoint_every.si(),
        salt,
        cancel,
        progress: &|signal| {
            stepping.store(matches!(signal, Signal::Step { .. }), Ordering::Relaxed);
            reporter.take(signal);
        },
        ..Options::default()
    };
    let ran = with_threads(args.how.threads, || recipe.run(&mut folder, &options))?;
    reporter.finish();
    match ran.map_err(about(&args.recipe))? {
        Ran::ToTheEnd(..) => {
            reporter.files(folder.written(), start.elapsed().as_secs_f64());
            Ok(reporter.told())
        }
        Ran::Interrupted(checkpoint) => {
            let how = match checkpoint {
                Some(path) if path.is_file() => format!("the state is in {}; go on with --resume", path.display()),
                _ => "run again to go on from the cache".into(),
            };
            complain!("interrupted: {how}");
            Ok(ExitCode::from(130))
        }
    }
}
