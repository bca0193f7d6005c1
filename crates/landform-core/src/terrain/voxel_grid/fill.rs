//! Voxels that are full in part.

use super::{EMPTY, VoxelGrid};
use crate::{Error, Result, parallel};

impl VoxelGrid {
    /// Part of each voxel that is solid, 0 to 1, in the order of [`VoxelGrid::field`]; none where
    /// voxels are whole.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, Terrain, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 1), [1.0, 1.0])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 2, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// assert!(rock.fill().is_none());
    /// rock.set_fill(vec![1.0, 0.25])?;
    /// assert_eq!((rock.solids(), rock.volume()), (1, 1.25));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn fill(&self) -> Option<&[f32]> {
        self.fill.as_deref()
    }

    /// Sets how full each voxel is, 0 to 1, in the order of [`VoxelGrid::field`]. What had no
    /// material and is not empty gets the first of the table; one less than half full counts as
    /// empty where only whole voxels do.
    ///
    /// # Errors
    /// [`Error::Shape`] for another number of values; [`Error::Parameter`] for one outside 0 to 1.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 1), [1.0, 1.0])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 1, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// assert!(rock.set_fill(vec![1.5]).is_err());
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn set_fill(&mut self, fill: Vec<f32>) -> Result<()> {
        if fill.len() != self.voxels.len() {
            let (found, expected) = (format!("{} values", fill.len()), self.voxels.len().to_string());
            return Err(Error::Shape { what: "fill".into(), found, expected });
        }
        if let Some(i) = parallel::find_first(fill.len(), |i| !(0.0..=1.0).contains(&fill[i])) {
            return Err(Error::parameter("fill", fill[i], "0 to 1"));
        }
        for (voxel, &part) in self.voxels.iter_mut().zip(&fill) {
            match part > 0.0 {
                true if *voxel == EMPTY => *voxel = 0,
                false => *voxel = EMPTY,
                true => {}
            }
        }
        self.fill = Some(fill);
        Ok(())
    }

    /// Lets voxels be full in part: those that are solid are full.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 1), [1.0, 1.0])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 1, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// rock.make_fillable();
    /// assert_eq!(rock.fill(), Some(&[1.0][..]));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn make_fillable(&mut self) {
        let voxels = &self.voxels;
        self.fill.get_or_insert_with(|| voxels.iter().map(|v| f32::from(u8::from(*v != EMPTY))).collect());
    }

    /// Whether a voxel counts as solid.
    #[inline]
    pub(super) fn is_solid_at(&self, i: usize) -> bool {
        self.voxels[i] != EMPTY && self.fill.as_ref().is_none_or(|fill| fill[i] >= 0.5)
    }

    /// Part of a voxel that is solid.
    #[inline]
    pub(super) fn part(&self, i: usize) -> f32 {
        match &self.fill {
            Some(fill) => fill[i],
            None => f32::from(u8::from(self.voxels[i] != EMPTY)),
        }
    }

    /// Empties a voxel.
    pub(super) fn clear(&mut self, i: usize) {
        self.voxels[i] = EMPTY;
        if let Some(fill) = &mut self.fill {
            fill[i] = 0.0;
        }
    }

    /// How full the ground is at a place, 0 to 1, linear between the middles of voxels; none beside
    /// the columns. Under the lowest level it is as in it, over the uppermost it is empty.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(2, 2), [1.0, 1.0])?;
    /// let rock = VoxelGrid::from_fn(plan, 2, 0.0, 1.0, &Materials::default(), |z, _| (z == 0).then_some(0))?;
    /// assert_eq!(rock.fill_at([0.5, 0.5, 1.0]), Some(0.5));
    /// assert_eq!(rock.fill_at([-5.0, 0.5, 1.0]), None);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn fill_at(&self, place: [f64; 3]) -> Option<f64> {
        let [col, row, level] = self.lattice(place);
        let (cols, rows) = (self.plan.shape.cols, self.plan.shape.rows);
        if !(col >= 0.0 && row >= 0.0 && col <= cols as f64 && row <= rows as f64 && level.is_finite()) {
            return None;
        }
        let between = |at: f64, n: usize| {
            let at = (at - 0.5).clamp(0.0, (n - 1) as f64);
            let first = (at as usize).min(n.saturating_sub(2));
            (first, (first + 1).min(n - 1), (at - first as f64) as f32)
        };
        let (c, r) = (between(col, cols), between(row, rows));
        let sheet = |level: usize| {
            let first = level * cols * rows;
            let line = |row: usize| {
                let (a, b) = (self.part(first + row * cols + c.0), self.part(first + row * cols + c.1));
                a + (b - a) * c.2
            };
            let (a, b) = (line(r.0), line(r.1));
            f64::from(a + (b - a) * r.2)
        };
        let level = level - 0.5;
        if level <= 0.0 {
            return Some(sheet(0));
        }
        let (lower, part) = (level.floor(), level - level.floor());
        let of = |k: f64| if k < self.levels as f64 { sheet(k as usize) } else { 0.0 };
        let (a, b) = (of(lower), of(lower + 1.0));
        Some(a + (b - a) * part)
    }
}
