//! Water in pictures.

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::field::names;
use landform_core::math;
use landform_core::terrain::{HeightField, NodeSurface};

use super::ground::is_desert;

/// Standing and running water on a raster.
#[derive(Clone, Debug)]
pub struct Waters {
    /// Depth of lakes, and of rivers where it is known, m; 0 on land.
    pub lake: Vec<f64>,
    /// Strength of rivers, 0 (none) to 1 (the greatest).
    pub river: Vec<f64>,
}

/// The shallowest water that counts as a lake, m, before relief is considered.
const SHALLOWEST: f64 = 0.5;
/// The shallowest water that is drawn where its depth is known, m.
const SHALLOWEST_KNOWN: f64 = 0.1;

/// Lakes and rivers of a raster: from its fields if it has them (depth of water before drainage),
/// else by routing over it; none where there is loose sand, in which it would sink.
pub fn waters(field: &HeightField) -> Waters {
    let n = field.grid().len();
    if is_desert(field) {
        return Waters { lake: vec![0.0; n], river: vec![0.0; n] };
    }
    if let Ok(depth) = field.fields.get(&names::WATER_DEPTH, "") {
        let lake = depth.iter().map(|&d| if d >= SHALLOWEST_KNOWN { d } else { 0.0 }).collect();
        return Waters { lake, river: vec![0.0; n] };
    }
    let known = field.fields.get(&names::DRAINAGE_AREA, "").ok().zip(field.fields.get(&names::LAKE_DEPTH, "").ok());
    let (area, depth) = match known {
        Some((area, depth)) => (area.to_vec(), depth.to_vec()),
        None => {
            let domain = field.domain();
            let mut area = node_areas(&*domain);
            let mut flow = Flow::new();
            flow.route(&*domain, field.elevation(), &mut area);
            let level = flow.water_level(field.elevation());
            (area, (0..n).map(|i| level[i] - field.elevation()[i]).collect())
        }
    };
    let finite = field.elevation().iter().filter(|z| z.is_finite());
    let (lo, hi) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &z| (a.min(z), b.max(z)));
    // Depressions that are small against the relief are noise of the data or of a rough start, not
    // lakes.
    let shallowest = SHALLOWEST.max(2e-3 * (hi - lo));
    let least = (field.grid().cell_area() * 150.0).max(4e-4 * field.grid().cell_area() * n as f64);
    let most = area.iter().copied().filter(|a| a.is_finite()).fold(least * 2.0, f64::max);
    let span = math::log(most / least);
    Waters {
        lake: depth.iter().map(|&d| if d > shallowest { d } else { 0.0 }).collect(),
        river: area.iter().map(|&a| if a > least { 0.35 + 0.65 * math::log(a / least) / span } else { 0.0 }).collect(),
    }
}
