//! Irregular grains of a size in metres, of which a coast falls one by one.
//!
//! # Method
//! One site stands somewhere in each square of the grain's size; a grain is what lies nearest to
//! its site, and the sides between grains are as long as the polygons' edges. Two rings of grains
//! lie beyond the map: over open sides they are sea. A raster's nodes belong to the grain that is
//! nearest to them, after a small shift that bends the edges. So neither the shape of a coast nor
//! what falls depends on the cells of the raster.

mod front;
#[cfg(test)]
mod tests;

use landform_core::algo::noise::gradient_noise;
use landform_core::grid::{Domain, Edge, Edges, Grid, Neighbours};
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, Mesh, NodeSurface};
use landform_core::{Error, Result, parallel};

pub(super) use front::GrainFront;

/// How far a site may stand from the middle of its square, in grains.
const OFF_MIDDLE: f64 = 0.4;
/// Rings of grains beyond the map.
const RINGS: usize = 2;
/// Shift of the raster's nodes, and the length over which it changes, in grains.
const SHIFT: f64 = 0.45;
const SHIFT_LENGTH: f64 = 0.9;
/// Least size of a grain, in cells: below, many grains would hold no node.
const LEAST_CELLS: f64 = 0.5;
/// Lines along each axis from which raggedness is found.
const LINES: usize = 9;
/// Most grains of a map.
const MOST: f64 = 2e7;

/// The grains of a map.
#[derive(Clone, Debug)]
pub(super) struct Grains {
    /// Side of the squares, m.
    size: f64,
    /// Squares along x and y, rings included.
    across: [usize; 2],
    /// Where each site stands from the middle of the map, m.
    sites: Vec<[f64; 2]>,
    /// Neighbours of each grain, and the lengths of the sides shared with them, m.
    start: Vec<u32>,
    to: Vec<u32>,
    side: Vec<f32>,
    /// The sum of the sides of each, m.
    around: Vec<f64>,
    /// What lies beyond the map.
    beyond: Vec<Option<Beyond>>,
    /// The raster's node nearest to each site.
    node: Vec<u32>,
    /// Nodes of each grain.
    nodes_start: Vec<u32>,
    nodes: Vec<u32>,
    /// Length of the sides along a straight line over its own length.
    ragged: f64,
}

/// A grain beyond the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Beyond {
    Sea,
    Nothing,
}

impl Grains {
    /// The grains of a raster, `size` metres wide.
    pub(super) fn new(terrain: &HeightField, size: f64, seed: Seed) -> Result<Self> {
        let grid = terrain.grid();
        let cell = grid.spacing[0].min(grid.spacing[1]);
        let [width, height] = grid.extent();
        let refuse = |allowed: String| Err(Error::parameter("grain", format!("{size} m"), &allowed));
        if grid.edges.wraps_cols() || grid.edges.wraps_rows() {
            return refuse("none on a map without ends".into());
        }
        let (least, most) = (LEAST_CELLS * cell, 0.25 * width.min(height));
        if !(least..=most).contains(&size) || width * height / (size * size) > MOST {
            return refuse(format!("{least} to {most} m: half a cell to a quarter of the shorter side"));
        }
        let across = [width, height].map(|side| (side / size).ceil() as usize + 2 * RINGS);
        let middle = |k: usize, n: usize| (k as f64 + 0.5 - 0.5 * n as f64) * size;
        let off = |bits: u64| (f64::from(bits as u32) / f64::from(u32::MAX) * 2.0 - 1.0) * OFF_MIDDLE * size;
        let sites: Vec<[f64; 2]> = (0..across[0] * across[1])
            .map(|k| {
                let bits = seed.bits(k as u64);
                [middle(k % across[0], across[0]) + off(bits), middle(k / across[0], across[1]) + off(bits >> 32)]
            })
            .collect();
        let mut grains = Self {
            size,
            across,
            start: Vec::new(),
            to: Vec::new(),
            side: Vec::new(),
            around: Vec::new(),
            beyond: sites.iter().map(|&at| beyond(at, [width, height], grid.edges)).collect(),
            sites,
            node: Vec::new(),
            nodes_start: Vec::new(),
            nodes: Vec::new(),
            ragged: 1.0,
        };
        grains.find_sides()?;
        grains.gather(terrain, seed.named("edges"));
        grains.ragged = grains.raggedness();
        Ok(grains)
    }

    /// Number of grains, those beyond the map included.
    pub(super) fn len(&self) -> usize {
        self.sites.len()
    }

    fn find_sides(&mut self) -> Result<()> {
        let mesh = Mesh::delaunay(&self.sites, Edges::all(Edge::Closed))?;
        let graph = mesh.domain();
        let own: Vec<u32> = mesh.positions().iter().map(|&at| self.square(at) as u32).collect();
        let mut place = vec![0u32; own.len()];
        own.iter().enumerate().for_each(|(k, &grain)| place[grain as usize] = k as u32);
        for &k in &place {
            self.start.push(self.to.len() as u32);
            let mut around = 0.0;
            for link in graph.neighbours(k as usize) {
                let side = graph.conductance(k as usize, link.slot) * link.distance;
                around += side;
                self.to.push(own[link.to]);
                self.side.push(side as f32);
            }
            self.around.push(around);
        }
        self.start.push(self.to.len() as u32);
        Ok(())
    }

    /// The square that a place lies in.
    fn square(&self, [x, y]: [f64; 2]) -> usize {
        let along = |v: f64, n: usize| ((v / self.size + 0.5 * n as f64).floor().max(0.0) as usize).min(n - 1);
        along(y, self.across[1]) * self.across[0] + along(x, self.across[0])
    }

    /// Gives every node of the raster to a grain.
    fn gather(&mut self, terrain: &HeightField, seed: Seed) {
        let grid = terrain.grid();
        let middle = middle_of(grid);
        let place = |i: usize| {
            let at = grid.position(i);
            [at[0] - middle[0], at[1] - middle[1]]
        };
        let shift = |k: u64, [x, y]: [f64; 2]| {
            let unit = SHIFT_LENGTH * self.size;
            SHIFT * self.size * gradient_noise(seed.with(k), x / unit, y / unit)
        };
        let grain = parallel::map(grid.len(), |i| {
            let at = place(i);
            self.nearest([at[0] + shift(0, at), at[1] + shift(1, at)])
        });
        let mut count = vec![0u32; self.len() + 1];
        grain.iter().for_each(|&g| count[g as usize + 1] += 1);
        for g in 0..self.len() {
            count[g + 1] += count[g];
        }
        self.nodes_start.clone_from(&count);
        self.nodes = vec![0; grain.len()];
        for (i, &g) in grain.iter().enumerate() {
            self.nodes[count[g as usize] as usize] = i as u32;
            count[g as usize] += 1;
        }
        let nearest_node = |at: [f64; 2]| {
            let along = |v: f64, step: f64, n: usize| {
                ((v / step + 0.5 * (n as f64 - 1.0)).round().max(0.0) as usize).min(n - 1)
            };
            let col = along(at[0], grid.spacing[0], grid.shape.cols);
            let row = along(-at[1], grid.spacing[1], grid.shape.rows);
            grid.shape.index(row, col) as u32
        };
        self.node = self.sites.iter().map(|&at| nearest_node(at)).collect();
    }

    /// The grain of the map whose site is nearest.
    fn nearest(&self, at: [f64; 2]) -> u32 {
        let mut best = (f64::INFINITY, 0);
        for k in self.within(self.square(at), 2) {
            let [x, y] = self.sites[k];
            let d = (x - at[0]) * (x - at[0]) + (y - at[1]) * (y - at[1]);
            if self.beyond[k].is_none() && d < best.0 {
                best = (d, k);
            }
        }
        best.1 as u32
    }

    /// Squares that lie at most so many rows and columns away.
    fn within(&self, square: usize, reach: usize) -> impl Iterator<Item = usize> + '_ {
        let [cols, rows] = self.across;
        let (col, row) = (square % cols, square / cols);
        let range = move |at: usize, n: usize| at.saturating_sub(reach)..(at + reach + 1).min(n);
        range(row, rows).flat_map(move |r| range(col, cols).map(move |c| r * cols + c))
    }

    /// Grains of the map within a distance (m) of one, and how far their sites stand from its site.
    fn near(&self, grain: usize, radius: f64) -> impl Iterator<Item = (usize, f64)> + '_ {
        let [x, y] = self.sites[grain];
        let reach = (radius / self.size).ceil() as usize + 1;
        self.within(grain, reach).filter_map(move |k| {
            let (dx, dy) = (self.sites[k][0] - x, self.sites[k][1] - y);
            let distance = (dx * dx + dy * dy).sqrt();
            (self.beyond[k].is_none() && distance <= radius).then_some((k, distance))
        })
    }

    /// Neighbours of a grain with the sides shared, m.
    fn sides(&self, grain: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.start[grain] as usize..self.start[grain + 1] as usize;
        self.to[range.clone()].iter().zip(&self.side[range]).map(|(&to, &side)| (to as usize, f64::from(side)))
    }

    /// The raster's nodes of a grain.
    pub(super) fn nodes(&self, grain: usize) -> &[u32] {
        &self.nodes[self.nodes_start[grain] as usize..self.nodes_start[grain + 1] as usize]
    }

    /// The raster's node nearest to a grain's site.
    pub(super) fn node(&self, grain: usize) -> usize {
        self.node[grain] as usize
    }

    /// Whether each grain is land, if the raster's nodes are: one of its own, or the nearest where
    /// it has none.
    pub(super) fn land(&self, nodes: &[bool]) -> Vec<bool> {
        let of = |g: usize| match self.nodes(g) {
            [] => nodes[self.node(g)],
            own => own.iter().any(|&i| nodes[i as usize]),
        };
        (0..self.len()).map(|g| self.beyond[g].is_none() && of(g)).collect()
    }

    /// Sides between the halves of the map on either side of straight lines, over the lines'
    /// lengths.
    fn raggedness(&self) -> f64 {
        let [cols, rows] = self.across;
        let inside = |g: usize| {
            let (c, r) = (g % cols, g / cols);
            (RINGS..cols - RINGS).contains(&c) && (RINGS..rows - RINGS).contains(&r)
        };
        let (mut sides, mut lines) = (0.0, 0.0);
        for axis in 0..2 {
            let n = self.across[axis];
            for k in ((RINGS + 1)..(n - RINGS)).take(LINES) {
                let at = (k as f64 - 0.5 * n as f64) * self.size;
                // The grains of two squares on either side hold all sides that cross the line.
                let row = |g: usize| if axis == 0 { g % cols } else { g / cols };
                let near = (0..self.len()).filter(|&g| inside(g) && row(g).abs_diff(k) <= 2);
                sides += near
                    .filter(|&g| self.sites[g][axis] < at)
                    .flat_map(|g| self.sides(g).filter(|&(to, _)| inside(to) && self.sites[to][axis] >= at))
                    .map(|(_, side)| side)
                    .sum::<f64>();
                lines += (self.across[1 - axis] - 2 * RINGS) as f64 * self.size;
            }
        }
        if lines > 0.0 && sides > 0.0 { sides / lines } else { 1.0 }
    }
}

fn middle_of(grid: &Grid) -> [f64; 2] {
    let (first, last) = (grid.position(0), grid.position(grid.len() - 1));
    [0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1])]
}

/// What a site beyond the map stands for.
fn beyond([x, y]: [f64; 2], [width, height]: [f64; 2], edges: Edges) -> Option<Beyond> {
    let sides = [
        (x < -0.5 * width, edges.west),
        (x > 0.5 * width, edges.east),
        (y < -0.5 * height, edges.south),
        (y > 0.5 * height, edges.north),
    ];
    let mut over = sides.into_iter().filter(|s| s.0).peekable();
    over.peek()?;
    Some(if over.any(|s| s.1 == Edge::Open) { Beyond::Sea } else { Beyond::Nothing })
}
