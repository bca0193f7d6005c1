//! The surface of voxels: closed, every edge used twice, no vertex that two parts of the surface
//! share.
//!
//! # Method
//! Each face between a solid voxel and an empty one is a quadrilateral. Where two solid voxels
//! touch along an edge alone, the surface keeps them apart: rock hangs together over faces, voids
//! over corners too. Faces are joined over their edges by this rule; the corners that meet at a
//! point of the lattice without being joined get vertices of their own. Where two edges still have
//! the same ends, a vertex in the middle of each parts them.
//!
//! The same faces are those of manifold surface nets (Gibson 1998; Schaefer, Ju & Warren 2007):
//! a cell between eight voxels has a vertex for each part of the surface in it, in the mean of the
//! places where that part crosses the ways between voxels ([`Quads::nets`]).
//!
//! # Checked by
//! `tests`: edges, fans of faces around vertices and the enclosed volume on random voxels and on
//! voxels that touch at edges and corners; edges of nets told by places alone, as files have them.

use std::collections::BTreeMap;

use super::disjoint_sets::DisjointSets;

/// Quadrilaterals on the lattice of voxels' corners.
#[derive(Clone, Debug, PartialEq)]
pub struct Quads {
    /// Places on the lattice of corners.
    pub vertices: Vec<[u32; 3]>,
    /// Corners of each face, counter-clockwise seen from outside.
    pub faces: Vec<[u32; 4]>,
    /// Ends of edges that have a vertex in their middle; these follow the other vertices.
    middles: Vec<[u32; 2]>,
    /// The middle on a side of a face, by face and side.
    split: BTreeMap<(u32, u8), u32>,
}

impl Quads {
    /// Places of all vertices, m, those in the middle of edges included, from places of the first
    /// ones.
    pub fn points(&self, mut places: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
        let middles = self.middles.iter().map(|ends| {
            let [a, b] = ends.map(|v| places[v as usize]);
            [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]))
        });
        let middles: Vec<_> = middles.collect();
        places.extend(middles);
        places
    }

    /// Places of the vertices, middles excepted, as surface nets: each in the mean of the middles
    /// of its faces, in voxels. Parts that touch along an edge lie apart then.
    ///
    /// ```
    /// use landform_core::algo::polygonise::polygonise;
    ///
    /// // The corners of a cube move towards its middle; those of a wall stay in it.
    /// let cube = polygonise([1, 1, 1], |_| true);
    /// assert!(cube.nets().iter().all(|p| p.iter().all(|v| (v - 0.5).abs() < 0.17)));
    /// ```
    pub fn nets(&self) -> Vec<[f64; 3]> {
        let home: Vec<[f64; 3]> = self.vertices.iter().map(|v| v.map(f64::from)).collect();
        let mut sums = vec![([0.0; 3], 0.0); home.len()];
        for face in &self.faces {
            let middle = middle_of(face, &home);
            for v in face {
                let (sum, count) = &mut sums[*v as usize];
                (0..3).for_each(|k| sum[k] += middle[k]);
                *count += 1.0;
            }
        }
        sums.into_iter().map(|(sum, count)| sum.map(|v| v / count)).collect()
    }

    /// Places of all vertices (in voxels), as [`Quads::points`], of a surface whose vertices have
    /// moved off the corners: those in the middle of edges lie towards their own faces, so that two
    /// edges with the same ends are apart.
    ///
    /// ```
    /// use landform_core::algo::polygonise::polygonise;
    ///
    /// let cube = polygonise([1, 1, 1], |_| true);
    /// assert_eq!(cube.points_apart(cube.nets()).len(), 8);
    /// ```
    pub fn points_apart(&self, places: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
        let mut beside = vec![([0.0; 3], 0.0); self.middles.len()];
        for (&(face, _), &middle) in &self.split {
            let (sum, count) = &mut beside[middle as usize - self.vertices.len()];
            let of_face = middle_of(&self.faces[face as usize], &places);
            (0..3).for_each(|k| sum[k] += of_face[k]);
            *count += 1.0;
        }
        let mut points = self.points(places);
        for (point, (sum, count)) in points[self.vertices.len()..].iter_mut().zip(beside) {
            *point = [0, 1, 2].map(|k| 0.5 * (point[k] + sum[k] / count));
        }
        points
    }

    /// The faces as triangles.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = Vec::with_capacity(2 * self.faces.len());
        for (f, face) in self.faces.iter().enumerate() {
            let (mut corners, mut from) = (Vec::with_capacity(8), 0);
            for side in 0..4 {
                corners.push(face[side]);
                if let Some(middle) = self.split.get(&(f as u32, side as u8)) {
                    // A fan from a middle has no triangle without area.
                    from = corners.len();
                    corners.push(*middle);
                }
            }
            let n = corners.len();
            let at = |k: usize| corners[(from + k) % n];
            triangles.extend((1..n - 1).map(|k| [at(0), at(k), at(k + 1)]));
        }
        triangles
    }
}

/// The mean of the corners of a face.
fn middle_of(face: &[u32; 4], places: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|k| face.iter().map(|v| places[*v as usize][k]).sum::<f64>() / 4.0)
}

/// The surface of the solid voxels of a box; beyond it all is empty. Axes are right-handed.
///
/// **Cost** O(voxels) time; 6 bytes a voxel and 50 a face.
///
/// ```
/// use landform_core::algo::polygonise::polygonise;
///
/// let cube = polygonise([1, 1, 1], |_| true);
/// assert_eq!((cube.vertices.len(), cube.faces.len(), cube.triangles().len()), (8, 6, 12));
/// ```
pub fn polygonise(size: [usize; 3], is_solid: impl Fn([usize; 3]) -> bool) -> Quads {
    let surface = Surface::new(size, is_solid);
    let mut corners = DisjointSets::new(4 * surface.faces.len());
    for (f, &(voxel, way)) in surface.faces.iter().enumerate() {
        for side in 0..4 {
            let g = surface.across(voxel, way, side);
            // The way back joins the same corners.
            if g < f {
                continue;
            }
            for corner in [side, (side + 1) % 4] {
                let at = corner_of(voxel, way, corner);
                let (to, to_way) = surface.faces[g];
                if let Some(other) = (0..4).find(|&c| corner_of(to, to_way, c) == at) {
                    corners.join((4 * f + corner) as u32, (4 * g + other) as u32);
                }
            }
        }
    }
    let (mut number, mut vertices) = (vec![u32::MAX; 4 * surface.faces.len()], Vec::new());
    let mut vertex = |f: usize, corner: usize| {
        let root = corners.root((4 * f + corner) as u32) as usize;
        if number[root] == u32::MAX {
            number[root] = vertices.len() as u32;
            let (voxel, way) = surface.faces[f];
            vertices.push(corner_of(voxel, way, corner).map(|v| v as u32));
        }
        number[root]
    };
    let faces = (0..surface.faces.len()).map(|f| [0, 1, 2, 3].map(|corner| vertex(f, corner))).collect();
    let mut quads = Quads { vertices, faces, middles: Vec::new(), split: BTreeMap::new() };
    split_doubles(&surface, &mut quads);
    quads
}

/// Parts edges that have the same ends. They lie where two solid voxels touch along an edge alone.
fn split_doubles(surface: &Surface, quads: &mut Quads) {
    let mut sides: BTreeMap<[u32; 2], Vec<(u32, u8)>> = BTreeMap::new();
    for (f, &(voxel, way)) in surface.faces.iter().enumerate() {
        for side in (0..4).filter(|&side| surface.touches(voxel, way, side)) {
            let [a, b] = [quads.faces[f][side], quads.faces[f][(side + 1) % 4]];
            sides.entry([a.min(b), a.max(b)]).or_default().push((f as u32, side as u8));
        }
    }
    for (ends, sides) in sides.into_iter().filter(|(_, sides)| sides.len() > 2) {
        for &(f, side) in &sides {
            let (voxel, way) = surface.faces[f as usize];
            let g = surface.across(voxel, way, side as usize) as u32;
            let middle = match sides.iter().find(|s| s.0 == g && g < f).and_then(|s| quads.split.get(s)) {
                Some(middle) => *middle,
                None => {
                    quads.middles.push(ends);
                    (quads.vertices.len() + quads.middles.len() - 1) as u32
                }
            };
            quads.split.insert((f, side), middle);
        }
    }
}

/// Which way a face looks: axis, and whether upwards along it.
type Way = (usize, bool);

const WAYS: [Way; 6] = [(0, false), (0, true), (1, false), (1, true), (2, false), (2, true)];

/// The other two axes of a face in the order in which its corners turn.
fn plane((axis, up): Way) -> [usize; 2] {
    let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
    if up { [b, c] } else { [c, b] }
}

/// A corner of a face, 0 to 3, on the lattice.
fn corner_of(voxel: [usize; 3], way: Way, corner: usize) -> [usize; 3] {
    let [b, c] = plane(way);
    let mut at = voxel;
    at[way.0] += usize::from(way.1);
    at[b] += usize::from(corner == 1 || corner == 2);
    at[c] += usize::from(corner >= 2);
    at
}

/// The way from a face over its side, between the corners `side` and `side` + 1.
fn outwards(way: Way, side: usize) -> Way {
    let [b, c] = plane(way);
    [(c, false), (b, true), (c, true), (b, false)][side]
}

struct Surface {
    size: [usize; 3],
    /// Ways in which a voxel has faces, a bit each.
    ways: Vec<u8>,
    /// The first face of each voxel.
    first: Vec<u32>,
    faces: Vec<([usize; 3], Way)>,
    solid: Vec<bool>,
}

impl Surface {
    fn new(size: [usize; 3], is_solid: impl Fn([usize; 3]) -> bool) -> Self {
        let place = |i: usize| [i % size[0], i / size[0] % size[1], i / (size[0] * size[1])];
        let count = size.iter().product();
        let solid: Vec<bool> = (0..count).map(|i| is_solid(place(i))).collect();
        let mut surface = Self { size, ways: vec![0; count], first: vec![0; count], faces: Vec::new(), solid };
        for i in 0..count {
            surface.first[i] = surface.faces.len() as u32;
            for (k, way) in WAYS.into_iter().enumerate().filter(|_| surface.solid[i]) {
                if !surface.next(place(i), way).is_some_and(|to| surface.is_solid(to)) {
                    surface.ways[i] |= 1 << k;
                    surface.faces.push((place(i), way));
                }
            }
        }
        surface
    }

    fn index(&self, at: [usize; 3]) -> usize {
        (at[2] * self.size[1] + at[1]) * self.size[0] + at[0]
    }

    fn is_solid(&self, at: [usize; 3]) -> bool {
        self.solid[self.index(at)]
    }

    /// The voxel beside one; none beyond the box.
    fn next(&self, at: [usize; 3], (axis, up): Way) -> Option<[usize; 3]> {
        let mut to = at;
        to[axis] = if up { at[axis] + 1 } else { at[axis].wrapping_sub(1) };
        (to[axis] < self.size[axis]).then_some(to)
    }

    fn face(&self, voxel: [usize; 3], way: Way) -> usize {
        let (i, k) = (self.index(voxel), 2 * way.0 + usize::from(way.1));
        self.first[i] as usize + (self.ways[i] & ((1 << k) - 1)).count_ones() as usize
    }

    /// Whether the voxel of a face touches another along a side of the face alone.
    fn touches(&self, voxel: [usize; 3], way: Way, side: usize) -> bool {
        let beside = self.next(voxel, outwards(way, side)).filter(|to| !self.is_solid(*to));
        beside.and_then(|to| self.next(to, way)).is_some_and(|to| self.is_solid(to))
    }

    /// The face that a face is joined to over a side.
    fn across(&self, voxel: [usize; 3], way: Way, side: usize) -> usize {
        let out = outwards(way, side);
        let beside = self.next(voxel, out).filter(|to| self.is_solid(*to));
        let Some(beside) = beside else {
            // A ridge; so too where the voxel over the edge is solid, which is kept apart.
            return self.face(voxel, out);
        };
        match self.next(beside, way).filter(|to| self.is_solid(*to)) {
            // A groove: the wall looks back.
            Some(wall) => self.face(wall, (out.0, !out.1)),
            None => self.face(beside, way),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::random::Seed;

    /// Checks that the surface is closed and simple; returns the volume that it encloses, in
    /// voxels.
    fn enclosed(quads: &Quads) -> f64 {
        let triangles = quads.triangles();
        let mut edges = BTreeSet::new();
        // Around a vertex: from each neighbour to the next over a face, in one ring.
        let mut rings: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
        for [a, b, c] in &triangles {
            for [a, b, c] in [[a, b, c], [b, c, a], [c, a, b]] {
                assert!(edges.insert((*a, *b)), "an edge is used twice in one direction");
                rings.entry(*a).or_default().insert(*b, *c);
            }
        }
        assert!(edges.iter().all(|&(a, b)| edges.contains(&(b, a))), "the surface is open");
        for ring in rings.values() {
            let first = *ring.keys().next().unwrap();
            let (mut at, mut steps) = (first, 0);
            loop {
                (at, steps) = (ring[&at], steps + 1);
                if at == first {
                    break;
                }
            }
            assert_eq!(steps, ring.len(), "two parts of the surface share a vertex");
        }
        let points = quads.points(quads.vertices.iter().map(|v| v.map(f64::from)).collect());
        let six = |[a, b, c]: [[f64; 3]; 3]| {
            let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            (0..3).map(|k| a[k] * cross[k]).sum::<f64>()
        };
        triangles.iter().map(|t| six(t.map(|v| points[v as usize]))).sum::<f64>() / 6.0
    }

    #[test]
    fn surfaces_are_closed_simple_and_enclose_the_voxels() {
        for share in [0.1, 0.35, 0.5, 0.8] {
            let size = [9, 7, 8];
            let solid = |[x, y, z]: [usize; 3]| Seed(4).uniform(((z * 7 + y) * 9 + x) as u64) < share;
            let count = (0..9 * 7 * 8).filter(|i| solid([i % 9, i / 9 % 7, i / 63])).count();
            let found = enclosed(&polygonise(size, solid));
            assert!((found - count as f64).abs() < 1e-9, "{found} {count}");
        }
    }

    #[test]
    fn voxels_that_touch_at_an_edge_or_a_corner_are_apart() {
        for other in [[1, 1, 0], [1, 1, 1]] {
            let quads = polygonise([2, 2, 2], |at| at == [0, 0, 0] || at == other);
            assert_eq!((quads.vertices.len(), quads.faces.len()), (16, 12));
            assert!((enclosed(&quads) - 2.0).abs() < 1e-12);
        }
        // A void at two corners of a block: Euler's number tells one surface with a handle from
        // two.
        let quads = polygonise([3, 3, 3], |at| at != [1, 1, 1]);
        assert!((enclosed(&quads) - 26.0).abs() < 1e-12);
        assert_eq!(quads.vertices.len() as i64 - quads.faces.len() as i64, 4, "V - E + F of two spheres, with E = 2 F");
    }

    #[test]
    fn nets_have_two_triangles_at_every_edge_though_files_tell_points_by_their_place() {
        for share in [0.1, 0.35, 0.5, 0.8] {
            let solid = |[x, y, z]: [usize; 3]| Seed(7).uniform(((z * 7 + y) * 9 + x) as u64) < share;
            let quads = polygonise([9, 7, 8], solid);
            let points = quads.points_apart(quads.nets());
            assert!(enclosed(&quads) > 0.0);
            let bits = |v: u32| points[v as usize].map(|c| (c as f32).to_bits());
            let mut edges = BTreeMap::new();
            for t in quads.triangles() {
                for [a, b] in [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]] {
                    *edges.entry([bits(a).min(bits(b)), bits(a).max(bits(b))]).or_insert(0) += 1;
                }
            }
            assert!(edges.values().all(|n| *n == 2), "{share}");
        }
    }

    #[test]
    fn an_empty_box_has_no_surface() {
        assert!(polygonise([3, 0, 2], |_| true).faces.is_empty());
        assert!(polygonise([3, 2, 2], |_| false).vertices.is_empty());
    }
}
