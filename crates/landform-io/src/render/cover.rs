//! Cover of the ground: sand, snow, coral, and beds of rock.

use landform_core::feature::{Feature, FeatureKind, Geometry, near};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::{math, parallel};

use super::colour::{Rgb, hex, mix};

/// Sand, snow, coral and bedded rock of a raster, as pictures show them.
#[derive(Clone, Debug, Default)]
pub(super) struct Cover {
    sand: Vec<f64>,
    snow: Vec<f64>,
    coral: Vec<f64>,
    /// Colour of the rock and how much of it shows through what lies on it, where rock is bedded.
    rock: Vec<(u32, f64)>,
    /// Colour and share of roads and of objects that stand on the ground; empty where there are
    /// none.
    laid: Vec<(Rgb, f64)>,
    cell: f64,
}

pub(crate) const SAND: u32 = 0xd9b482;
const GRAVEL: u32 = 0x9c8567;
const SNOW: u32 = 0xe9edf3;
const CORAL: u32 = 0xdcd2c2;
/// Depth of coral that hides the ground, m.
const REEF: f64 = 1.0;
/// Depth of water over which a reef under it fades from sight, m.
const SEEN: f64 = 4.0;
/// A reef at low water, as a map shows it.
const SHOAL: u32 = 0xcfeadf;
/// Depth of soil that hides rock, m.
const HIDES: f64 = 0.6;

/// The colour of a material; one that is not known has a colour of its own by its name.
fn colour_of(name: &str) -> u32 {
    const KNOWN: &[(&str, u32)] = &[
        ("rock", 0x9b8f82),
        ("soil", 0x6e5a42),
        ("sand", SAND),
        ("gravel", GRAVEL),
        ("sediment", 0xb59a72),
        ("snow", SNOW),
        ("sandstone", 0xc48a5a),
        ("shale", 0x8b8a80),
        ("limestone", 0xd6cfba),
        ("granite", 0xb3a9a2),
        ("basalt", 0x56545a),
        ("clay", 0xa5745a),
        ("coral", CORAL),
        ("chalk", 0xe6e2d6),
        ("dolomite", 0xc9c0aa),
        ("marble", 0xd8d5d0),
        ("gneiss", 0xa89b93),
        ("quartzite", 0xcdb394),
        ("schist", 0x7f877c),
        ("slate", 0x666d77),
        ("conglomerate", 0xa98a6b),
        ("tuff", 0xbfae94),
    ];
    const OTHERS: [u32; 6] = [0xb98f6f, 0x8e8577, 0xc2b59a, 0x77736f, 0xa4836a, 0x9aa08f];
    let by_name =
        || OTHERS[name.bytes().fold(7, |sum: usize, byte| (31 * sum + usize::from(byte)) % 9973) % OTHERS.len()];
    KNOWN.iter().find(|known| known.0 == name).map_or_else(by_name, |known| known.1)
}

/// The colour of bedded ground on a cut, `t` of the way from one node to another, at an elevation
/// (m); none where ground has no beds. Beds run straight from node to node.
pub(super) fn cut(field: &HeightField, [from, to]: [usize; 2], t: f64, elevation: f64) -> Option<Rgb> {
    let layers = field.layers()?;
    let rise = t * (layers.datum(to)? - layers.datum(from)?);
    let stratum = layers.column(from, field.elevation()[from]).find(|s| s.bottom < elevation - rise)?;
    Some(hex(colour_of(&stratum.material.name)))
}

/// Colour and share of bedded rock on every node.
fn bare_rock(field: &HeightField) -> Vec<(u32, f64)> {
    let Some(layers) = field.layers().filter(|l| l.has_beds()) else { return Vec::new() };
    let loose: Vec<&str> = layers.loose().collect();
    let z = field.elevation();
    parallel::map(z.len(), |i| {
        let mut top = z[i];
        for stratum in layers.column(i, z[i]) {
            if !loose.contains(&stratum.material.name.as_str()) {
                return (colour_of(&stratum.material.name), 1.0 - math::smoothstep(0.0, HIDES, z[i] - top));
            }
            top = stratum.bottom;
        }
        (colour_of("rock"), 0.0)
    })
}

const ROAD: u32 = 0xa89f90;
const TREES: u32 = 0x35432a;
const STONES: u32 = 0x8d8881;
/// Area that a crown covers, in squares of the least distance between trees.
const CROWN: f64 = 1.2;

/// Roads, and what stands on the ground: colour and share of every node.
fn laid(field: &HeightField) -> Vec<(Rgb, f64)> {
    let (grid, features) = (field.grid(), field.features());
    let has = |kind| features.of(kind).next().is_some();
    if !(has(FeatureKind::Path) || has(FeatureKind::Object)) {
        return Vec::new();
    }
    let number = |feature: &Feature, name: &str| feature.number(name).unwrap_or(0.0);
    let mut laid = vec![(hex(TREES), 0.0); grid.len()];
    for feature in features.of(FeatureKind::Object) {
        let Geometry::Points(points) = &feature.geometry else { continue };
        let is_stone = ["rock", "stone", "boulder"].iter().any(|word| feature.id.contains(word));
        let spacing = number(feature, "spacing_m");
        let (colour, part) = (hex(if is_stone { STONES } else { TREES }), CROWN * spacing * spacing / grid.cell_area());
        for node in points.iter().filter_map(|p| grid.node_at([p[0], p[1]])) {
            let (over, share) = &mut laid[node];
            (*over, *share) = (colour, (*share + part).min(0.9));
        }
    }
    let places: Vec<[f64; 2]> = (0..grid.len()).map(|i| grid.position(i)).collect();
    for road in features.of(FeatureKind::Path) {
        let half = 0.5 * number(road, "width_m").max(grid.spacing[0].max(grid.spacing[1]));
        let on = near(std::iter::once(road), half, &places);
        laid.iter_mut().zip(on).filter(|(_, on)| *on).for_each(|(laid, _)| *laid = (hex(ROAD), 0.9));
    }
    laid
}

impl Cover {
    /// The cover of a raster.
    pub(super) fn of(field: &HeightField) -> Self {
        let depth = |material: &str| field.depth(material).map(<[f64]>::to_vec).unwrap_or_default();
        let [dx, dy] = field.grid().spacing;
        let (sand, snow, coral) = (depth("sand"), depth("snow"), depth("coral"));
        Self { sand, snow, coral, rock: bare_rock(field), laid: laid(field), cell: dx.min(dy) }
    }

    /// Whether it is known where trees stand.
    pub(super) fn has_objects(&self) -> bool {
        !self.laid.is_empty()
    }

    /// Whether the ground is a desert, where no water stands or runs.
    pub(super) fn is_desert(&self) -> bool {
        !self.sand.is_empty()
    }

    /// How much of a node sand covers, 0 to 1.
    fn sand(&self, i: usize) -> f64 {
        math::smoothstep(0.02, 0.25, self.sand[i] / self.cell)
    }

    /// How much of a node lies under sand or snow, which are smooth, 0 to 1.
    pub(super) fn smooth(&self, i: usize) -> f64 {
        let sand = if self.sand.is_empty() { 0.0 } else { self.sand(i) };
        if self.snow.is_empty() { sand } else { sand.max(self.snow(i)) }
    }

    /// How much of a node snow covers, 0 to 1.
    fn snow(&self, i: usize) -> f64 {
        math::smoothstep(0.02, 0.4, self.snow[i])
    }

    /// How much of a node coral covers, 0 to 1.
    fn coral(&self, i: usize) -> f64 {
        self.coral.get(i).map_or(0.0, |&c| math::smoothstep(0.0, REEF, c))
    }

    /// The colour of the sea over a node, through which a shallow reef shows; `depth` of the water,
    /// m.
    pub(super) fn through_water(&self, colour: Rgb, i: usize, depth: f64) -> Rgb {
        let seen = 0.85 * self.coral(i) * math::exp(-depth.max(0.0) / SEEN);
        if seen > 0.0 { mix(colour, hex(SHOAL), seen) } else { colour }
    }

    /// The colour of a node under what lies on it. `strength` of the desert's colours against the
    /// ground's own.
    pub(super) fn tint(&self, colour: Rgb, i: usize, strength: f64) -> Rgb {
        let mut colour = colour;
        if let Some(&(rock, bare)) = self.rock.get(i) {
            colour = mix(colour, hex(rock), 0.25 + 0.6 * bare * strength);
        }
        let coral = self.coral(i);
        if coral > 0.0 {
            colour = mix(colour, hex(CORAL), 0.8 * coral * strength);
        }
        if !self.sand.is_empty() {
            colour = mix(mix(colour, hex(GRAVEL), 0.85 * strength), mix(colour, hex(SAND), strength), self.sand(i));
        }
        if !self.snow.is_empty() {
            colour = mix(colour, hex(SNOW), self.snow(i));
        }
        if let Some(&(over, share)) = self.laid.get(i) {
            colour = mix(colour, over, share);
        }
        colour
    }
}
