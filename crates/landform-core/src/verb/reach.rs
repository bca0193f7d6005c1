//! How far a stage looks.

/// How far around a place the ground can matter to what a stage does there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// The place alone.
    Point,
    /// So many cells around it.
    Cells(u64),
    /// So far around it, m.
    Distance(f64),
    /// All of the ground.
    Whole,
}

impl std::fmt::Display for Reach {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Point => f.write_str("the place alone"),
            Self::Cells(1) => f.write_str("1 cell"),
            Self::Cells(n) => write!(f, "{n} cells"),
            Self::Distance(d) => write!(f, "{d} m"),
            Self::Whole => f.write_str("the whole ground"),
        }
    }
}
