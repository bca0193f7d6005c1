//! One error type, with hints.
//!
//! Messages are lower case, without full stop, give the value found and the value expected;
//! [`Error::hint`] adds the remedy where one is known.

use std::fmt;
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
    /// A number lies outside the range that its parameter is declared with.
    #[error("parameter `{name}` is {text}; expected {range}")]
    OutOfRange {
        /// Name as typed in a recipe; of a table within a table a path, "grid.cell_size".
        name: String,
        /// The number found, in the unit of the range.
        value: f64,
        /// The number as it was typed, with its unit.
        text: String,
        /// The range.
        range: Box<Range>,
    },
    /// A parameter that varies from node to node has a value that is not allowed.
    #[error("parameter `{name}` is {value} at node {node}; expected {expected} everywhere")]
    AtNode {
        /// Name as typed in a recipe.
        name: String,
        /// The first node with such a value.
        node: usize,
        /// The value, SI; NaN where there is none.
        value: f64,
        /// Values that are accepted.
        expected: &'static str,
    },
    /// A parameter means nothing without another.
    #[error("parameter `{name}` is given alone; expected together with {needs}")]
    Incomplete {
        /// Name as typed in a recipe.
        name: String,
        /// The parameter that it goes with.
        needs: &'static str,
    },
    /// A file's name does not end as that of a format at hand.
    #[error("parameter `{name}` is \"{path}\"; expected a name that ends with {}", endings(.extensions, .near.as_deref()))]
    Extension {
        /// Name of the parameter that gives the path.
        name: String,
        /// The path.
        path: String,
        /// Endings of the formats at hand, lower case, without dot.
        extensions: Vec<&'static str>,
        /// The ending that was probably meant.
        near: Option<String>,
    },
    /// A path leads out of the folder that files are put in.
    #[error("parameter `{name}` is \"{path}\"{}; expected a file name, below the output folder", link(*.by_link))]
    Outside {
        /// Name of the parameter that gives the path.
        name: String,
        /// The path.
        path: String,
        /// Whether it does so over a link.
        by_link: bool,
    },
    /// Coordinates of a file are degrees, where slopes need metres.
    #[error("parameter `path` is \"{path}\", which is in degrees of longitude and latitude; expected metres")]
    InDegrees {
        /// The file.
        path: String,
        /// Whether `degrees_to_metres` converts it.
        convertible: bool,
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
    /// A value that was set beside a recipe is wrong; the recipe alone is not.
    #[error("`--set {text}`: {source}")]
    Override {
        /// What was set, "uplift.rate=1 mm/yr".
        text: String,
        /// What is wrong with it.
        source: Box<Error>,
    },
    /// Several things are wrong.
    #[error("{}", all_of(.0))]
    Several(Vec<Error>),
    /// A stage of a recipe failed.
    #[error("stage {index} (`{name}`{}): {source}", line.map_or(String::new(), |line| format!(", line {line}")))]
    Stage {
        /// Position in the recipe, from 1.
        index: usize,
        /// Line of the recipe, from 1, where it is known.
        line: Option<usize>,
        /// The stage's label or name.
        name: String,
        /// What went wrong.
        source: Box<Error>,
    },
}

/// The range of a parameter, in its customary unit.
///
/// ```
/// use landform_core::error::Range;
///
/// let depth = Range { least: Some(0.0), unit: "m".into(), ..Range::default() };
/// assert_eq!(depth.to_string(), "at least 0 m");
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Range {
    /// The number lies above this.
    pub above: Option<f64>,
    /// The number is at least this.
    pub least: Option<f64>,
    /// The number is at most this.
    pub most: Option<f64>,
    /// The unit; empty for none.
    pub unit: String,
}

impl Range {
    /// Whether a number lies in it; bounds that are rounded by a billionth count as met.
    ///
    /// ```
    /// use landform_core::error::Range;
    ///
    /// let part = Range { above: Some(0.0), most: Some(1.0), ..Range::default() };
    /// assert!(part.contains(1.0) && !part.contains(0.0));
    /// assert_eq!(part.to_string(), "> 0 and at most 1");
    /// assert!(Range { least: Some(-60.0), most: Some(-5.0), ..Range::default() }.contains(-60.0));
    /// ```
    pub fn contains(&self, number: f64) -> bool {
        let slack = |b: f64| 1e-9 * b.abs();
        self.above.is_none_or(|b| number > b)
            && self.least.is_none_or(|b| number >= b - slack(b))
            && self.most.is_none_or(|b| number <= b + slack(b))
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        let bounds = [(">", self.above), ("at least", self.least), ("at most", self.most)];
        let parts = bounds.into_iter().filter_map(|(word, bound)| Some(format!("{word} {}{unit}", bound?)));
        f.write_str(&parts.collect::<Vec<_>>().join(" and "))
    }
}

/// Endings in words.
fn endings(extensions: &[&str], near: Option<&str>) -> String {
    let near = near.map(|near| format!(" (.{near}?)")).unwrap_or_default();
    let one_of = if extensions.len() > 3 { "one of " } else { "" };
    format!("{one_of}.{}{near}", extensions.join(", ."))
}

fn link(by_link: bool) -> &'static str {
    if by_link { ", which a link leads out of the output folder" } else { "" }
}

/// `Result` with landform's [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// A wrong parameter.
    pub fn parameter(name: &str, value: impl ToString, expected: &str) -> Self {
        Self::Parameter { name: name.into(), value: value.to_string(), expected: expected.into() }
    }

    /// A file's name that ends otherwise than with one of `extensions`.
    ///
    /// ```
    /// use landform_core::Error;
    ///
    /// let error = Error::extension("path", "relief.jpg", &["png"]);
    /// assert_eq!(error.parameter_name(), Some("path"));
    /// assert!(error.to_string().ends_with("expected a name that ends with .png (.png?)"));
    /// ```
    pub fn extension(name: &str, path: &str, extensions: &[&'static str]) -> Self {
        let own = path.rsplit_once('.').map_or("", |(_, end)| end);
        let near = nearest(own, extensions.iter().copied()).map(str::to_string);
        Self::Extension { name: name.into(), path: path.into(), extensions: extensions.to_vec(), near }
    }

    /// The parameter that is wrong, where the error is that of one.
    ///
    /// ```
    /// use landform_core::Error;
    ///
    /// assert_eq!(Error::parameter("seed", -1, "at least 0").parameter_name(), Some("seed"));
    /// assert_eq!(Error::Interrupted.parameter_name(), None);
    /// ```
    pub fn parameter_name(&self) -> Option<&str> {
        match self {
            Self::Parameter { name, .. }
            | Self::OutOfRange { name, .. }
            | Self::AtNode { name, .. }
            | Self::Incomplete { name, .. }
            | Self::Extension { name, .. }
            | Self::Outside { name, .. } => Some(name),
            Self::InDegrees { .. } => Some("path"),
            _ => None,
        }
    }

    /// Several errors as one; the only one as itself.
    ///
    /// ```
    /// use landform_core::Error;
    ///
    /// let seed = || Error::parameter("seed", -1, "at least 0");
    /// assert_eq!(Error::several(vec![seed()]).parameter_name(), Some("seed"));
    /// assert_eq!(Error::several(vec![seed(), seed()]).to_string().lines().count(), 2);
    /// ```
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
            Self::Stage { source, .. } | Self::Override { source, .. } => source.hint(),
            Self::Recipe { hint, .. } | Self::Format { hint, .. } => hint.clone(),
            Self::MissingField { name, available, .. } => {
                Some(match nearest(name, available.iter().map(String::as_str)) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None if available.is_empty() => "the landscape has no fields besides its elevation".into(),
                    None => format!("the landscape has {}", available.join(", ")),
                })
            }
            Self::InDegrees { convertible: true, .. } => {
                Some("set degrees_to_metres = true, or warp it to UTM first".into())
            }
            Self::InDegrees { .. } => Some("warp it to UTM first".into()),
            Self::Outside { by_link: true, .. } => Some("allow it with --allow-outside, or give another path".into()),
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
