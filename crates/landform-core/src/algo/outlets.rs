//! Where water leaves a terrain.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::flow::Flow;
use crate::grid::{BASE_LEVEL, Domain, INTERIOR, MASKED, Side};
use crate::terrain::NodeSurface;

/// Where water leaves: at these nodes the elevation is a base level, which is held.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected \"border\", \"valleys\" or a list of \"north\", \"east\", \"south\", \"west\"")]
pub enum Outlets {
    /// By a word.
    Named(NamedOutlets),
    /// These sides of the bounding rectangle, and no others.
    Sides(Vec<Side>),
}

/// Outlets by a word.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum NamedOutlets {
    /// The terrain's whole border, the rim of outer nodata included.
    Border,
    /// The low points of the border; between them the border rises and falls with the land, as on a cut-out of real ground.
    Valleys,
}

impl Outlets {
    /// Makes these nodes, and no others, the terrain's base level, for every process that follows.
    pub fn apply<T: NodeSurface>(&self, terrain: &mut T) {
        terrain.set_status(None);
        let status = match self {
            Self::Named(NamedOutlets::Border) => return,
            Self::Named(NamedOutlets::Valleys) => valleys(terrain),
            Self::Sides(sides) => on_sides(sides, terrain),
        };
        terrain.set_status(Some(status));
    }
}

/// Of the border's base levels stay the low points of the border at which water from inside leaves when all of it is open;
/// the lowest of all, if there is none. A valley that enters from outside is no outlet.
fn valleys<T: NodeSurface>(terrain: &T) -> Vec<u8> {
    let (domain, z) = (terrain.domain(), terrain.elevation());
    let status = domain.status();
    let (mut flow, mut donors) = (Flow::new(), vec![1.0; z.len()]);
    flow.route(&*domain, z, &mut donors);
    let is_border = |i: usize| status[i] == BASE_LEVEL;
    let below = |i: usize, j: usize| (z[i], i) < (z[j], j);
    let is_low = |i: usize| domain.neighbours(i).all(|l| !is_border(l.to) || below(i, l.to));
    let mut outlets: Vec<usize> = (0..z.len()).filter(|&i| is_border(i) && donors[i] > 1.0 && is_low(i)).collect();
    if outlets.is_empty() {
        outlets.extend((0..z.len()).filter(|&i| is_border(i)).reduce(|a, b| if below(b, a) { b } else { a }));
    }
    let mut new: Vec<u8> = status.iter().map(|&s| if s == BASE_LEVEL { INTERIOR } else { s }).collect();
    for i in outlets {
        new[i] = BASE_LEVEL;
    }
    new
}

fn on_sides<T: NodeSurface>(sides: &[Side], terrain: &T) -> Vec<u8> {
    let [lo, hi] = terrain.bounds();
    let near = 1e-6 * (hi[0] - lo[0]).max(hi[1] - lo[1]);
    let on = |i: usize| {
        let [x, y] = terrain.position(i);
        sides.iter().any(|side| match side {
            Side::North => hi[1] - y <= near,
            Side::East => hi[0] - x <= near,
            Side::South => y - lo[1] <= near,
            Side::West => x - lo[0] <= near,
        })
    };
    let domain = terrain.domain();
    let status = domain.status();
    let new = |i: usize| match status[i] {
        MASKED => MASKED,
        _ if on(i) => BASE_LEVEL,
        _ => INTERIOR,
    };
    (0..status.len()).map(new).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::terrain::HeightField;

    fn base_count(terrain: &HeightField) -> usize {
        terrain.domain().status().iter().filter(|&&s| s == BASE_LEVEL).count()
    }

    #[test]
    fn outlets_are_set_and_set_back() {
        let grid = Grid::new(Shape::new(10, 10), [1.0, 1.0]).unwrap();
        let z = (0..100).map(|i| f64::from((i * 37) % 11)).collect();
        let mut terrain = HeightField::new(grid, z).unwrap();
        assert_eq!(base_count(&terrain), 36);
        Outlets::Named(NamedOutlets::Valleys).apply(&mut terrain);
        assert!((1..18).contains(&base_count(&terrain)));
        Outlets::Sides(vec![Side::West]).apply(&mut terrain);
        assert_eq!(base_count(&terrain), 10);
        Outlets::Named(NamedOutlets::Border).apply(&mut terrain);
        assert_eq!(base_count(&terrain), 36);
    }
}
