//! Rivers, lakes, basins, coasts and contours as features.

use super::waters::{Basin, Lake, RiverReach};
use super::{Drainage, Width, basins, lakes, rivers};
use crate::algo::isoline::{Isoline, isolines};
use crate::feature::{Feature, FeatureKind, Features, Geometry, Property};
use crate::terrain::Rasterize;
use crate::units::MM_PER_YEAR;
use crate::verb::Source;
use crate::{Result, math};

/// The search for features.
#[derive(Clone, Debug)]
pub struct FeatureSearch {
    /// Kinds.
    pub kinds: Vec<FeatureKind>,
    /// Least drainage area of a river and of a basin, m²; a two-thousandth of the map if none.
    pub least_area: Option<f64>,
    /// Least depth of a lake, where it is deepest, m.
    pub least_depth: f64,
    /// Sea level, at which rivers end, m.
    pub sea_level: Option<f64>,
    /// Rainfall where the terrain has no field of it, m/s.
    pub rainfall: f64,
    /// Width of rivers where the depth of their water is not known.
    pub width: Width,
    /// Levels of contours, m.
    pub levels: Vec<f64>,
}

impl FeatureSearch {
    /// The papers behind what is found.
    pub const SOURCES: &'static [Source] = &[
        Source {
            authors: "Strahler (1957)",
            title: "Quantitative analysis of watershed geomorphology, Eos 38(6)",
            doi: "10.1029/TR038i006p00913",
        },
        Source {
            authors: "Moody & Troutman (2002)",
            title: "Characterization of the spatial variability of channel morphology, Earth Surface Processes and Landforms 27",
            doi: "10.1002/esp.403",
        },
    ];
    /// Rainfall where none is given, m/s: 1 m/yr.
    pub const DEFAULT_RAIN: f64 = 1_000.0 * MM_PER_YEAR;

    /// A search for one kind, with the defaults.
    pub fn of(kind: FeatureKind) -> Self {
        Self {
            kinds: vec![kind],
            least_area: None,
            least_depth: 1.0,
            sea_level: None,
            rainfall: Self::DEFAULT_RAIN,
            width: Width::default(),
            levels: Vec::new(),
        }
    }
}

/// Finds features on a terrain. Lakes, basins and contours of a mesh are those of the raster made
/// of it.
///
/// # Errors
/// Where [`Rasterize::rasterized`] fails.
pub fn find_features<T: Rasterize>(terrain: &T, search: &FeatureSearch) -> Result<Features> {
    let map = map_area(terrain);
    let least = search.least_area.unwrap_or(map / 2_000.0);
    let round = Rounding::of((map / terrain.elevation().len() as f64).sqrt());
    let wants = |kind: FeatureKind| search.kinds.contains(&kind);
    let mut found = Vec::new();
    if wants(FeatureKind::River) {
        let drainage = Drainage::of(terrain, search.sea_level, search.rainfall);
        found.extend(rivers(terrain, &drainage, least, search.width).iter().map(|r| river(r, round)));
    }
    let raster = terrain.rasterized()?;
    if wants(FeatureKind::Lake) || wants(FeatureKind::Basin) {
        let drainage = Drainage::of(&*raster, search.sea_level, search.rainfall);
        if wants(FeatureKind::Lake) {
            let all = lakes(&raster, &drainage, search.least_depth, 4.0 * raster.grid().cell_area());
            found.extend(all.iter().enumerate().map(|(k, l)| lake(k, l, round)));
        }
        if wants(FeatureKind::Basin) {
            found.extend(basins(&raster, &drainage, least).iter().enumerate().map(|(k, b)| basin(k, b, round)));
        }
    }
    let mut lines = |kind: FeatureKind, levels: &[f64]| {
        for &level in levels {
            let all = isolines(raster.grid(), crate::terrain::NodeSurface::elevation(&*raster), level);
            found.extend(all.iter().enumerate().map(|(k, l)| line(kind, k, level, l, round)));
        }
    };
    if wants(FeatureKind::Coast) {
        lines(FeatureKind::Coast, &[search.sea_level.unwrap_or(0.0)]);
    }
    if wants(FeatureKind::Contour) {
        lines(FeatureKind::Contour, &search.levels);
    }
    Ok(found.into_iter().collect())
}

/// Area of the rectangle around a terrain, m².
fn map_area<T: Rasterize>(terrain: &T) -> f64 {
    let [lo, hi] = terrain.bounds();
    let longer = (hi[0] - lo[0]).max(hi[1] - lo[1]);
    let side = |k: usize| if hi[k] > lo[k] { hi[k] - lo[k] } else { longer / terrain.elevation().len() as f64 };
    (side(0) * side(1)).max(f64::MIN_POSITIVE)
}

/// Rounds to a thousandth of a node's distance or to the centimetre, whichever is finer; it keeps
/// order, so that no river runs uphill.
#[derive(Clone, Copy)]
struct Rounding(f64);

impl Rounding {
    fn of(spacing: f64) -> Self {
        Self(math::pow(10.0, (-math::log10(spacing.max(1e-9))).ceil() + 3.0).max(100.0))
    }

    fn one(self, v: f64) -> f64 {
        (v * self.0).round() / self.0
    }

    fn all<const N: usize>(self, v: [f64; N]) -> [f64; N] {
        v.map(|v| self.one(v))
    }
}

/// Four digits.
fn short(v: f64) -> Property {
    Property::Number(format!("{v:.3e}").parse().unwrap_or(v))
}

fn named(properties: Vec<(&str, Property)>) -> Vec<(String, Property)> {
    properties.into_iter().map(|(name, p)| (name.to_string(), p)).collect()
}

fn river(r: &RiverReach, round: Rounding) -> Feature {
    let id = |(river, reach): (u32, u32)| format!("{river}.{reach}");
    let points: Vec<[f64; 3]> = r.points.iter().map(|p| round.all(*p)).collect();
    let (above, below) = (points[0][2], points[points.len() - 1][2]);
    let ends = match (r.to, r.leaves) {
        (Some(_), _) => "in a river",
        (None, true) => "at an outlet",
        _ => "in a depression",
    };
    let properties = named(vec![
        ("river", Property::Whole(r.river)),
        ("reach", Property::Whole(r.reach)),
        ("flows_to", r.to.map_or(Property::None, |to| Property::Id(id(to)))),
        ("ends", Property::Text(ends.into())),
        ("order", Property::Whole(r.order)),
        ("drainage_area_m2", short(r.area)),
        ("discharge_m3_s", short(r.discharge)),
        ("width_m", short(r.width)),
        ("width_above_m", short(r.width_above)),
        ("depth_m", short(r.depth)),
        ("in_lake", Property::Flag(r.in_lake)),
        ("length_m", short(r.length)),
        ("elevation_above_m", Property::Number(above)),
        ("elevation_below_m", Property::Number(below)),
    ]);
    Feature { id: id((r.river, r.reach)), kind: FeatureKind::River, geometry: Geometry::Line(points), properties }
}

fn rounded(polygon: &super::Polygon, round: Rounding) -> super::Polygon {
    polygon.iter().map(|ring| ring.iter().map(|p| round.all(*p)).collect()).collect()
}

fn lake(k: usize, l: &Lake, round: Rounding) -> Feature {
    let properties = named(vec![
        ("level_m", Property::Number(round.one(l.level))),
        ("depth_m", Property::Number(round.one(l.depth))),
        ("mean_depth_m", Property::Number(round.one(l.volume / l.area))),
        ("area_m2", short(l.area)),
        ("volume_m3", short(l.volume)),
        ("outlet", l.outlet.map_or(Property::None, |p| Property::Place(round.all(p)))),
        ("discharge_m3_s", short(l.discharge)),
    ]);
    let geometry = Geometry::Area(vec![rounded(&l.shore, round)]);
    Feature { id: format!("lake {}", k + 1), kind: FeatureKind::Lake, geometry, properties }
}

fn basin(k: usize, b: &Basin, round: Rounding) -> Feature {
    let [least, mean, greatest] = round.all(b.elevation);
    let properties = named(vec![
        ("area_m2", short(b.area)),
        ("outlet", Property::Place(round.all(b.outlet))),
        ("lowest_m", Property::Number(least)),
        ("mean_m", Property::Number(mean)),
        ("highest_m", Property::Number(greatest)),
        ("hypsometric_integral", short(b.hypsometric_integral)),
    ]);
    let geometry = Geometry::Area(b.outline.iter().map(|p| rounded(p, round)).collect());
    Feature { id: format!("basin {}", k + 1), kind: FeatureKind::Basin, geometry, properties }
}

fn line(kind: FeatureKind, k: usize, level: f64, line: &Isoline, round: Rounding) -> Feature {
    let points = line.points.iter().map(|p| round.all(*p)).collect();
    let properties = named(vec![
        ("level_m", Property::Number(level)),
        ("closed", Property::Flag(line.closed)),
        ("length_m", Property::Number(round.one(line.length()))),
        ("area_m2", Property::Number(round.one(line.area()))),
    ]);
    let id = format!("{} {} m, {}", kind.word(), round.one(level), k + 1);
    Feature { id, kind, geometry: Geometry::FlatLine(points), properties }
}
