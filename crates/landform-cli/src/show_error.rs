//! Errors as people read them: what, where, and a hint.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use landform::core::Error;

/// An error, and the recipe that it is about.
pub(crate) struct Failure {
    error: Error,
    recipe: Option<PathBuf>,
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self { error, recipe: None }
    }
}

/// The error as one about a recipe.
pub(crate) fn about(recipe: &Path) -> impl Fn(Error) -> Failure {
    move |error| Failure { error, recipe: Some(recipe.into()) }
}

pub(crate) fn show(failure: &Failure) {
    match &failure.error {
        Error::Several(errors) => errors.iter().for_each(|error| show_one(error, failure.recipe.as_deref())),
        error => show_one(error, failure.recipe.as_deref()),
    }
}

/// Prints help, a version, or what is wrong with the arguments.
pub(crate) fn show_usage(usage: &clap::Error) -> ExitCode {
    match usage.print() {
        Err(e) if !usage.use_stderr() && e.kind() != std::io::ErrorKind::BrokenPipe => {
            complain!("error: cannot write to standard output: {e}");
            ExitCode::FAILURE
        }
        _ => ExitCode::from(u8::try_from(usage.exit_code()).unwrap_or(2)),
    }
}

fn show_one(error: &Error, recipe: Option<&Path>) {
    let place = match (error, recipe) {
        (Error::Recipe { at: Some((line, column)), .. }, Some(path)) => {
            format!(" at {}:{line}:{column}", path.display())
        }
        (Error::Recipe { at: None, .. }, Some(path)) => format!(" in {}", path.display()),
        _ => String::new(),
    };
    complain!("error: {error}");
    if let (Error::Recipe { at: Some((line, column)), .. }, Some(path)) = (error, recipe) {
        complain!("  -->{place}");
        show_line(path, *line, *column);
    } else if !place.is_empty() {
        complain!("  -->{place}");
    }
    if let Some(hint) = error.hint() {
        complain!("hint: {hint}");
    }
}

fn show_line(path: &Path, line: usize, column: usize) {
    let Ok(text) = std::fs::read_to_string(path) else { return };
    let Some(source) = text.lines().nth(line - 1) else { return };
    let shown: String = source.chars().take(160).collect::<String>().replace('\t', " ");
    let gutter = " ".repeat(line.to_string().len());
    complain!("{gutter} |\n{line} | {shown}\n{gutter} | {}^", " ".repeat(column.saturating_sub(1).min(160)));
}
