//! Parts of a coast with reefs: mountain, island, beach, lagoon, reef, ocean.
//!
//! Land is parted by its height over the sea. Water deeper than a reef flat is ocean where the sea
//! beyond the map reaches it through such water, and else lagoon. Coral in shallower water is crest
//! beside the ocean and flat behind; under the ocean, it is the reef's front down to the foot of
//! its talus. Coral from which none leads up to a crest or flat has drowned, and is ocean floor.

use landform_core::grid::Domain;
use landform_core::parallel;

use super::open_water::{Shore, cell_width};

/// Depth of coral that makes a reef, m.
const REEF: f64 = 0.5;
/// Greatest depth of water on a reef's flat and crest, m.
pub(super) const FLAT: f64 = 3.0;
/// Heights of a beach over the sea, m: bare ground between low water and the reach of storms.
const BEACH: [f64; 2] = [-1.0, 4.0];
/// Width of a crest, m, and in cells where those are wider.
const CREST: [f64; 2] = [60.0, 1.5];
/// Part of the greatest height over the sea above which land is a mountain, and the least height,
/// m.
const MOUNTAIN: [f64; 2] = [0.4, 50.0];

/// Classes, numbers of [`COAST_LABELS`](landform_core::field::names::COAST_LABELS).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Part {
    Nodata,
    Mountain,
    Island,
    Beach,
    Lagoon,
    ReefFlat,
    ReefCrest,
    ReefFront,
    Ocean,
}

/// The part of the coast that each node belongs to, with the sea at `level` (m) and coral of a
/// depth (m) on the ground, none where it is empty.
pub(super) fn label(shore: &Shore, domain: &impl Domain, surface: &[f64], coral: &[f64], level: f64) -> Vec<u8> {
    let depth = |i: usize| level - surface[i];
    let open = shore.open(domain, depth, FLAT);
    let crest = CREST[0].max(CREST[1] * cell_width(domain, surface));
    let distance = shore.distance(domain, depth, &open, crest);
    let highest = parallel::max(surface.len(), |i| -depth(i));
    let mountain = MOUNTAIN[1].max(MOUNTAIN[0] * highest);
    let is_reef = |i: usize| coral.get(i).is_some_and(|&c| c >= REEF);
    let mut parts = parallel::map(surface.len(), |i| {
        let part = match -depth(i) {
            height if height.is_nan() => Part::Nodata,
            height if height > mountain => Part::Mountain,
            height if height > BEACH[1] => Part::Island,
            height if height > 0.0 => Part::Beach,
            height if height >= -FLAT && is_reef(i) => match distance[i] <= crest {
                true => Part::ReefCrest,
                false => Part::ReefFlat,
            },
            height if height >= BEACH[0] => Part::Beach,
            _ if open[i] => Part::Ocean,
            _ => Part::Lagoon,
        };
        part as u8
    });
    mark_front(domain, &mut parts, is_reef);
    parts
}

/// Makes reef front of ocean with coral that is joined to a flat or crest.
fn mark_front(domain: &impl Domain, parts: &mut [u8], is_reef: impl Fn(usize) -> bool) {
    let is_top = |part: u8| part == Part::ReefFlat as u8 || part == Part::ReefCrest as u8;
    let mut stack: Vec<usize> = (0..parts.len()).filter(|&i| is_top(parts[i])).collect();
    while let Some(i) = stack.pop() {
        for link in domain.neighbours(i) {
            if parts[link.to] == Part::Ocean as u8 && is_reef(link.to) {
                parts[link.to] = Part::ReefFront as u8;
                stack.push(link.to);
            }
        }
    }
}
