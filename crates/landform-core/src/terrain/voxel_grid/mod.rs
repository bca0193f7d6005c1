//! Ground in voxels: each of one material, or empty. It may have caves, arches and overhangs.
//!
//! A column of voxels stands over each node of a raster. Levels count upwards from the underside.

mod erode;
mod facing;
mod fields;
mod fill;
mod ground;

use serde::{Deserialize, Serialize};

use super::{Bounds, Kind, Materials, Terrain};
use crate::feature::Features;
use crate::grid::{Grid, Shape};
use crate::{Error, Result, parallel};

/// What an empty voxel holds instead of a material's number.
const EMPTY: u8 = u8::MAX;

/// Ground in voxels of one size.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{Materials, Terrain, VoxelGrid};
///
/// let plan = Grid::new(Shape::new(2, 3), [10.0, 10.0])?;
/// // Two levels of 5 m over z = 0; the lower one is rock.
/// let ground = VoxelGrid::from_fn(plan, 2, 0.0, 5.0, &Materials::default(), |level, _| (level == 0).then_some(0))?;
/// assert_eq!(ground.solids(), 6);
/// assert_eq!(ground.volume(), 6.0 * 10.0 * 10.0 * 5.0);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VoxelGrid {
    plan: Grid,
    levels: usize,
    bottom: f64,
    height: f64,
    materials: Materials,
    /// Numbers of materials, level by level from the underside, each in the order of the plan's
    /// nodes.
    voxels: Vec<u8>,
    /// Part of each voxel that is solid, in the order of the voxels; none where voxels are whole.
    #[serde(default)]
    fill: Option<Vec<f32>>,
    /// Named values, each in the order of the voxels.
    #[serde(default)]
    fields: Vec<(String, Vec<f32>)>,
    /// Passages and other features in the ground.
    #[serde(default)]
    features: Features,
}

impl VoxelGrid {
    /// How many voxels its underside and top may lie from z = 0: files of meshes and pictures tell
    /// places apart to a sixteenth of a voxel there.
    ///
    /// ```
    /// // 1048 km for voxels of 1 m.
    /// assert_eq!(landform_core::terrain::VoxelGrid::FARTHEST, 1_048_576.0);
    /// ```
    pub const FARTHEST: f64 = 1_048_576.0;

    /// Refuses elevations so far from z = 0 that voxels of `height` m are lost in rounding.
    ///
    /// # Errors
    /// [`Error::Parameter`] for more than [`VoxelGrid::FARTHEST`] voxels.
    ///
    /// ```
    /// use landform_core::terrain::VoxelGrid;
    ///
    /// assert!(VoxelGrid::check_span(1e5, 20, 1.0).is_ok());
    /// assert!(VoxelGrid::check_span(1e8, 20, 1.0).is_err());
    /// ```
    pub fn check_span(bottom: f64, levels: usize, height: f64) -> Result<()> {
        let far = bottom.abs().max((bottom + levels as f64 * height).abs());
        if far <= Self::FARTHEST * height {
            return Ok(());
        }
        let allowed = format!("at most {} m from z = 0, a million voxels of {height} m", Self::FARTHEST * height);
        Err(Error::parameter("bottom", format!("{bottom:?} m, and the top {far:?} m from z = 0"), &allowed))
    }

    /// Voxels of `height` m in `levels` above the elevation `bottom` (m), one column over each node
    /// of `plan`. `material(level, node)` is the number of a voxel's material in the table; none
    /// where it is empty.
    ///
    /// **Cost** O(voxels).
    ///
    /// # Errors
    /// [`Error::Parameter`] without levels, for a height that is not positive, for elevations of
    /// more than [`VoxelGrid::FARTHEST`] voxels, or for a number that is not in the table.
    pub fn from_fn(
        plan: Grid,
        levels: usize,
        bottom: f64,
        height: f64,
        materials: &Materials,
        material: impl Fn(usize, usize) -> Option<u8> + Sync,
    ) -> Result<Self> {
        if levels == 0 || !(height > 0.0 && height.is_finite() && bottom.is_finite()) {
            let given = format!("{levels} levels of {height} m from {bottom} m");
            return Err(Error::parameter("levels", given, "at least one level of a positive height"));
        }
        Self::check_span(bottom, levels, height)?;
        let nodes = plan.len();
        let Some(count) = nodes.checked_mul(levels).filter(|n| *n < u32::MAX as usize) else {
            return Err(Error::parameter("levels", format!("{levels} over {nodes} nodes"), "fewer than 2^32 voxels"));
        };
        let voxels = parallel::map(count, |i| material(i / nodes, i % nodes).unwrap_or(EMPTY));
        let most = materials.all().len() as u8;
        if let Some(i) = parallel::find_first(count, |i| voxels[i] != EMPTY && voxels[i] >= most) {
            return Err(Error::parameter("material", voxels[i], &format!("a number below {most}")));
        }
        let (fields, features) = (Vec::new(), Features::default());
        Ok(Self { plan, levels, bottom, height, materials: materials.clone(), voxels, fill: None, fields, features })
    }

    /// The raster over whose nodes the columns stand.
    pub fn plan(&self) -> &Grid {
        &self.plan
    }

    /// Number of levels.
    pub fn levels(&self) -> usize {
        self.levels
    }

    /// Elevation of the underside, m.
    pub fn bottom(&self) -> f64 {
        self.bottom
    }

    /// Height of a voxel, m.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// Passages, entrances and other features that a stage found or made.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    /// use landform_core::feature::FeatureKind;
    ///
    /// let plan = Grid::new(Shape::new(2, 2), [1.0; 2])?;
    /// let rock = VoxelGrid::from_fn(plan, 2, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// assert_eq!(rock.features().of(FeatureKind::Conduit).count(), 0);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn features(&self) -> &Features {
        &self.features
    }

    /// Features, to change.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    /// use landform_core::feature::{Feature, FeatureKind, Geometry};
    ///
    /// let plan = Grid::new(Shape::new(2, 2), [1.0; 2])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 2, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// let spring = Feature {
    ///     id: "1".into(),
    ///     kind: FeatureKind::Spring,
    ///     geometry: Geometry::Point([0.0; 3]),
    ///     properties: Vec::new(),
    /// };
    /// rock.features_mut().update(std::iter::once(spring).collect());
    /// assert_eq!(rock.features().of(FeatureKind::Spring).count(), 1);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn features_mut(&mut self) -> &mut Features {
        &mut self.features
    }

    /// The materials that numbers stand for.
    pub fn materials(&self) -> &Materials {
        &self.materials
    }

    /// Volume of a voxel, m³.
    pub fn voxel_volume(&self) -> f64 {
        self.plan.cell_area() * self.height
    }

    /// The number of the material of a voxel; none where it is empty, or less than half full.
    pub fn material(&self, level: usize, node: usize) -> Option<u8> {
        let i = level * self.plan.len() + node;
        self.is_solid_at(i).then(|| self.voxels[i])
    }

    /// How many voxels are not empty, that is at least half full. **Cost** O(voxels).
    pub fn solids(&self) -> usize {
        parallel::map_pieces(self.voxels.len(), |mut r| r.by_ref().filter(|&i| self.is_solid_at(i)).count())
            .iter()
            .sum()
    }

    /// Elevation up to which the uppermost voxel of a column that is not empty is full, m; what is
    /// in one over it that is less than half full lies on it.
    pub fn top(&self, node: usize) -> Option<f64> {
        let level = (0..self.levels).rev().find(|&level| self.material(level, node).is_some())?;
        let i = level * self.plan.len() + node;
        let over = if level + 1 < self.levels { self.part(i + self.plan.len()) } else { 0.0 };
        Some(self.bottom + (level as f64 + f64::from(self.part(i)) + f64::from(over)) * self.height)
    }

    /// The middle of a voxel, m.
    pub fn middle(&self, level: usize, node: usize) -> [f64; 3] {
        let [x, y] = self.plan.position(node);
        [x, y, self.bottom + (level as f64 + 0.5) * self.height]
    }

    /// Empties voxels whose middle lies within `bounds` and `cut` holds for; returns how many were
    /// not empty before.
    ///
    /// **Cost** O(voxels within the bounds).
    pub fn empty(&mut self, bounds: Bounds, cut: impl Fn([f64; 3]) -> bool) -> usize {
        let (first, last) = (self.lattice(bounds.low), self.lattice(bounds.high));
        // Rows run from the north.
        let (first, last) = ([first[0], last[1], first[2]], [last[0], first[1], last[2]]);
        let Shape { rows, cols } = self.plan.shape;
        let within = |k: usize, n: usize| {
            let at = |v: f64| v.floor().clamp(0.0, n as f64) as usize;
            at(first[k])..at(last[k] + 1.0)
        };
        let (cols, rows, mut emptied) = (within(0, cols), within(1, rows), 0);
        for level in within(2, self.levels) {
            for node in rows.clone().flat_map(|row| cols.clone().map(move |col| (row, col))) {
                let node = self.plan.shape.index(node.0, node.1);
                let i = level * self.plan.len() + node;
                if self.part(i) > 0.0 && cut(self.middle(level, node)) {
                    emptied += usize::from(self.is_solid_at(i));
                    self.clear(i);
                }
            }
        }
        emptied
    }
}

/// That no voxel is solid, so that there is no surface.
pub fn nothing_solid() -> Error {
    let hint = "a tunnel may have removed all of it; or give `to_voxels` a greater `depth`";
    Error::Recipe { at: None, what: "no voxel is solid: there is no surface".into(), hint: Some(hint.into()) }
}

impl Terrain for VoxelGrid {
    const KIND: Kind = Kind::VoxelGrid;
    /// A byte a voxel, four for how full it is, and what making its surface takes.
    const BYTES_A_NODE: u64 = 13;

    fn nodes(&self) -> usize {
        self.voxels.len()
    }

    /// Under the underside all is solid, down to z = 0.
    fn volume(&self) -> f64 {
        let solid = match &self.fill {
            None => self.solids() as f64,
            Some(fill) => parallel::sum(fill.len(), |i| f64::from(fill[i])),
        };
        self.plan.cell_area() * self.bottom * self.plan.len() as f64 + solid * self.voxel_volume()
    }

    fn check_finite(&self) -> Result<(), (&'static str, usize)> {
        self.not_finite().map_or(Ok(()), Err)
    }
}
