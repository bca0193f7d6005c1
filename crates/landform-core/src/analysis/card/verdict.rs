//! What a card amounts to, in words.
//!
//! # Method
//! A measure outside its range counts by its distance from it in halves of the range's width, at
//! most [`MOST`]. The sum over the deciding measures tells made ground from [`ENOUGH`] on: a crop
//! of real ground often leaves one range or three by a little, made ground leaves one or two by
//! far. Where there is nothing of what real ground always has some of, such as hollows, that alone
//! is enough.
//!
//! # Sources
//! The bound was chosen on 70 crops of 256² and 512² nodes from the northern halves of six real
//! places, of which 91 % lie below it, and tried on the 53 of the southern halves
//! (docs/real_ground).

use serde::{Deserialize, Serialize};

use super::super::Metrics;
use super::CardLine;

/// The verdict of a card.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// In a few words.
    pub title: String,
    /// Why.
    pub reason: String,
}

/// With fewer nodes there are no statistics.
const LEAST_NODES: usize = 1_000;
/// What a measure counts at most, in halves of its range's width.
const MOST: f64 = 2.0;
/// The sum from which ground is made.
const ENOUGH: f64 = 2.5;

/// (name, what is off below the range, what is off above it, whether it shows a lattice or one
/// slope).
#[rustfmt::skip]
const FAULTS: &[(&str, &str, &str, bool)] = &[
    ("Share of ground in sinks", "no hollow is left, as if they had been filled", "too much ground lies in hollows", false),
    ("Sink asymmetry", "hollows are as common as summits, or commoner", "there are no hollows beside the summits", false),
    ("Peaks per 1000 nodes", "there are too few summits", "there are too many summits", false),
    ("Spectral exponent, short waves", "the finest relief is too rough", "the finest relief is too smooth", false),
    ("Hurst exponent of the finest ground", "the ground is too rough from node to node", "the ground is too smooth from node to node", false),
    ("Skew of the Laplacian", "crests are knives beside their valleys", "valleys are knife cuts beside their crests", false),
    ("R² of slope against area", "rivers do not flatten as they grow", "rivers flatten too exactly as they grow", false),
    ("R² of elevation against chi", "rivers' profiles have nothing in common", "rivers' profiles are too exactly alike", false),
    ("Drainage density at 1 km², 1/km", "there are too few rivers", "there are too many rivers", false),
    ("Peak of the slopes' directions", "", "slopes face a few directions", true),
    ("Slopes along the lattice", "slopes shun the directions of the lattice", "slopes face along the lattice", true),
    ("Eightfold symmetry of slopes", "slopes face between the lattice's eight directions", "slopes face the lattice's eight directions", true),
    ("Channels in straight runs", "", "channels run straight", true),
    ("Reaches along the lattice", "", "channels run along the lattice", true),
    ("Share of planes", "", "hillsides are planes", true),
    ("Share of the commonest slope", "", "one slope is everywhere", true),
    ("Skew of slopes", "most ground stands at the steepest slope", "most ground is level beside a few steep places", true),
    ("Sharpness of hollows over crests", "crests are sharper than valleys", "valleys are trenches", true),
];

/// A measure outside its range.
struct Off<'a> {
    line: &'a CardLine,
    counts: f64,
}

impl Off<'_> {
    fn fault(&self) -> Option<&'static (&'static str, &'static str, &'static str, bool)> {
        FAULTS.iter().find(|f| f.0 == self.line.name)
    }

    /// What is off, with the number.
    fn words(&self) -> String {
        let (value, [low, high]) = (self.line.value, self.line.natural);
        let below = value < low;
        let what = self.fault().map_or(self.line.name.as_str(), |f| if below { f.1 } else { f.2 });
        let bound = if below { format!("at least {}", short(low)) } else { format!("at most {}", short(high)) };
        format!("{what} ({} {}, real ground {bound})", self.line.name.to_lowercase(), short(value))
    }
}

/// Three digits or so.
fn short(v: f64) -> String {
    match v.abs() {
        a if a > 0.0 && a < 1e-3 => format!("{v:e}"),
        a if a < 10.0 => format!("{:?}", (v * 1e3).round() / 1e3),
        _ => format!("{v:.1}"),
    }
}

/// The deciding measures outside their ranges, the farthest first.
fn outside(card: &[CardLine]) -> Vec<Off<'_>> {
    let counts = |line: &CardLine| {
        let (value, [low, high]) = (line.value, line.natural);
        if value == 0.0 && low > 0.0 {
            return ENOUGH;
        }
        ((low - value).max(value - high).max(0.0) / (0.5 * (high - low))).min(MOST)
    };
    let off = card.iter().filter(|l| l.decides && l.inside == Some(false));
    let mut off: Vec<Off> = off.map(|line| Off { line, counts: counts(line) }).collect();
    off.sort_by(|a, b| b.counts.total_cmp(&a.counts));
    off
}

/// The verdict of a landscape's card.
pub fn verdict(metrics: &Metrics, card: &[CardLine]) -> Verdict {
    let say = |title: &str, reason: String| Verdict { title: title.into(), reason };
    let of = card.iter().filter(|l| l.decides && l.inside.is_some()).count();
    let off = outside(card);
    let chi = metrics.network.chi.as_ref().map_or(0.0, |c| c.r2);
    let [dx, dy] = metrics.elevations.spacing;
    let cell = (dx * dy).sqrt();
    if !(5.0..=500.0).contains(&cell) {
        return say(
            "No verdict at this cell size",
            format!(
                "The ranges come from cells of 10 m to 200 m; at {cell:.3} m they say little ({} of {of} deciding measures lie outside).",
                off.len()
            ),
        );
    }
    if of < 4 || metrics.elevations.nodes < LEAST_NODES {
        return say(
            "Too little ground to tell",
            format!("{} nodes with data, {of} deciding measures taken.", metrics.elevations.nodes),
        );
    }
    if metrics.network.slope_area.r2 > 0.99 && chi > 0.99 {
        return say(
            "Too perfect",
            format!(
                "Slope against area (R² {:.4}) and elevation against chi (R² {chi:.4}) follow the law of river erosion better than any real ground: hillslopes, sediment or varied rock are missing.",
                metrics.network.slope_area.r2
            ),
        );
    }
    if off.is_empty() {
        return say(
            "Like natural ground",
            format!(
                "All {of} measures that tell eroded ground from noise and from lattices lie in their natural ranges."
            ),
        );
    }
    let sum: f64 = off.iter().map(|o| o.counts).sum();
    let words = off.iter().map(Off::words).collect::<Vec<_>>().join("; ");
    let reason = |weighed: &str| format!("{} of {of} deciding measures off, {weighed}: {words}.", off.len());
    if sum < ENOUGH {
        let title = if off.len() == 1 { "one thing" } else { "a few things" };
        return say(&format!("Like natural ground, but for {title}"), reason("no farther than on real ground"));
    }
    let lattice: f64 = off.iter().filter(|o| o.fault().is_some_and(|f| f.3)).map(|o| o.counts).sum();
    let no_hollows = off.iter().any(|o| o.line.value == 0.0 && o.line.natural[0] > 0.0);
    let title = match () {
        () if 2.0 * lattice > sum => "Made on a lattice, or with one slope",
        () if no_hollows => "Without a hollow, unlike eroded ground",
        () => "Like noise, not like eroded ground",
    };
    say(title, reason("farther than on real ground"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(name: &str, value: f64, natural: [f64; 2]) -> CardLine {
        CardLine {
            name: name.into(),
            value,
            natural,
            inside: crate::analysis::directions::is_natural(value, natural),
            decides: true,
            meaning: String::new(),
            source: String::new(),
        }
    }

    #[test]
    fn a_measure_counts_by_its_distance_and_no_more_than_two() {
        let card = [line("Skew of slopes", 2.15, [-0.6, 1.6]), line("Channels in straight runs", 0.9, [0.0, 0.21])];
        let off = outside(&card);
        assert_eq!(off[0].line.name, "Channels in straight runs");
        assert_eq!(off[0].counts, MOST);
        assert!((off[1].counts - 0.5).abs() < 1e-12);
        assert!(off[0].words().starts_with("channels run straight ("), "{}", off[0].words());
    }

    #[test]
    fn no_hollow_at_all_is_enough_and_one_node_of_a_crop_is_inside() {
        let natural = [1e-5, 0.12];
        assert_eq!(outside(&[line("Share of ground in sinks", 0.0, natural)])[0].counts, ENOUGH);
        assert!(outside(&[line("Share of ground in sinks", 1.5e-5, natural)]).is_empty());
    }

    #[test]
    fn every_deciding_measure_has_words() {
        let names: Vec<&str> = FAULTS.iter().map(|f| f.0).collect();
        assert!(super::super::ROWS.iter().filter(|r| r.3).all(|r| names.contains(&r.0)));
        assert!(super::super::DIRECTIONS.iter().all(|d| names.contains(&d.1)));
    }
}
