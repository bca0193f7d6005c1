//! One error type, with hints.
//!
//! Messages are lower case, without full stop, give the value found and the value expected; [`Error::hint`] adds the remedy where
//! one is known.

use std::path::PathBuf;

/// Anything that can go wrong short of a bug in landform.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A parameter has a value that is not allowed.
    #[error("parameter `{name}` is {value}; expected {expected}")]
    Parameter {
        /// Name as typed in a recipe.
        name: String,
        /// The value found.
        value: String,
        /// Values that are accepted.
        expected: String,
    },
    /// A text could not be read as a quantity.
    #[error("`{text}` is not {expected}: {why}")]
    Quantity {
        /// The text.
        text: String,
        /// What was expected, with an example.
        expected: String,
        /// What is wrong.
        why: String,
    },
    /// A formula could not be read.
    #[error("formula `{formula}`, character {at}: {why}")]
    Formula {
        /// The formula.
        formula: String,
        /// Position, in characters from 1.
        at: usize,
        /// What is wrong.
        why: String,
    },
    /// Two things that must have the same shape differ.
    #[error("{what} has {found}; expected {expected}")]
    Shape {
        /// What has the wrong shape.
        what: String,
        /// Shape found.
        found: String,
        /// Shape expected.
        expected: String,
    },
    /// A field is not there.
    #[error("field `{name}` is missing; {needed_by} needs it")]
    MissingField {
        /// Name of the field.
        name: String,
        /// Stage or function that needs it.
        needed_by: String,
        /// Fields that are there.
        available: Vec<String>,
    },
    /// An operation does not exist for this kind of terrain.
    #[error("{what} does not work on a {on}; it works on {supports}")]
    Unsupported {
        /// The operation.
        what: String,
        /// The kind of terrain at hand.
        on: String,
        /// Kinds that it works on.
        supports: String,
    },
    /// An iteration did not converge.
    #[error("{what} did not converge in {iterations} iterations (residual {residual:.3e})")]
    NotConverged {
        /// What was solved.
        what: String,
        /// Iterations spent.
        iterations: usize,
        /// Residual reached.
        residual: f64,
    },
    /// The run was asked to stop.
    #[error("interrupted")]
    Interrupted,
    /// A number became NaN or infinite.
    #[error("{field} is not finite at node {node} after {after}")]
    NonFinite {
        /// Field that holds the number.
        field: String,
        /// Index of the node.
        node: usize,
        /// Process that wrote it.
        after: String,
    },
    /// Every node is nodata.
    #[error("{what} has no valid data: every cell is nodata")]
    Empty {
        /// What is empty.
        what: String,
    },
    /// A surface has no face.
    #[error("{what} is nowhere two nodes wide: a mesh of it has no face")]
    NoFace {
        /// What it is a surface of.
        what: &'static str,
    },
    /// A file's content is not valid.
    #[error("not a readable {format} file: {what}")]
    Format {
        /// Name of the format.
        format: &'static str,
        /// What is wrong.
        what: String,
        /// What to do about it.
        hint: Option<String>,
    },
    /// The operating system refused an operation.
    #[error("cannot {action} {}: {source}", path.display())]
    Io {
        /// "read", "write", ...
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// More memory is needed than is available.
    #[error("{what} needs about {} and {} is free", bytes_text(*needed), bytes_text(*available))]
    Memory {
        /// Operation that needs it.
        what: String,
        /// Bytes needed.
        needed: u64,
        /// Bytes available.
        available: u64,
    },
    /// A recipe is wrong.
    #[error("{what}")]
    Recipe {
        /// Line and column from 1, if known.
        at: Option<(usize, usize)>,
        /// What is wrong.
        what: String,
        /// What to do about it.
        hint: Option<String>,
    },
    /// Several things are wrong.
    #[error("{}", all_of(.0))]
    Several(Vec<Error>),
    /// A stage of a recipe failed.
    #[error("stage {index} (`{name}`): {source}")]
    Stage {
        /// Position in the recipe, from 1.
        index: usize,
        /// The stage's label or name.
        name: String,
        /// What went wrong.
        source: Box<Error>,
    },
}

/// `Result` with landform's [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// A wrong parameter.
    pub fn parameter(name: &str, value: impl ToString, expected: &str) -> Self {
        Self::Parameter { name: name.into(), value: value.to_string(), expected: expected.into() }
    }

    /// Several errors as one; the only one as itself.
    pub fn several(errors: Vec<Self>) -> Self {
        match <[Self; 1]>::try_from(errors) {
            Ok([only]) => only,
            Err(errors) => Self::Several(errors),
        }
    }

    /// A broken file.
    pub fn format(format: &'static str, what: impl ToString) -> Self {
        Self::Format { format, what: what.to_string(), hint: None }
    }

    /// An error of the operating system.
    pub fn io(action: &'static str, path: impl Into<PathBuf>, source: std::io::Error) -> Self {
        Self::Io { action, path: path.into(), source }
    }

    /// The remedy, where it is known.
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Stage { source, .. } => source.hint(),
            Self::Recipe { hint, .. } | Self::Format { hint, .. } => hint.clone(),
            Self::MissingField { name, available, .. } => {
                Some(match nearest(name, available.iter().map(String::as_str)) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None if available.is_empty() => "the landscape has no fields besides its elevation".into(),
                    None => format!("the landscape has {}", available.join(", ")),
                })
            }
            Self::NonFinite { .. } => Some("a rate is too great for the time step; try a smaller `clock.dt`".into()),
            Self::NotConverged { .. } => Some("try a smaller `clock.dt`".into()),
            Self::Empty { .. } => Some("check the file's nodata value".into()),
            Self::NoFace { .. } => {
                Some("a mesh needs two rows and two columns with data side by side; a raster keeps single ones".into())
            }
            Self::Memory { .. } => Some("ask for fewer nodes or larger cells, or go on regardless with --force".into()),
            Self::Io { source, action, .. } => match (source.kind(), *action) {
                (std::io::ErrorKind::NotFound, "read") => {
                    Some("is the path right? in a recipe it is relative to the recipe's folder".into())
                }
                (std::io::ErrorKind::AlreadyExists | std::io::ErrorKind::NotADirectory, "create folder") => {
                    Some("a file has that name; results go into a folder: choose another one".into())
                }
                (std::io::ErrorKind::StorageFull, _) => Some("the disk is full; nothing half-written was left".into()),
                (std::io::ErrorKind::PermissionDenied, _) => Some("choose another folder with -o".into()),
                _ => None,
            },
            _ => None,
        }
    }
}

/// Errors, one a line.
fn all_of(errors: &[Error]) -> String {
    let line = |error: &Error| match error {
        Error::Recipe { at: Some((line, _)), .. } => format!("line {line}: {error}"),
        error => error.to_string(),
    };
    errors.iter().map(line).collect::<Vec<_>>().join("\n")
}

/// The candidate nearest to `word` in edits, if one is near enough to be meant.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (word.chars().count() / 3).max(1) + 1;
    candidates
        .into_iter()
        .map(|c| (edit_distance(&word.to_lowercase(), &c.to_lowercase()), c))
        .filter(|&(d, c)| d <= limit || (word.len() > 3 && c.contains(word)))
        .min_by_key(|&(d, _)| d)
        .map(|(_, c)| c)
}

fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, ca) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, cb) in b.iter().enumerate() {
            let substitute = diagonal + usize::from(ca != *cb);
            diagonal = row[j + 1];
            row[j + 1] = substitute.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

/// Bytes as people read them: "1.5 GiB".
pub fn bytes_text(bytes: u64) -> String {
    let mut value = bytes as f64;
    for unit in ["B", "KiB", "MiB", "GiB"] {
        if value < 1024.0 {
            return if unit == "B" { format!("{bytes} B") } else { format!("{value:.1} {unit}") };
        }
        value /= 1024.0;
    }
    format!("{value:.1} TiB")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_finds_a_misspelt_word_and_leaves_a_strange_one() {
        let names = ["diffusivity", "erodibility", "talus_angle"];
        assert_eq!(nearest("difusivity", names), Some("diffusivity"));
        assert_eq!(nearest("erodability", names), Some("erodibility"));
        assert_eq!(nearest("colour", names), None);
    }

    #[test]
    fn bytes_are_written_as_people_read_them() {
        assert_eq!(bytes_text(12), "12 B");
        assert_eq!(bytes_text(3 << 29), "1.5 GiB");
    }
}
