//! An irregular triangulated terrain: nodes, Delaunay triangles, Voronoi areas.
//!
//! # Method
//! Nodes are numbered along a Hilbert curve before anything else, so that neighbours in space are
//! neighbours in memory and no result depends on the order in which sites were given. A library
//! triangulates; links are read from its half-edges in counter-clockwise order. Cell areas are
//! signed sums over triangles (|ij|²/8 · cot of the opposite angle to both ends): exact Voronoi
//! areas as long as no circumcentre lies outside the hull, and always summing to the hull's area.
//! Where that leaves a node of the border without area, all nodes take a third of their triangles
//! instead. Unsigned areas, as in Bell's thesis (algorithm 1), are wrong wherever a triangle is
//! obtuse.
//!
//! # Sources
//! Bell (thesis), chapter 3; validation notes 2.11 and 2.12 on signed areas and boundary edges;
//! Meyer et al. (2003) for cotangent areas; Skilling (2004) for the Hilbert index.
//!
//! # Checked by
//! `tests::areas_sum_to_the_rectangle`, `tests::numbering_of_the_sites_does_not_matter`.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{Kind, Layers, NodeSurface, Refine, Terrain};
use crate::feature::Features;
use crate::field::Fields;
use crate::grid::{Domain, Edge, Edges, Graph, Links, Neighbours, Status};
use crate::{Error, Result, parallel};

/// Nodes with one elevation each, joined to triangles.
///
/// ```
/// use landform_core::grid::Edges;
/// use landform_core::terrain::Mesh;
///
/// let sites = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
/// let mesh = Mesh::delaunay(&sites, Edges::default())?;
/// assert_eq!(mesh.triangles().len(), 4);
/// assert!((mesh.area() - 100.0).abs() < 1e-9);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mesh {
    positions: Vec<[f64; 2]>,
    elevation: Vec<f64>,
    triangles: Vec<[u32; 3]>,
    graph: Arc<Graph>,
    /// Status by the open sides of the border.
    border: Arc<Vec<Status>>,
    layers: Option<Box<Layers>>,
    features: Features,
    /// Optional fields, in the nodes' order.
    pub fields: Fields,
}

impl Mesh {
    /// The Delaunay mesh of sites, flat at 0 m. `edges` says which sides of the bounding rectangle
    /// are open.
    ///
    /// **Cost** O(n log n).
    ///
    /// # Errors
    /// [`Error::Parameter`] for fewer than three sites, sites that are equal, not finite or all on
    /// a line, and for a node with more than 126 neighbours.
    pub fn delaunay(sites: &[[f64; 2]], edges: Edges) -> Result<Self> {
        if sites.len() < 3 {
            return Err(Error::parameter("nodes", sites.len(), "at least 3"));
        }
        if sites.iter().flatten().any(|v| !v.is_finite()) {
            return Err(Error::parameter("nodes", "a site that is not finite", "finite coordinates"));
        }
        let bounds = bounds_of(sites);
        let positions = hilbert_order(sites, bounds);
        let points: Vec<_> = positions.iter().map(|p| delaunator::Point { x: p[0], y: p[1] }).collect();
        let triangulation = delaunator::triangulate(&points);
        drop(points);
        if triangulation.triangles.is_empty() {
            return Err(Error::parameter("nodes", "sites on one line", "sites that span an area"));
        }
        let graph = build_graph(&positions, &triangulation, bounds, edges)?;
        // delaunator's triangles run clockwise with y up.
        let triangles =
            triangulation.triangles.chunks_exact(3).map(|t| [t[0] as u32, t[2] as u32, t[1] as u32]).collect();
        let elevation = vec![0.0; positions.len()];
        let border = Arc::new(graph.status().to_vec());
        let fields = Fields::sized(elevation.len());
        Ok(Self {
            positions,
            elevation,
            triangles,
            graph: Arc::new(graph),
            border,
            layers: None,
            features: Features::default(),
            fields,
        })
    }

    /// Positions of the nodes, m.
    pub fn positions(&self) -> &[[f64; 2]] {
        &self.positions
    }

    /// Triangles, counter-clockwise seen from above.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    pub(super) fn set_border(&mut self, border: Vec<Status>, status: Vec<Status>) {
        self.border = Arc::new(border);
        self.set_status(Some(status));
    }

    /// The status of every node where it is not what the border says.
    pub fn chosen_status(&self) -> Option<&[Status]> {
        let status = self.graph.status();
        (status != self.border.as_slice()).then_some(status)
    }

    /// The graph of nodes and links.
    pub fn graph(&self) -> &Graph {
        &self.graph
    }
}

fn bounds_of(sites: &[[f64; 2]]) -> [[f64; 2]; 2] {
    sites.iter().fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[lo, hi], p| {
        [[lo[0].min(p[0]), lo[1].min(p[1])], [hi[0].max(p[0]), hi[1].max(p[1])]]
    })
}

/// The sites sorted along a Hilbert curve of 2¹⁶ cells a side, then by coordinates.
fn hilbert_order(sites: &[[f64; 2]], [lo, hi]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    let side = (hi[0] - lo[0]).max(hi[1] - lo[1]).max(f64::MIN_POSITIVE);
    let mut keyed: Vec<(u32, [f64; 2])> = parallel::map(sites.len(), |i| {
        let p = sites[i];
        let cell = |v: f64, lo: f64| ((v - lo) / side * 65_535.0) as u32;
        (hilbert_index(cell(p[0], lo[0]), cell(p[1], lo[1])), p)
    });
    keyed.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1[0].total_cmp(&b.1[0])).then(a.1[1].total_cmp(&b.1[1])));
    keyed.into_iter().map(|k| k.1).collect()
}

/// Distance along the Hilbert curve through a 2¹⁶ × 2¹⁶ lattice.
fn hilbert_index(mut x: u32, mut y: u32) -> u32 {
    let mut index = 0;
    let mut s = 1u32 << 15;
    while s > 0 {
        let (rx, ry) = (u32::from(x & s > 0), u32::from(y & s > 0));
        index = (index << 2) | ((3 * rx) ^ ry);
        if ry == 0 {
            if rx == 1 {
                x ^= 0xffff;
                y ^= 0xffff;
            }
            std::mem::swap(&mut x, &mut y);
        }
        s >>= 1;
    }
    index
}

/// Donors are counted in seven bits.
const MOST_NEIGHBOURS: usize = 126;

const EMPTY: usize = delaunator::EMPTY;

/// Per half-edge: |edge|²-independent weight cot(opposite angle)/2, the Voronoi half-face over the
/// edge's length.
fn half_cotangents(positions: &[[f64; 2]], triangles: &[usize]) -> Vec<f64> {
    parallel::map(triangles.len(), |e| {
        let base = e - e % 3;
        let [a, b, c] =
            [triangles[e], triangles[base + (e + 1) % 3], triangles[base + (e + 2) % 3]].map(|i| positions[i]);
        let (ca, cb) = ([a[0] - c[0], a[1] - c[1]], [b[0] - c[0], b[1] - c[1]]);
        let cross = (ca[0] * cb[1] - ca[1] * cb[0]).abs();
        0.5 * (ca[0] * cb[0] + ca[1] * cb[1]) / cross
    })
}

fn build_graph(
    positions: &[[f64; 2]],
    delaunay: &delaunator::Triangulation,
    bounds: [[f64; 2]; 2],
    edges: Edges,
) -> Result<Graph> {
    let n = positions.len();
    let (triangles, twin) = (&delaunay.triangles, &delaunay.halfedges);
    let cotangent = half_cotangents(positions, triangles);
    // An outgoing half-edge of every node; for hull nodes the one that starts the fan.
    let mut first = vec![EMPTY; n];
    for e in 0..triangles.len() {
        let ends_at = triangles[next(e)];
        if first[ends_at] == EMPTY || twin[e] == EMPTY {
            first[ends_at] = e;
        }
    }
    let mut start = Vec::with_capacity(n + 1);
    let mut links = Links::with_capacity(triangles.len() + n);
    let (mut closed, mut area) = (vec![true; n], vec![0.0; n]);
    start.push(0);
    for node in 0..n {
        let begin = links.len();
        closed[node] = fan(node, first[node], triangles, twin, |to, e| {
            let weight = cotangent[e] + if twin[e] == EMPTY { 0.0 } else { cotangent[twin[e]] };
            let d2 = square_distance(positions[node], positions[to]);
            area[node] += 0.25 * d2 * weight;
            links.push(to as u32, 1.0 / d2.sqrt(), weight);
        });
        let degree = links.len() - begin;
        if degree == 0 {
            let [x, y] = positions[node];
            return Err(Error::parameter("nodes", format!("two sites at ({x}, {y})"), "sites that differ"));
        }
        if degree > MOST_NEIGHBOURS {
            return Err(Error::parameter(
                "nodes",
                format!("a site with {degree} neighbours"),
                &format!("at most {MOST_NEIGHBOURS} neighbours"),
            ));
        }
        // Clockwise from the library; counter-clockwise here.
        links.reverse_from(begin);
        start.push(links.len() as u32);
    }
    let status = (0..n)
        .map(|i| if !closed[i] && is_open(positions[i], bounds, edges) { Status::BaseLevel } else { Status::Interior });
    let status = status.collect();
    drop((cotangent, first));
    if area.iter().any(|a| !(*a > 0.0)) {
        area = thirds(positions, triangles);
    }
    Ok(Graph::new(start, links, closed, area, status))
}

/// A third of the triangles around each node: an area that is positive everywhere and sums to the
/// hull.
fn thirds(positions: &[[f64; 2]], triangles: &[usize]) -> Vec<f64> {
    let mut area = vec![0.0; positions.len()];
    for t in triangles.chunks_exact(3) {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| positions[i]);
        let twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        t.iter().for_each(|&i| area[i] += twice.abs() / 6.0);
    }
    area
}

fn next(e: usize) -> usize {
    if e % 3 == 2 { e - 2 } else { e + 1 }
}

fn square_distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
}

/// Visits the neighbours of `node` in turn, with a half-edge of each link; returns whether they
/// close a full turn.
fn fan(node: usize, first: usize, triangles: &[usize], twin: &[usize], mut visit: impl FnMut(usize, usize)) -> bool {
    if first == EMPTY {
        return false;
    }
    let mut incoming = first;
    loop {
        debug_assert_eq!(triangles[next(incoming)], node);
        visit(triangles[incoming], incoming);
        let outgoing = next(incoming);
        incoming = twin[outgoing];
        if incoming == EMPTY {
            visit(triangles[next(outgoing)], outgoing);
            return false;
        }
        if incoming == first {
            return true;
        }
    }
}

fn is_open([x, y]: [f64; 2], [lo, hi]: [[f64; 2]; 2], edges: Edges) -> bool {
    let near = 1e-9 * (hi[0] - lo[0]).max(hi[1] - lo[1]);
    let sides = [
        ((hi[1] - y).abs() <= near, edges.north),
        ((hi[0] - x).abs() <= near, edges.east),
        ((y - lo[1]).abs() <= near, edges.south),
        ((x - lo[0]).abs() <= near, edges.west),
    ];
    let mut on_rectangle = false;
    for (on, edge) in sides {
        if on && edge == Edge::Open {
            return true;
        }
        on_rectangle |= on;
    }
    !on_rectangle
}

impl Terrain for Mesh {
    const KIND: Kind = Kind::Mesh;
    const BYTES_A_NODE: u64 = 420;

    fn nodes(&self) -> usize {
        self.elevation.len()
    }

    fn volume(&self) -> f64 {
        parallel::sum(self.elevation.len(), |i| self.elevation[i] * self.graph.areas()[i])
    }

    fn check_finite(&self) -> Result<(), (&'static str, usize)> {
        let in_layers = || self.layers.as_ref().and_then(|l| l.find_non_finite());
        match parallel::find_first(self.elevation.len(), |i| !self.elevation[i].is_finite()) {
            Some(i) => Err(("elevation", i)),
            None => in_layers().map_or(Ok(()), |i| Err(("depth of a layer", i))),
        }
    }
}

impl Refine for Mesh {
    fn coarser(&self) -> Option<Self> {
        self.quarter()
    }

    fn take_shape_of(&mut self, coarse: &Self) {
        self.take_from(coarse);
    }

    fn take_change_of(&mut self, before: &Self, after: &Self) {
        self.take_change(before, after);
    }
}

impl NodeSurface for Mesh {
    type Domain = Graph;

    fn domain(&self) -> Arc<Graph> {
        self.graph.clone()
    }

    fn border(&self) -> Vec<Status> {
        self.border.to_vec()
    }

    fn set_status(&mut self, status: Option<Vec<Status>>) {
        Arc::make_mut(&mut self.graph).set_status(status.unwrap_or_else(|| self.border.to_vec()));
    }

    fn elevation(&self) -> &[f64] {
        &self.elevation
    }

    fn layers(&self) -> Option<&Layers> {
        self.layers.as_deref()
    }

    fn parts_mut(&mut self) -> (&mut [f64], &mut Option<Box<Layers>>) {
        (&mut self.elevation, &mut self.layers)
    }

    fn position(&self, node: usize) -> [f64; 2] {
        self.positions[node]
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        bounds_of(&self.positions)
    }

    fn fields(&self) -> &Fields {
        &self.fields
    }

    fn fields_mut(&mut self) -> &mut Fields {
        &mut self.fields
    }

    fn features(&self) -> &Features {
        &self.features
    }

    fn features_mut(&mut self) -> &mut Features {
        &mut self.features
    }
}

impl Mesh {
    /// Total area of the nodes' cells, m².
    pub fn area(&self) -> f64 {
        parallel::sum(self.graph.len(), |i| self.graph.areas()[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algo::sampling::poisson_disk;
    use crate::random::Seed;

    fn sites() -> Vec<[f64; 2]> {
        poisson_disk([1000.0, 700.0], 20.0, Seed(3)).unwrap()
    }

    #[test]
    fn areas_sum_to_the_rectangle() {
        let mesh = Mesh::delaunay(&sites(), Edges::default()).unwrap();
        assert!((mesh.area() / 700_000.0 - 1.0).abs() < 1e-12);
        assert!(mesh.graph().areas().iter().all(|&a| a > 0.0));
    }

    #[test]
    fn the_hull_is_the_rectangle_and_links_lead_back() {
        let mesh = Mesh::delaunay(&sites(), Edges::default()).unwrap();
        let graph = mesh.graph();
        for i in 0..graph.len() {
            let [x, y] = mesh.positions()[i];
            let border = x == 0.0 || x == 1000.0 || y == 0.0 || y == 700.0;
            assert_eq!(graph.status()[i] == Status::BaseLevel, border, "{x} {y}");
            for link in graph.neighbours(i) {
                assert_eq!(graph.neighbour(link.to, graph.slot_back(i, link.slot)), i);
                assert!(graph.conductance(i, link.slot) >= -1e-12);
            }
        }
    }

    #[test]
    fn the_kernel_and_the_arcs_agree() {
        let mesh = Mesh::delaunay(&sites(), Edges::default()).unwrap();
        let graph = mesh.graph();
        let z: Vec<f64> = (0..graph.len()).map(|i| (8.0 * Seed(1).uniform(i as u64)).floor()).collect();
        let mut saddle = vec![0; z.len()];
        graph.saddles(&z, &mut saddle);
        for i in 0..graph.len() {
            let mut arcs = Vec::new();
            graph.lower_arcs(&z, i, 255, |s| arcs.push(s));
            assert_eq!(saddle[i] == 1, arcs.len() > 1 || graph.status()[i] == Status::BaseLevel);
            // An arc's neighbour in the next slot, if lower too, is not the start of another arc.
            let links: Vec<_> = graph.neighbours(i).collect();
            for pair in links.windows(2) {
                assert!(graph.neighbours(pair[0].to).any(|l| l.to == pair[1].to), "consecutive neighbours touch");
            }
        }
    }

    #[test]
    fn numbering_of_the_sites_does_not_matter() {
        let mut shuffled = sites();
        let mut draws = Seed(9).draws();
        for i in (1..shuffled.len()).rev() {
            shuffled.swap(i, draws.below(i + 1));
        }
        assert_eq!(
            Mesh::delaunay(&sites(), Edges::default()).unwrap(),
            Mesh::delaunay(&shuffled, Edges::default()).unwrap()
        );
    }

    #[test]
    fn areas_are_positive_even_with_a_ragged_border() {
        let ragged: Vec<[f64; 2]> = (0..300).map(|i| [Seed(3).uniform(2 * i), Seed(3).uniform(2 * i + 1)]).collect();
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let mesh = Mesh::delaunay(&[&ragged[..], &corners].concat(), Edges::default()).unwrap();
        assert!(mesh.graph().areas().iter().all(|a| *a > 0.0));
        assert!((mesh.graph().areas().iter().sum::<f64>() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn bad_sites_are_refused() {
        let edges = Edges::default();
        assert!(Mesh::delaunay(&[[0.0, 0.0], [1.0, 0.0]], edges).is_err());
        assert!(Mesh::delaunay(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]], edges).is_err());
        assert!(Mesh::delaunay(&[[0.0, 0.0], [1.0, 0.0], [f64::NAN, 0.0]], edges).is_err());
        let twice = Mesh::delaunay(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 0.0]], edges);
        assert!(twice.unwrap_err().to_string().contains("two sites at"));
    }

    #[test]
    fn triangles_are_counter_clockwise() {
        let mesh = Mesh::delaunay(&sites(), Edges::default()).unwrap();
        for t in mesh.triangles() {
            let [a, b, c] = t.map(|i| mesh.positions()[i as usize]);
            assert!((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0);
        }
    }
}
