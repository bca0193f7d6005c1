//! The graph that agents live on.

use crate::grid::{Edge, Edges, Graph, Grid, Lattice, Link, Neighbours, Shape, Side};
use crate::terrain::Mesh;
use crate::{Error, Result};

/// A graph of sites with places in space. x runs east, y north, z up; metres.
pub trait Sites: Neighbours {
    /// The shortest vector from one site to another, around periodic sides where that is nearer, m.
    fn offset(&self, from: usize, to: usize) -> [f64; 3];

    /// The site nearest to the place `by` away from a site; none if that is beyond an open side.
    /// Reflecting sides turn back.
    fn step(&self, site: usize, by: [f64; 3]) -> Option<usize>;

    /// The shortest distance between neighbours, m: the step of rays.
    fn pace(&self) -> f64;

    /// Straight distance between two sites, m.
    fn distance(&self, from: usize, to: usize) -> f64 {
        self.offset(from, to).iter().map(|d| d * d).sum::<f64>().sqrt()
    }
}

/// Which sites of a raster are neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Connectivity {
    /// The four along rows and columns.
    Four,
    /// The diagonal ones too.
    Eight,
    /// Eight and four in turn, as 4-8 subdivision leaves them: diagonals join sites whose row and
    /// column add up to an even number.
    FourEight,
}

/// The sites of a raster.
#[derive(Clone, Debug)]
pub struct RasterSites {
    shape: Shape,
    spacing: [f64; 2],
    edges: Edges,
    connectivity: Connectivity,
}

/// East, north-east and on, counter-clockwise: (column, row).
const AROUND: [(i64, i64); 8] = [(1, 0), (1, -1), (0, -1), (-1, -1), (-1, 0), (-1, 1), (0, 1), (1, 1)];

impl RasterSites {
    /// The sites of a grid; its edges say what a step over a side does (a closed side reflects).
    ///
    /// # Errors
    /// [`Error::Parameter`] if four and eight alternate over a periodic side of odd length, where
    /// parities would not match.
    pub fn new(grid: &Grid, connectivity: Connectivity) -> Result<Self> {
        let (shape, edges) = (grid.shape, grid.edges);
        let odd = edges.wraps_cols() && shape.cols % 2 == 1 || edges.wraps_rows() && shape.rows % 2 == 1;
        if connectivity == Connectivity::FourEight && odd {
            return Err(Error::parameter("shape", shape, "even along periodic sides where neighbours alternate"));
        }
        Ok(Self { shape, spacing: grid.spacing, edges, connectivity })
    }

    /// Rows and columns.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Distance between sites along x and y, m.
    pub fn spacing(&self) -> [f64; 2] {
        self.spacing
    }

    /// The site `cols` columns east and `rows` rows south; none beyond an open side. Reflecting
    /// sides turn back.
    #[inline]
    pub fn moved(&self, site: usize, cols: i64, rows: i64) -> Option<usize> {
        let cell = self.shape.cell(site);
        let (c, r) = (cell.col as i64 + cols, cell.row as i64 + rows);
        if (c as u64) < self.shape.cols as u64 && (r as u64) < self.shape.rows as u64 {
            return Some(self.shape.index(r as usize, c as usize));
        }
        let c = within(c, self.shape.cols, self.edges.get(Side::West), self.edges.get(Side::East))?;
        let r = within(r, self.shape.rows, self.edges.get(Side::North), self.edges.get(Side::South))?;
        Some(self.shape.index(r, c))
    }
}

/// A coordinate brought inside by what the sides do.
fn within(at: i64, n: usize, low: Edge, high: Edge) -> Option<usize> {
    let (mut at, n) = (at, n as i64);
    // A mirror may throw it over the other side; the bound is for sides so near that it would go
    // on.
    for _ in 0..64 {
        if (0..n).contains(&at) {
            return Some(at as usize);
        }
        at = match if at < 0 { low } else { high } {
            Edge::Open => return None,
            Edge::Periodic => at.rem_euclid(n),
            Edge::Closed if at < 0 => -1 - at,
            Edge::Closed => 2 * n - 1 - at,
        };
    }
    None
}

impl Neighbours for RasterSites {
    fn len(&self) -> usize {
        self.shape.len()
    }

    #[inline]
    fn neighbours(&self, site: usize) -> impl Iterator<Item = Link> {
        let cell = self.shape.cell(site);
        let (wide, tall) = (self.edges.wraps_cols(), self.edges.wraps_rows());
        let diagonals = match self.connectivity {
            Connectivity::Four => false,
            Connectivity::Eight => true,
            Connectivity::FourEight => (cell.row + cell.col).is_multiple_of(2),
        };
        let step = if diagonals { 1 } else { 2 };
        let [dx, dy] = self.spacing;
        AROUND.iter().enumerate().step_by(step).filter_map(move |(slot, &(c, r))| {
            let beside = |at: usize, by: i64, n: usize, wraps: bool| {
                let to = at as i64 + by;
                match (0..n as i64).contains(&to) {
                    true => Some(to as usize),
                    false => wraps.then(|| to.rem_euclid(n as i64) as usize),
                }
            };
            let (col, row) = (beside(cell.col, c, self.shape.cols, wide)?, beside(cell.row, r, self.shape.rows, tall)?);
            let distance = match (c, r) {
                (_, 0) => dx,
                (0, _) => dy,
                _ => (dx * dx + dy * dy).sqrt(),
            };
            let to = self.shape.index(row, col);
            (to != site).then_some(Link { to, distance, slot: slot as u8 })
        })
    }
}

impl Sites for RasterSites {
    fn offset(&self, from: usize, to: usize) -> [f64; 3] {
        let (a, b) = (self.shape.cell(from), self.shape.cell(to));
        let shortest = |d: i64, n: usize, wraps: bool| {
            let n = n as i64;
            if wraps { (d + n / 2).rem_euclid(n) - n / 2 } else { d }
        };
        let cols = shortest(b.col as i64 - a.col as i64, self.shape.cols, self.edges.wraps_cols());
        let rows = shortest(b.row as i64 - a.row as i64, self.shape.rows, self.edges.wraps_rows());
        [cols as f64 * self.spacing[0], -(rows as f64) * self.spacing[1], 0.0]
    }

    fn step(&self, site: usize, by: [f64; 3]) -> Option<usize> {
        self.moved(site, (by[0] / self.spacing[0]).round() as i64, (-by[1] / self.spacing[1]).round() as i64)
    }

    fn pace(&self) -> f64 {
        self.spacing[0].min(self.spacing[1])
    }
}

/// The sites of a mesh.
#[derive(Clone, Debug)]
pub struct MeshSites<'a> {
    graph: &'a Graph,
    positions: &'a [[f64; 2]],
    pace: f64,
}

impl<'a> MeshSites<'a> {
    /// The nodes of a mesh.
    pub fn new(mesh: &'a Mesh) -> Self {
        let graph = mesh.graph();
        let pace = (0..graph.len()).flat_map(|i| graph.neighbours(i).map(|l| l.distance)).fold(f64::INFINITY, f64::min);
        Self { graph, positions: mesh.positions(), pace }
    }
}

impl Neighbours for MeshSites<'_> {
    fn len(&self) -> usize {
        self.positions.len()
    }

    fn neighbours(&self, site: usize) -> impl Iterator<Item = Link> {
        self.graph.neighbours(site)
    }
}

impl Sites for MeshSites<'_> {
    fn offset(&self, from: usize, to: usize) -> [f64; 3] {
        let (a, b) = (self.positions[from], self.positions[to]);
        [b[0] - a[0], b[1] - a[1], 0.0]
    }

    fn step(&self, site: usize, by: [f64; 3]) -> Option<usize> {
        let target = [self.positions[site][0] + by[0], self.positions[site][1] + by[1]];
        let away = |i: usize| {
            let p = self.positions[i];
            (p[0] - target[0]) * (p[0] - target[0]) + (p[1] - target[1]) * (p[1] - target[1])
        };
        // On a Delaunay graph stepping to the nearest neighbour ends at the nearest site.
        let (mut at, mut best) = (site, away(site));
        while let Some((next, d)) =
            self.neighbours(at).map(|n| (n.to, away(n.to))).filter(|n| n.1 < best).min_by(|a, b| a.1.total_cmp(&b.1))
        {
            (at, best) = (next, d);
        }
        // Farther from its site than from any neighbour of that: it lies outside.
        let reach = self.neighbours(at).map(|n| n.distance).fold(0.0, f64::max);
        (best.sqrt() <= reach).then_some(at)
    }

    fn pace(&self) -> f64 {
        self.pace
    }
}

/// Which voxels are neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Voxels {
    /// Those that share a face.
    Six,
    /// Or an edge.
    Eighteen,
    /// Or a corner.
    TwentySix,
}

/// The voxels of a box; y and z count upwards with the index.
#[derive(Clone, Debug)]
pub struct VoxelSites {
    /// The box.
    pub lattice: Lattice,
    /// Who is a neighbour.
    pub voxels: Voxels,
}

impl Neighbours for VoxelSites {
    fn len(&self) -> usize {
        self.lattice.len()
    }

    fn neighbours(&self, site: usize) -> impl Iterator<Item = Link> {
        let place = self.lattice.place(site);
        let most = match self.voxels {
            Voxels::Six => 1,
            Voxels::Eighteen => 2,
            Voxels::TwentySix => 3,
        };
        (0..27i64).filter_map(move |k| {
            let by = [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1];
            let axes: i64 = by.iter().map(|b| b.abs()).sum();
            let to =
                (1..=most).contains(&axes).then(|| self.lattice.moved(place, by)).flatten().filter(|&to| to != site)?;
            let distance =
                by.iter().zip(self.lattice.spacing).map(|(&b, h)| b as f64 * h * b as f64 * h).sum::<f64>().sqrt();
            Some(Link { to, distance, slot: k as u8 })
        })
    }
}

impl Sites for VoxelSites {
    fn offset(&self, from: usize, to: usize) -> [f64; 3] {
        self.lattice.offset(from, to)
    }

    fn step(&self, site: usize, by: [f64; 3]) -> Option<usize> {
        let cells = std::array::from_fn(|axis| (by[axis] / self.lattice.spacing[axis]).round() as i64);
        self.lattice.moved(self.lattice.place(site), cells)
    }

    fn pace(&self) -> f64 {
        self.lattice.spacing.iter().copied().fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Seed;

    fn raster(rows: usize, cols: usize, edges: Edges, connectivity: Connectivity) -> RasterSites {
        let mut grid = Grid::new(Shape::new(rows, cols), [2.0, 2.0]).unwrap();
        grid.edges = edges;
        RasterSites::new(&grid, connectivity).unwrap()
    }

    fn symmetric(sites: &impl Sites) {
        for i in 0..sites.len() {
            for n in sites.neighbours(i) {
                let back = sites.neighbours(n.to).find(|b| b.to == i).expect("a neighbour's neighbour");
                assert!(
                    (back.distance - n.distance).abs() < 1e-12 && (sites.distance(i, n.to) - n.distance).abs() < 1e-9
                );
            }
        }
    }

    #[test]
    fn every_domain_is_a_symmetric_graph_with_true_distances() {
        for connectivity in [Connectivity::Four, Connectivity::Eight, Connectivity::FourEight] {
            symmetric(&raster(6, 8, Edges::default(), connectivity));
            symmetric(&raster(6, 8, Edges::all(Edge::Periodic), connectivity));
        }
        let points = crate::algo::sampling::poisson_disk([60.0, 40.0], 5.0, Seed(1)).unwrap();
        symmetric(&MeshSites::new(&Mesh::delaunay(&points, Edges::default()).unwrap()));
        let lattice = Lattice { periodic: [false, true, false], ..Lattice::new([4, 5, 3], [1.0, 2.0, 3.0]).unwrap() };
        for (voxels, inner) in [(Voxels::Six, 6), (Voxels::Eighteen, 18), (Voxels::TwentySix, 26)] {
            let sites = VoxelSites { lattice, voxels };
            symmetric(&sites);
            assert_eq!(sites.neighbours(lattice.site([1, 1, 1])).count(), inner);
        }
    }

    #[test]
    fn four_and_eight_alternate() {
        let sites = raster(6, 8, Edges::default(), Connectivity::FourEight);
        assert_eq!((sites.neighbours(9).count(), sites.neighbours(10).count()), (8, 4));
        let mut grid = Grid::new(Shape::new(5, 5), [1.0, 1.0]).unwrap();
        grid.edges = Edges::all(Edge::Periodic);
        assert!(RasterSites::new(&grid, Connectivity::FourEight).is_err());
    }

    #[test]
    fn sides_lose_turn_back_or_wrap() {
        let step = |edge| raster(4, 5, Edges::all(edge), Connectivity::Four).step(0, [-4.0, 2.0, 0.0]);
        assert_eq!(step(Edge::Open), None);
        assert_eq!(step(Edge::Closed), Some(1));
        assert_eq!(step(Edge::Periodic), Some(3 * 5 + 3));
        let points = crate::algo::sampling::poisson_disk([60.0, 40.0], 5.0, Seed(1)).unwrap();
        let mesh = Mesh::delaunay(&points, Edges::default()).unwrap();
        let sites = MeshSites::new(&mesh);
        let there = sites.step(0, sites.offset(0, sites.len() - 1)).unwrap();
        assert_eq!(there, sites.len() - 1);
        assert_eq!(sites.step(0, [1e4, 0.0, 0.0]), None);
    }
}
