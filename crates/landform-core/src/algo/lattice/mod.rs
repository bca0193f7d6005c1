//! Algorithms on a box of voxels, each with 26 neighbours: shortest paths, maximum flow, thinning,
//! components and Euler's number.
//!
//! Values stand in arrays with a border of one voxel all around, so that the neighbours of any
//! voxel of the box lie at fixed offsets and nobody asks where the box ends.
//!
//! ```
//! use landform_core::algo::lattice::Lattice;
//!
//! let lattice = Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
//! assert_eq!((lattice.voxels().count(), lattice.stored()), (24, 6 * 5 * 4));
//! let corner = lattice.at([0, 0, 0]);
//! assert_eq!(lattice.place(corner), [0, 0, 0]);
//! assert_eq!(lattice.neighbours(corner).filter(|&i| lattice.is_inside(i)).count(), 7);
//! ```

mod max_flow;
mod paths;
mod thinning;
mod topology;

pub use max_flow::MaxFlow;
pub use paths::lower;
pub use thinning::{Thinning, thin};
pub use topology::{Topology, components, topology};

use crate::terrain::VoxelGrid;

/// Neighbours of a voxel.
///
/// ```
/// assert_eq!(landform_core::algo::lattice::NEIGHBOURS, 26);
/// ```
pub const NEIGHBOURS: usize = 26;

/// Numbers of the neighbours over faces: down and up, then back and on along y and along x.
///
/// ```
/// use landform_core::algo::lattice::{FACES, Lattice};
///
/// let cube = Lattice::new([3, 3, 3], [1.0; 3]);
/// assert_eq!(cube.neighbour(cube.at([1, 1, 1]), FACES[1]), cube.at([1, 1, 2]));
/// ```
pub const FACES: [usize; 6] = [4, 21, 10, 15, 12, 13];

/// A box of voxels, stored with a border of one voxel.
///
/// Neighbours are numbered in the order of their indices, 0 to 25; those of numbers k and 25 − k
/// lie opposite each other.
///
/// ```
/// use landform_core::algo::lattice::Lattice;
///
/// let cube = Lattice::new([3, 3, 3], [1.0; 3]);
/// let middle = cube.at([1, 1, 1]);
/// assert_eq!(cube.neighbour(cube.neighbour(middle, 4), 25 - 4), middle);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Lattice {
    /// Voxels along x (or columns), y (or rows) and z (levels).
    size: [usize; 3],
    /// Sides of a voxel, m.
    sides: [f64; 3],
    offsets: [isize; NEIGHBOURS],
    /// Steps along the axes to each neighbour, -1 to 1.
    steps: [[i8; 3]; NEIGHBOURS],
    lengths: [f64; NEIGHBOURS],
}

impl Lattice {
    /// A box of `size` voxels whose sides are `sides` metres.
    ///
    /// ```
    /// use landform_core::algo::lattice::Lattice;
    ///
    /// assert_eq!(Lattice::new([2, 2, 2], [1.0; 3]).voxels().count(), 8);
    /// ```
    pub fn new(size: [usize; 3], sides: [f64; 3]) -> Self {
        let [nx, ny, _] = size.map(|n| (n + 2) as isize);
        let all = (-1..=1).flat_map(|z: i8| (-1..=1).flat_map(move |y: i8| (-1..=1).map(move |x: i8| [x, y, z])));
        let mut steps = [[0; 3]; NEIGHBOURS];
        all.filter(|s| *s != [0; 3]).zip(&mut steps).for_each(|(from, to)| *to = from);
        let offsets = steps.map(|[x, y, z]| (isize::from(z) * ny + isize::from(y)) * nx + isize::from(x));
        let lengths =
            steps.map(|s| (0..3).map(|k| f64::from(s[k]) * f64::from(s[k]) * sides[k] * sides[k]).sum::<f64>().sqrt());
        Self { size, sides, offsets, steps, lengths }
    }

    /// The box of the voxels of some ground: columns along x, rows from the north along y, levels
    /// along z. Its voxels are in the order of the ground's.
    ///
    /// ```
    /// use landform_core::algo::lattice::Lattice;
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(2, 3), [5.0, 5.0])?;
    /// let ground = VoxelGrid::from_fn(plan, 4, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// let lattice = Lattice::over(&ground);
    /// assert_eq!((lattice.size(), lattice.sides()), ([3, 2, 4], [5.0, 5.0, 1.0]));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn over(ground: &VoxelGrid) -> Self {
        let (shape, [dx, dy]) = (ground.plan().shape, ground.plan().spacing);
        Self::new([shape.cols, shape.rows, ground.levels()], [dx, dy, ground.height()])
    }

    /// The middle of a voxel of the ground that the box was made of, m.
    ///
    /// ```
    /// use landform_core::algo::lattice::Lattice;
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(2, 3), [5.0, 5.0])?;
    /// let ground = VoxelGrid::from_fn(plan, 4, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// let lattice = Lattice::over(&ground);
    /// assert_eq!(lattice.middle(&ground, lattice.at([1, 0, 0])), [5.0, 5.0, 0.5]);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn middle(&self, ground: &VoxelGrid, i: usize) -> [f64; 3] {
        let [x, y, z] = self.place(i);
        ground.middle(z, ground.plan().shape.index(y, x))
    }

    /// Voxels along each axis.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert_eq!(lattice.size(), [4, 3, 2]);
    /// ```
    pub fn size(&self) -> [usize; 3] {
        self.size
    }

    /// Sides of a voxel, m.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert_eq!(lattice.sides(), [1.0, 1.0, 0.5]);
    /// ```
    pub fn sides(&self) -> [f64; 3] {
        self.sides
    }

    /// How many values an array of the box has, those of its border included.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert_eq!(lattice.stored(), 6 * 5 * 4);
    /// ```
    pub fn stored(&self) -> usize {
        self.size.iter().map(|n| n + 2).product()
    }

    /// Where the value of a voxel is stored.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert_eq!(lattice.at([1, 0, 0]), lattice.at([0, 0, 0]) + 1);
    /// ```
    #[inline]
    pub fn at(&self, [x, y, z]: [usize; 3]) -> usize {
        ((z + 1) * (self.size[1] + 2) + y + 1) * (self.size[0] + 2) + x + 1
    }

    /// The voxel whose value is stored at `i`. The border has numbers beyond those of the box.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert_eq!(lattice.place(lattice.at([3, 2, 1])), [3, 2, 1]);
    /// ```
    #[inline]
    pub fn place(&self, i: usize) -> [usize; 3] {
        let [nx, ny] = [self.size[0] + 2, self.size[1] + 2];
        [i % nx, i / nx % ny, i / (nx * ny)].map(|v| v.wrapping_sub(1))
    }

    /// Whether a voxel lies in the box, not in its border.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert!(lattice.is_inside(lattice.at([3, 2, 1])) && !lattice.is_inside(0));
    /// ```
    #[inline]
    pub fn is_inside(&self, i: usize) -> bool {
        let place = self.place(i);
        (0..3).all(|k| place[k] < self.size[k])
    }

    /// Where the values of all voxels are stored: x runs fastest, then y, then z.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert_eq!(lattice.voxels().next(), Some(lattice.at([0; 3])));
    /// assert_eq!(lattice.voxels().count(), 24);
    /// ```
    pub fn voxels(&self) -> impl Iterator<Item = usize> + '_ {
        let [nx, ny, nz] = self.size;
        (0..nz).flat_map(move |z| {
            (0..ny).flat_map(move |y| {
                let first = self.at([0, y, z]);
                first..first + nx
            })
        })
    }

    /// The 26 neighbours of a voxel, those in the border included.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert_eq!(lattice.neighbours(lattice.at([1, 1, 1])).count(), 26);
    /// ```
    #[inline]
    pub fn neighbours(&self, i: usize) -> impl Iterator<Item = usize> + '_ {
        self.offsets.iter().map(move |o| i.wrapping_add_signed(*o))
    }

    /// The neighbour of a number.
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// let i = lattice.at([1, 1, 0]);
    /// assert_eq!(lattice.neighbour(i, 13), lattice.at([2, 1, 0]));
    /// ```
    #[inline]
    pub fn neighbour(&self, i: usize, k: usize) -> usize {
        i.wrapping_add_signed(self.offsets[k])
    }

    /// Distance to the neighbour of a number, m.
    pub(crate) fn length(&self, k: usize) -> f64 {
        self.lengths[k]
    }

    /// Steps along the axes to the neighbour of a number.
    pub(crate) fn step(&self, k: usize) -> [i8; 3] {
        self.steps[k]
    }

    /// An array with a value for each voxel and `border` around them, from values in the order of
    /// [`Lattice::voxels`].
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// let stored = lattice.padded(0..24, -1);
    /// assert_eq!((stored[0], stored[lattice.at([1, 0, 0])]), (-1, 1));
    /// ```
    pub fn padded<T: Copy>(&self, values: impl Iterator<Item = T>, border: T) -> Vec<T> {
        let mut out = vec![border; self.stored()];
        self.voxels().zip(values).for_each(|(i, value)| out[i] = value);
        out
    }

    /// The values of the voxels alone, in the order of [`Lattice::voxels`].
    ///
    /// ```
    /// let lattice = landform_core::algo::lattice::Lattice::new([4, 3, 2], [1.0, 1.0, 0.5]);
    /// assert_eq!(lattice.unpadded(&lattice.padded(0..24, -1)).len(), 24);
    /// ```
    pub fn unpadded<T: Copy>(&self, stored: &[T]) -> Vec<T> {
        self.voxels().map(|i| stored[i]).collect()
    }
}
