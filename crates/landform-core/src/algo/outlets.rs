//! The nodes by which water leaves, and water at sea level.
//!
//! ```
//! use landform_core::algo::outlets::at_or_under;
//! use landform_core::grid::{Grid, Shape, Status};
//! use landform_core::terrain::HeightField;
//!
//! let grid = Grid::new(Shape::new(2, 2), [10.0, 10.0])?;
//! let shore = HeightField::new(grid, vec![-1.0, 0.0, 5.0, 9.0])?;
//! assert_eq!(at_or_under(0.0, &shore), [Status::BaseLevel, Status::BaseLevel, Status::Interior, Status::Interior]);
//! # Ok::<(), landform_core::Error>(())
//! ```

use super::flow::Flow;
use crate::grid::{Domain, Neighbours, Side, Status};
use crate::terrain::NodeSurface;

/// Base level where `is_outlet`, interior elsewhere, nodata as it is.
pub(crate) fn chosen<T: NodeSurface>(terrain: &T, is_outlet: impl Fn(usize) -> bool) -> Vec<Status> {
    let domain = terrain.domain();
    let status = domain.status();
    let new = |i: usize| match status[i] {
        Status::Masked => Status::Masked,
        _ if is_outlet(i) => Status::BaseLevel,
        _ => Status::Interior,
    };
    (0..status.len()).map(new).collect()
}

/// The status that makes every node at or under a level (m) a base level.
pub fn at_or_under<T: NodeSurface>(level: f64, terrain: &T) -> Vec<Status> {
    chosen(terrain, |i| terrain.elevation()[i] <= level)
}

/// Raises the water to sea level (m) at base levels below it that are not connected to the sea:
/// lagoons and depressions, which are lakes. The sea enters over the border, the rim of outer
/// nodata included.
pub fn fill_inland_water<T: NodeSurface>(terrain: &T, domain: &T::Domain, sea_level: f64, water: &mut [f64]) {
    let status = domain.status();
    let [lo, hi] = terrain.bounds();
    let near = 1e-6 * (hi[0] - lo[0]).max(hi[1] - lo[1]);
    let border = terrain.border();
    let on_border = |i: usize| {
        let p = terrain.position(i);
        border[i] == Status::BaseLevel || (0..2).any(|k| p[k] - lo[k] <= near || hi[k] - p[k] <= near)
    };
    let is_water = |i: usize| status[i] == Status::BaseLevel && terrain.elevation()[i] <= sea_level;
    let mut open = vec![false; status.len()];
    let mut stack: Vec<usize> = (0..status.len()).filter(|&i| is_water(i) && on_border(i)).collect();
    stack.iter().for_each(|&i| open[i] = true);
    while let Some(i) = stack.pop() {
        for link in domain.neighbours(i) {
            if !open[link.to] && is_water(link.to) {
                open[link.to] = true;
                stack.push(link.to);
            }
        }
    }
    for i in (0..status.len()).filter(|&i| is_water(i) && !open[i]) {
        water[i] = sea_level;
    }
}

/// Keeps, of the border's base levels, the low points at which water from inside leaves when the
/// whole border is open; the lowest of all, if there is none. A valley that enters from outside is
/// no outlet.
pub(crate) fn valleys<T: NodeSurface>(terrain: &T) -> Vec<Status> {
    let (domain, z) = (terrain.domain(), terrain.elevation());
    let status = domain.status();
    let (mut flow, mut donors) = (Flow::new(), vec![1.0; z.len()]);
    flow.route(&*domain, z, &mut donors);
    let is_border = |i: usize| status[i] == Status::BaseLevel;
    let below = |i: usize, j: usize| (z[i], i) < (z[j], j);
    let is_low = |i: usize| domain.neighbours(i).all(|l| !is_border(l.to) || below(i, l.to));
    let mut outlets: Vec<usize> = (0..z.len()).filter(|&i| is_border(i) && donors[i] > 1.0 && is_low(i)).collect();
    if outlets.is_empty() {
        outlets.extend((0..z.len()).filter(|&i| is_border(i)).reduce(|a, b| if below(b, a) { b } else { a }));
    }
    let mut new: Vec<Status> =
        status.iter().map(|&s| if s == Status::BaseLevel { Status::Interior } else { s }).collect();
    for i in outlets {
        new[i] = Status::BaseLevel;
    }
    new
}

/// As [`valleys`], and the rims of nodata inside, such as lakes that were cut out.
pub(crate) fn holes<T: NodeSurface>(terrain: &T) -> Vec<Status> {
    let mut new = valleys(terrain);
    open_holes(&*terrain.domain(), &mut new);
    new
}

/// Makes the rims of nodata inside base levels.
pub(crate) fn open_holes<D: Domain>(domain: &D, new: &mut [Status]) {
    let status = domain.status();
    for hole in (0..status.len()).filter(|&i| status[i] == Status::Masked) {
        // The rim of outer nodata is of the border already.
        for link in domain.neighbours(hole).filter(|l| status[l.to] == Status::Interior) {
            new[link.to] = Status::BaseLevel;
        }
    }
}

/// Base level on sides of the bounding rectangle.
pub(crate) fn on_sides<T: NodeSurface>(sides: &[Side], terrain: &T) -> Vec<Status> {
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
    chosen(terrain, on)
}
