//! The form of a cave in numbers, and which kind of cave has such numbers.
//!
//! # Method
//! Pytel, sections 2.4.3 and 5.4.2: length of the centreline; plan area of the sheet between floors
//! and roofs; the field around the plan, a rectangle or all within a radius of a passage. One plan
//! area is used throughout, so that coverage is density times width (the thesis took a sloped
//! area for the width).
//!
//! # Sources
//! Ranges: Klimchouk (2003), optimised field; Frumkin & Fischhendler (2005), rectangular field;
//! both as in Pytel, Tables 2.1 and 2.2.

use serde::Serialize;

use super::cave_voxels;
use super::centreline::line_of;
use super::walk::{Chamber, largest_chamber, walkable};
use crate::algo::lattice::{FACES, Lattice, Thinning, thin, topology};
use crate::terrain::VoxelGrid;

/// Numbers over a field around the plan of a cave.
///
/// ```
/// use landform_core::analysis::cave::Share;
///
/// let share = Share { field_m2: 100.0, density_m_m2: 0.2, coverage_percent: 40.0, porosity_percent: 5.0 };
/// assert_eq!(share.coverage_percent / 100.0 / share.density_m_m2, 2.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Share {
    /// Area of the field, m².
    pub field_m2: f64,
    /// Length over its area, m for each m².
    pub density_m_m2: f64,
    /// Part of it that is plan of passages, %.
    pub coverage_percent: f64,
    /// Part of the block under it that is cave, %.
    pub porosity_percent: f64,
}

/// A kind of cave and which of its ranges the cave lies in.
///
/// ```
/// use landform_core::analysis::cave::CaveClass;
///
/// let class = CaveClass { name: "confined", source: "Klimchouk", within: 4, of: 5, outside: vec!["width_m"] };
/// assert_eq!(class.within + class.outside.len(), class.of);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CaveClass {
    /// Its name: "confined".
    pub name: &'static str,
    /// Whose ranges.
    pub source: &'static str,
    /// Number of ranges that hold.
    pub within: usize,
    /// Number of ranges.
    pub of: usize,
    /// Measures that lie outside.
    pub outside: Vec<&'static str>,
}

/// The form of a cave.
///
/// ```
/// use landform_core::analysis::cave::morphometry;
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{Bounds, Materials, VoxelGrid};
///
/// let plan = Grid::new(Shape::new(11, 40), [1.0, 1.0])?;
/// let mut ground = VoxelGrid::from_fn(plan, 9, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
/// ground.empty(Bounds { low: [2.0, 3.6, 3.2], high: [36.0, 6.4, 5.8] }, |_| true);
/// let found = morphometry(&ground, 5.0).unwrap();
/// assert_eq!(found.volume_m3, 3.0 * 3.0 * 35.0);
/// assert_eq!(found.plan_area_m2, 3.0 * 35.0);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Morphometry {
    /// Length of the centreline, m.
    pub length_m: f64,
    /// Plan area of the passages, each above another counted, m².
    pub plan_area_m2: f64,
    /// Surface of the walls, faces of voxels, m².
    pub surface_m2: f64,
    /// Volume, m³.
    pub volume_m3: f64,
    /// From the lowest floor to the highest roof, m.
    pub depth_range_m: f64,
    /// Mean width: plan area over length, m.
    pub width_m: f64,
    /// Ratio of length to mean width.
    pub length_to_width: f64,
    /// Where the largest ball fits.
    pub largest_chamber: Chamber,
    /// Largest part of the floors over which one walks in one go, standing 1.8 m high and 0.4 m in
    /// radius, on slopes of up to 45°, %.
    pub walkable_percent: f64,
    /// Caves that do not hang together.
    pub pieces: usize,
    /// Independent loops of passages.
    pub loops: usize,
    /// Euler's number of the voxels.
    pub euler: i64,
    /// Radius of the optimised field, m.
    pub field_radius_m: f64,
    /// Over the rectangle around the plan.
    pub rectangular: Share,
    /// Over all within the radius of a passage, inside the rectangle.
    pub optimised: Share,
    /// The kinds of cave with the shares of ranges that hold, best first.
    pub classes: Vec<CaveClass>,
}

/// Measures the cave in some ground; `radius` is that of the optimised field, m. None if there is
/// no cave.
///
/// **Cost** O(voxels), and at most O(plan · rows within the radius).
///
/// ```
/// use landform_core::analysis::cave::morphometry;
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{Materials, VoxelGrid};
///
/// let plan = Grid::new(Shape::new(3, 3), [1.0, 1.0])?;
/// let solid = VoxelGrid::from_fn(plan, 3, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
/// assert!(morphometry(&solid, 5.0).is_none());
/// # Ok::<(), landform_core::Error>(())
/// ```
pub fn morphometry(ground: &VoxelGrid, radius: f64) -> Option<Morphometry> {
    let (lattice, cave) = cave_voxels(ground);
    let voxels: Vec<usize> = lattice.voxels().filter(|&i| cave[i]).collect();
    if voxels.is_empty() {
        return None;
    }
    let [dx, dy, dz] = lattice.sides();
    let mut sheet = cave.clone();
    thin(&lattice, &mut sheet, Thinning::Sheet);
    let plan_area = voxels.iter().filter(|&&i| sheet[i]).count() as f64 * dx * dy;
    // A cave of one voxel is as long as it is wide.
    let length = line_of(ground, &lattice, &cave).length().max(dx.max(dy));
    let volume = voxels.len() as f64 * dx * dy * dz;
    let levels = voxels.iter().map(|&i| lattice.place(i)[2]);
    let (low, high) = levels.fold((usize::MAX, 0), |(lo, hi), z| (lo.min(z), hi.max(z)));
    let depth = (high + 1 - low) as f64 * dz;
    let [rectangle, near] = fields(&lattice, &voxels, radius);
    let share = |field: f64| Share {
        field_m2: field,
        density_m_m2: length / field,
        coverage_percent: 100.0 * plan_area / field,
        porosity_percent: 100.0 * volume / (field * depth),
    };
    let numbers = topology(&lattice, &cave);
    let width = plan_area / length;
    let (rectangular, optimised) = (share(rectangle), share(near));
    Some(Morphometry {
        length_m: length,
        plan_area_m2: plan_area,
        surface_m2: walls(&lattice, &cave, &voxels),
        volume_m3: volume,
        depth_range_m: depth,
        width_m: width,
        length_to_width: length / width,
        largest_chamber: largest_chamber(ground, &lattice, &cave, &voxels),
        walkable_percent: 100.0 * walkable(&lattice, &cave, &voxels),
        pieces: numbers.pieces,
        loops: numbers.tunnels,
        euler: numbers.euler,
        field_radius_m: radius,
        rectangular,
        optimised,
        classes: classes(rectangular, optimised, width, length / width),
    })
}

/// Area of all faces between cave and rock, m².
fn walls(lattice: &Lattice, cave: &[bool], voxels: &[usize]) -> f64 {
    let [dx, dy, dz] = lattice.sides();
    let areas = [dx * dy, dx * dy, dx * dz, dx * dz, dy * dz, dy * dz];
    let of = |i: usize| {
        let open = FACES.into_iter().zip(areas).filter(|f| !cave[lattice.neighbour(i, f.0)]);
        open.map(|f| f.1).sum::<f64>()
    };
    voxels.iter().map(|&i| of(i)).sum()
}

/// Areas of the rectangle around the plan, and of what of it lies within a radius of a passage, m².
fn fields(lattice: &Lattice, voxels: &[usize], radius: f64) -> [f64; 2] {
    let ([nx, ny, _], [dx, dy, _]) = (lattice.size(), lattice.sides());
    let mut plan = vec![false; nx * ny];
    let (mut low, mut high) = ([nx, ny], [0, 0]);
    for &i in voxels {
        let [x, y, _] = lattice.place(i);
        plan[y * nx + x] = true;
        (low, high) = ([low[0].min(x), low[1].min(y)], [high[0].max(x), high[1].max(y)]);
    }
    // How far along its row the plan is from each cell; the way there is then down a column.
    let aside: Vec<f64> = (0..nx * ny).map(|_| f64::INFINITY).collect();
    let aside = (0..ny).fold(aside, |mut aside, y| {
        let row = y * nx..(y + 1) * nx;
        nearest_along(&plan[row.clone()], &mut aside[row], dx);
        aside
    });
    let reach = ((radius / dy).min(ny as f64)) as usize;
    let is_near = |x: usize, y: usize| {
        (y.saturating_sub(reach).max(low[1])..=(y + reach).min(high[1])).any(|other| {
            let d = [aside[other * nx + x], y.abs_diff(other) as f64 * dy];
            d[0] * d[0] + d[1] * d[1] <= radius * radius
        })
    };
    let cells = (low[1]..=high[1]).flat_map(|y| (low[0]..=high[0]).map(move |x| (x, y)));
    let cell = dx * dy;
    let rectangle = ((high[0] + 1 - low[0]) * (high[1] + 1 - low[1])) as f64 * cell;
    [rectangle, cells.filter(|&(x, y)| is_near(x, y)).count() as f64 * cell]
}

/// Distances to the nearest of the marked cells of a row, m.
fn nearest_along(marked: &[bool], out: &mut [f64], step: f64) {
    let n = marked.len();
    let mut sweep = |cells: &mut dyn Iterator<Item = usize>| {
        let mut since = f64::INFINITY;
        for i in cells {
            since = if marked[i] { 0.0 } else { since + 1.0 };
            out[i] = out[i].min(since * step);
        }
    };
    sweep(&mut (0..n));
    sweep(&mut (0..n).rev());
}

/// A measure and its range.
type Range = (&'static str, [f64; 2]);

const KLIMCHOUK: [(&str, [Range; 5]); 2] = [
    (
        "confined",
        [
            ("density_m_m2", [0.049, 0.406]),
            ("coverage_percent", [13.56, 58.51]),
            ("porosity_percent", [1.1, 12.0]),
            ("length_to_width", [798.06, 135_940.0]),
            ("width_m", [0.65, 4.53]),
        ],
    ),
    (
        "unconfined",
        [
            ("density_m_m2", [0.012, 0.023]),
            ("coverage_percent", [3.77, 8.55]),
            ("porosity_percent", [0.15, 0.77]),
            ("length_to_width", [4676.41, 218_254.0]),
            ("width_m", [2.52, 4.56]),
        ],
    ),
];
const FRUMKIN: [(&str, [Range; 4]); 2] = [
    (
        "chamber",
        [
            ("density_m_m2", [0.01, 0.25]),
            ("coverage_percent", [20.0, 80.0]),
            ("length_to_width", [2.0, 20.0]),
            ("width_m", [2.0, 100.0]),
        ],
    ),
    (
        "confined",
        [
            ("density_m_m2", [0.07, 0.35]),
            ("coverage_percent", [10.0, 40.0]),
            ("length_to_width", [20.0, 4000.0]),
            ("width_m", [0.9, 8.0]),
        ],
    ),
];

fn classes(rectangular: Share, optimised: Share, width: f64, slender: f64) -> Vec<CaveClass> {
    let class = |name: &'static str, source: &'static str, ranges: &[Range], share: Share| {
        let value = |measure: &str| match measure {
            "density_m_m2" => share.density_m_m2,
            "coverage_percent" => share.coverage_percent,
            "porosity_percent" => share.porosity_percent,
            "length_to_width" => slender,
            _ => width,
        };
        let is_out = |r: &&Range| !(r.1[0]..=r.1[1]).contains(&value(r.0));
        let outside: Vec<&'static str> = ranges.iter().filter(is_out).map(|r| r.0).collect();
        CaveClass { name, source, within: ranges.len() - outside.len(), of: ranges.len(), outside }
    };
    let mut all: Vec<CaveClass> =
        KLIMCHOUK.iter().map(|(name, r)| class(name, "Klimchouk (2003), optimised field", r, optimised)).collect();
    let frumkin = "Frumkin & Fischhendler (2005), rectangular field";
    all.extend(FRUMKIN.iter().map(|(name, r)| class(name, frumkin, r, rectangular)));
    all.sort_by(|a, b| (b.within * a.of).cmp(&(a.within * b.of)));
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::terrain::{Bounds, Materials};

    fn passage(low: [f64; 3], high: [f64; 3]) -> VoxelGrid {
        let plan = Grid::new(Shape::new(30, 60), [1.0, 1.0]).unwrap();
        let mut ground = VoxelGrid::from_fn(plan, 12, 0.0, 0.5, &Materials::default(), |_, _| Some(0)).unwrap();
        ground.empty(Bounds { low, high }, |_| true);
        ground
    }

    #[test]
    fn a_straight_passage_has_the_numbers_of_a_box() {
        // 50 m long, 5 m wide, 2 m high.
        let found = morphometry(&passage([4.6, 9.6, 1.0], [54.4, 14.4, 2.9]), 4.0).unwrap();
        assert_eq!((found.volume_m3, found.plan_area_m2), (50.0 * 5.0 * 2.0, 250.0));
        assert_eq!(found.surface_m2, 2.0 * (50.0 * 5.0 + 50.0 * 2.0 + 5.0 * 2.0));
        // Thinning takes half of the width or height off each end.
        assert!((found.length_m - 50.0).abs() <= 5.0, "{}", found.length_m);
        assert!((found.width_m - 5.0).abs() < 0.7, "{}", found.width_m);
        assert!((found.rectangular.porosity_percent - 100.0).abs() < 1e-9);
        assert_eq!((found.pieces, found.loops, found.euler), (1, 0, 1));
    }

    #[test]
    fn a_field_beyond_the_block_is_its_rectangle() {
        let mut ground = passage([4.6, 9.6, 1.0], [54.4, 14.4, 2.9]);
        ground.empty(Bounds { low: [20.0, 2.0, 3.5], high: [23.0, 27.0, 5.4] }, |_| true);
        for radius in [100.0, 2e7, 1e300] {
            let found = morphometry(&ground, radius).unwrap();
            assert_eq!(found.optimised.field_m2, found.rectangular.field_m2);
        }
        // A radius of less than a cell is the plan itself.
        let is_open = |node: &usize| (0..ground.levels()).any(|level| ground.material(level, *node).is_none());
        let plan = (0..ground.plan().len()).filter(is_open).count();
        assert_eq!(morphometry(&ground, 0.5).unwrap().optimised.field_m2, plan as f64);
    }

    #[test]
    fn coverage_is_density_times_width() {
        let mut ground = passage([4.6, 9.6, 1.0], [54.4, 14.4, 2.9]);
        ground.empty(Bounds { low: [20.0, 2.0, 3.5], high: [23.0, 27.0, 5.4] }, |_| true);
        let found = morphometry(&ground, 6.0).unwrap();
        for share in [found.rectangular, found.optimised] {
            let product = 100.0 * share.density_m_m2 * found.width_m;
            assert!((share.coverage_percent / product - 1.0).abs() < 1e-12);
        }
        assert!(found.optimised.field_m2 < found.rectangular.field_m2);
        assert_eq!(found.pieces, 2);
        assert_eq!(found.classes.len(), 4);
    }
}
