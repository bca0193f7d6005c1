//! The report card: how natural a landscape's numbers are.
//!
//! # Method
//! Each measure has the range that it takes on real ground. Nine of them distinguish eroded ground
//! from noise, nine show the lattice or the one slope of made ground where it is steep enough
//! ([`Directions`](super::Directions)). A landscape made by the stream-power law alone is
//! recognised by fits that are too good. The verdict adds up how far these measures lie outside;
//! the other lines are for information.
//!
//! # Sources
//! Ranges: least and greatest value over nine real elevation models of 10 m to 200 m cells (18
//! places for the integral, Hack's exponent, β, θ and the spectrum), measured by public tools with
//! these definitions, those of drainage widened by what the tools differ by; the same on synthetic
//! surfaces. docs/real_ground describes each. The sample is small: the ranges are wide and no law.

mod verdict;

use serde::{Deserialize, Serialize};

use super::Metrics;
use super::directions::is_natural;

pub use verdict::{Verdict, verdict};

/// One line of the card.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CardLine {
    /// Name of the measure.
    pub name: String,
    /// Its value; NaN if it could not be measured.
    pub value: f64,
    /// Least and greatest value on real ground.
    pub natural: [f64; 2],
    /// Whether the value lies within; none if it could not be measured.
    pub inside: Option<bool>,
    /// Whether the verdict counts this line.
    pub decides: bool,
    /// What it means, in a sentence.
    pub meaning: String,
    /// Where the range comes from.
    pub source: String,
}

/// Name of the measure of sinks.
const SINKS: &str = "Share of ground in sinks";
/// Sinks are asked for on ground of this many nodes and more.
const SINKS_FROM: usize = 50_000;

/// Numbers of directions that the card shows; R² of slopes and of chi have lines of their own.
#[rustfmt::skip]
const DIRECTIONS: [(&str, &str); 9] = [
    ("aspect_peak", "Peak of the slopes' directions"),
    ("aspect_45", "Slopes along the lattice"),
    ("aspect_r8", "Eightfold symmetry of slopes"),
    ("straight_channels", "Channels in straight runs"),
    ("reach_45", "Reaches along the lattice"),
    ("plane_share", "Share of planes"),
    ("slope_mode", "Share of the commonest slope"),
    ("slope_skew", "Skew of slopes"),
    ("hollow_sharpness", "Sharpness of hollows over crests"),
];

const TEN: &str = "10 real places";
const NINE: &str = "9 real places";
const EIGHTEEN: &str = "18 real places";
const CROPS: &str = "crops of 7 real places";

/// (name, value, range, decides, meaning, source) of every line.
type Row = (&'static str, fn(&Metrics) -> f64, [f64; 2], bool, &'static str, &'static str);

#[rustfmt::skip]
const ROWS: &[Row] = &[
    ("Hypsometric integral", |m| m.hypsometry.integral, [0.08, 0.55], false, "Share of the block between lowest and highest point that is left: high when young, low when worn.", EIGHTEEN),
    ("Skew of the hypsometric curve", |m| m.hypsometry.curve_skew, [0.37, 1.01], false, "How much relief stands on a wide low plain; noise has too little.", NINE),
    (SINKS, |m| m.form.sinks, [1e-5, 0.12], true, "Ground that would be under water if every hollow filled: rivers drain hollows, noise is a fifth to a third hollow. Real ground always has some; filled ground has none.", EIGHTEEN),
    ("Sink asymmetry", |m| m.form.sink_asymmetry, [0.22, 1.0], true, "Hollows upside down against upright: valleys branch and summits do not, noise is alike both ways (0).", EIGHTEEN),
    ("Peaks per 1000 nodes", |m| m.form.peaks, [0.0, 15.0], true, "Local summits: hillslopes leave few, noise and bare stream-power ground have twenty and more.", EIGHTEEN),
    ("Spectral exponent, short waves", |m| m.spectrum.as_ref().map_or(f64::NAN, |s| s.short_waves.exponent), [3.7, 5.4], true, "How fast relief fades towards the finest waves: hillslopes smooth them, noise keeps them.", EIGHTEEN),
    ("Hurst exponent of the finest ground", |m| m.variogram.hurst_near, [0.82, 0.96], true, "Smoothness over 1 to 4 nodes: near 1 on slopes that water and creep have planed.", EIGHTEEN),
    ("Spectral exponent", |m| m.spectrum.as_ref().map_or(f64::NAN, |s| s.surface.exponent), [2.4, 5.1], false, "Falloff of relief with wave number over all waves, 2H + 2 for fractional Brownian ground.", EIGHTEEN),
    ("Hurst exponent by the variogram", |m| m.variogram.hurst, [0.63, 0.90], false, "Growth of height differences with distance over 1 to 32 nodes.", NINE),
    ("Power along axes over diagonals", |m| m.spectrum.as_ref().map_or(f64::NAN, |s| s.axes_over_diagonals), [0.60, 1.62], false, "1 if the grid left no trace; a range that runs one way moves it too.", NINE),
    ("Skew of the Laplacian", |m| m.form.laplacian_skew, [-1.86, 1.11], true, "Below 0 where ridges are sharper than valleys, above where valleys are.", NINE),
    ("Hack's exponent", |m| m.network.scaling.hack_exponent, [0.31, 0.58], false, "Growth of a stream's length with its drainage area: basins grow longer than wide above 0.5.", EIGHTEEN),
    ("Area exceedance exponent", |m| m.network.scaling.area_exponent, [0.44, 0.75], false, "How rare large drainage areas are; this estimate reads 0.045 high.", EIGHTEEN),
    ("Concavity of rivers", |m| m.network.slope_area.concavity, [0.17, 1.7], false, "How fast rivers flatten as they grow; 0.4 to 0.6 in even rock and uplift.", EIGHTEEN),
    ("R² of slope against area", |m| m.network.slope_area.r2, [0.10, 0.98], true, "Above 0.99 no hillslope, sediment or change of rock disturbs the law: too perfect.", NINE),
    ("R² of elevation against chi", |m| m.network.chi.as_ref().map_or(f64::NAN, |c| c.r2), [0.34, 0.95], true, "Above 0.99 every river of the largest basin is in balance: too perfect. A high value alone proves nothing.", NINE),
    ("Bifurcation ratio", |m| m.network.horton.bifurcation, [3.0, 6.0], false, "Streams of one order for each of the next; almost any network has it, random ones too.", "Horton (1945)"),
    ("Drainage density at 1 km², 1/km", |m| m.network.drainage_density.unwrap_or(f64::NAN), [0.34, 0.85], true, "Length of channels that drain 1 km² or more; less on small maps, whose rivers come in from outside.", CROPS),
    ("Share of slopes at repose", |m| m.surface.as_ref().map_or(f64::NAN, |s| s.talus_share), [0.0, 0.16], false, "Ground within 10 % of 33 degrees: scree and slip faces.", NINE),
];

/// The card of a landscape.
pub fn report_card(metrics: &Metrics) -> Vec<CardLine> {
    let mut lines = rows(metrics);
    let directions = &metrics.directions;
    for gate in &directions.gates {
        if let Some(&(_, name)) = DIRECTIONS.iter().find(|d| d.0 == gate.name) {
            lines.push(CardLine {
                name: name.into(),
                value: gate.value.unwrap_or(f64::NAN),
                natural: gate.natural,
                inside: gate.inside.filter(|_| directions.ranges_hold),
                decides: directions.ranges_hold,
                meaning: gate.meaning.clone(),
                source: TEN.into(),
            });
        }
    }
    lines
}

fn rows(metrics: &Metrics) -> Vec<CardLine> {
    ROWS.iter()
        .map(|&(name, value, natural, decides, meaning, source)| {
            let value = value(metrics);
            let few = name == SINKS && metrics.elevations.nodes < SINKS_FROM;
            let natural = if few { [0.0, natural[1]] } else { natural };
            let inside = is_natural(value, natural);
            CardLine {
                name: name.into(),
                value,
                natural,
                inside,
                decides,
                meaning: meaning.into(),
                source: source.into(),
            }
        })
        .collect()
}
