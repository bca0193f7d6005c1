//! Statistics beside those of natural networks.

use serde::Serialize;

use super::NetworkStatistics;

/// A measure beside its range on natural networks.
///
/// ```
/// use landform_core::analysis::network_statistics;
///
/// let ends = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [-8.0, -6.0, 0.0]];
/// let star = network_statistics(&ends, &[[0, 1], [0, 2], [0, 3]]);
/// let beside = &star.natural_ranges[0];
/// assert_eq!((beside.measure, beside.natural), ("tortuosity", [1.12, 1.54]));
/// assert!(!beside.in_range, "its branches are straight");
/// ```
#[derive(Clone, Debug, Serialize)]
pub struct NaturalRange {
    /// Name of the measure.
    pub measure: &'static str,
    /// Its value; a ratio.
    pub value: f64,
    /// Least and greatest ratio on 34 natural networks (31 for lengths), a little widened.
    pub natural: [f64; 2],
    /// Whether the value lies between them.
    pub in_range: bool,
}

/// Pattern of a network.
///
/// ```
/// use landform_core::analysis::{Pattern, network_statistics};
///
/// // A passage with twenty tributaries.
/// let places: Vec<[f64; 3]> = (0..40).map(|k| [f64::from(k / 2 * 10), f64::from(k % 2 * 7), 0.0]).collect();
/// let legs: Vec<[u32; 2]> = (0..20).map(|k| [2 * k, 2 * k + 1]).chain((1..20).map(|k| [2 * k - 2, 2 * k])).collect();
/// assert_eq!(network_statistics(&places, &legs).pattern, Pattern::Branchwork);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Pattern {
    /// A tree of tributaries: complexity below 0.1.
    Branchwork,
    /// A tree with loops: 0.1 to 0.35.
    Mixed,
    /// Loops within loops: above 0.35.
    Maze,
}

/// Ranges of the corrected table of 34 networks: Collon et al. (2017, 2021).
fn ranges(s: &NetworkStatistics) -> [(&'static str, f64, [f64; 2]); 8] {
    [
        ("tortuosity", s.tortuosity, [1.12, 1.54]),
        ("mean_degree", s.mean_degree, [1.9, 2.6]),
        ("degree_variation", s.degree_variation, [0.35, 0.62]),
        ("degree_correlation", s.degree_correlation, [-0.56, -0.1]),
        ("central_point_dominance", s.central_point_dominance, [0.15, 0.6]),
        ("length_entropy", s.length_entropy, [0.1, 0.7]),
        ("orientation_entropy", s.orientation_entropy, [0.75, 1.0]),
        ("length_variation", s.length_variation, [0.8, 2.6]),
    ]
}

/// Fills in the verdict.
pub(super) fn judge(s: &mut NetworkStatistics) {
    let gate = |(measure, value, natural): (&'static str, f64, [f64; 2])| NaturalRange {
        measure,
        value,
        natural,
        in_range: (natural[0]..=natural[1]).contains(&value),
    };
    s.natural_ranges = ranges(s).map(gate).into();
    s.in_range = s.natural_ranges.iter().filter(|g| g.in_range).count();
    s.pattern = match s.complexity {
        c if c < 0.1 => Pattern::Branchwork,
        c if c < 0.35 => Pattern::Mixed,
        _ => Pattern::Maze,
    };
    let outside: Vec<&str> = s.natural_ranges.iter().filter(|g| !g.in_range).map(|g| g.measure).collect();
    s.verdict = match outside.as_slice() {
        [] => "as natural karst networks are".into(),
        names => format!("unlike natural karst networks in {}", names.join(", ")),
    };
}
