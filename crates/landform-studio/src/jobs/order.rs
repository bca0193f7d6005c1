//! What is to be computed.

use landform::recipe::{Level, Recipe};

/// Nodes of the first, coarsest preview are at most as many as of a square of 256, and a little.
const FIRST: u64 = 256 * 256 + 256 * 32;
/// While a value is dragged, at least as many as of a square of 128.
const LEAST: u64 = 128 * 128;

/// A run of a recipe for the eyes.
pub(crate) struct Order {
    pub(crate) recipe: Recipe,
    pub(crate) revision: u64,
    /// Places of the recipe's stages in the list of steps.
    pub(crate) steps: Vec<usize>,
    /// Nodes of a build.
    pub(crate) nodes: u64,
    /// The one level wanted; from coarse to fine if none.
    pub(crate) level: Option<Level>,
    /// Whether a value is being dragged: only the coarsest level is of use.
    pub(crate) dragging: bool,
    /// When the change was made, by the page's clock, and when it came, ms.
    pub(crate) stamp: Option<(f64, f64)>,
    /// The stage whose ground is shown, if not the last.
    pub(crate) shown: Option<usize>,
    /// Whether every step is shown.
    pub(crate) watched: bool,
    /// The stage whose processes, and those after it, go on from where they are.
    pub(crate) goes_on: Option<usize>,
}

impl Order {
    /// Levels to run, in order. `too_slow` says of how many halvings a run takes too long for a
    /// drag.
    pub(crate) fn levels(&self, too_slow: impl Fn(u32) -> bool) -> Vec<Level> {
        if let Some(level) = self.level {
            return vec![level];
        }
        let nodes = |halvings: u32| self.nodes >> (2 * halvings);
        let mut first = (0..=6).find(|&k| nodes(k) <= FIRST).unwrap_or(6);
        if self.dragging {
            while first < 6 && nodes(first + 1) >= LEAST && too_slow(first) {
                first += 1;
            }
            return vec![halved(first)];
        }
        (0..=first).rev().map(halved).collect()
    }
}

/// The level of a number of halvings.
pub(crate) fn halved(halvings: u32) -> Level {
    let name = if halvings == 0 { "1".to_string() } else { format!("1/{}", 1_u32 << halvings) };
    name.parse().unwrap_or_default()
}

/// How often cells are halved from a level to the recipe's own.
pub(crate) fn halvings(level: Level) -> u32 {
    level.factor().trailing_zeros()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(nodes: u64, dragging: bool) -> Order {
        let recipe = Recipe::parse("[[stage]]\nuse = \"flat\"", "x", "".as_ref(), &[]).unwrap();
        let (steps, stamp, shown, watched) = Default::default();
        Order { recipe, revision: 1, steps, nodes, level: None, dragging, stamp, shown, watched, goes_on: None }
    }

    #[test]
    fn previews_go_from_coarse_to_fine() {
        let levels = |nodes, dragging, slow: fn(u32) -> bool| -> Vec<u32> {
            order(nodes, dragging).levels(slow).into_iter().map(|level| level.factor()).collect()
        };
        assert_eq!(levels(1025 * 1025, false, |_| false), [4, 2, 1]);
        assert_eq!(levels(100 * 100, false, |_| true), [1]);
        assert_eq!(levels(1025 * 1025, true, |_| false), [4]);
        assert_eq!(levels(1025 * 1025, true, |_| true), [8]);
        assert_eq!(levels(1 << 50, false, |_| false).len(), 7);
        assert_eq!(halvings(halved(3)), 3);
    }
}
