//! Named values of voxels: porosity, permeability, solubility, pressure.

use super::VoxelGrid;
use crate::{Error, Result, parallel};

impl VoxelGrid {
    /// Name of the part of a voxel's volume that is open, 0 to 1.
    ///
    /// ```
    /// assert_eq!(landform_core::terrain::VoxelGrid::POROSITY, "porosity");
    /// ```
    pub const POROSITY: &'static str = "porosity";
    /// Name of the permeability over that of plain rock.
    ///
    /// ```
    /// assert_eq!(landform_core::terrain::VoxelGrid::PERMEABILITY, "permeability");
    /// ```
    pub const PERMEABILITY: &'static str = "permeability";
    /// Name of how readily water dissolves a voxel, 0 to 1.
    ///
    /// ```
    /// assert_eq!(landform_core::terrain::VoxelGrid::SOLUBILITY, "solubility");
    /// ```
    pub const SOLUBILITY: &'static str = "solubility";
    /// Name of the pressure of water, in the unit of the inlets.
    ///
    /// ```
    /// assert_eq!(landform_core::terrain::VoxelGrid::PRESSURE, "pressure");
    /// ```
    pub const PRESSURE: &'static str = "pressure";

    /// The values of a field, a number a voxel, level by level from the underside, each in the
    /// order of the plan's nodes; none if there is no such field.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 2), [1.0, 1.0])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 1, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// rock.set_field(VoxelGrid::POROSITY, vec![0.05, 0.1])?;
    /// assert_eq!(rock.field("porosity"), Some(&[0.05, 0.1][..]));
    /// assert_eq!(rock.field("pressure"), None);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn field(&self, name: &str) -> Option<&[f32]> {
        self.fields.iter().find(|f| f.0 == name).map(|f| f.1.as_slice())
    }

    /// The values of a field, a number a voxel.
    ///
    /// # Errors
    /// [`Error::MissingField`], naming `needed_by` and what there is.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 2), [1.0, 1.0])?;
    /// let rock = VoxelGrid::from_fn(plan, 1, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// let error = rock.need_field("porosity", "`cave`").unwrap_err();
    /// assert_eq!(error.to_string(), "field `porosity` is missing; `cave` needs it");
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn need_field(&self, name: &str, needed_by: &str) -> Result<&[f32]> {
        self.field(name).ok_or_else(|| Error::MissingField {
            name: name.into(),
            needed_by: needed_by.into(),
            available: self.field_names().map(String::from).collect(),
        })
    }

    /// Names of the fields, in the order in which they were made.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 1), [1.0, 1.0])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 1, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// rock.set_field("age", vec![3.0])?;
    /// assert_eq!(rock.field_names().collect::<Vec<_>>(), ["age"]);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn field_names(&self) -> impl Iterator<Item = &str> {
        self.fields.iter().map(|f| f.0.as_str())
    }

    /// Sets a field, a number a voxel in the order of [`VoxelGrid::field`].
    ///
    /// # Errors
    /// [`Error::Shape`] for another number of values.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 2), [1.0, 1.0])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 1, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// assert!(rock.set_field("porosity", vec![0.1]).is_err(), "there are two voxels");
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn set_field(&mut self, name: &str, values: Vec<f32>) -> Result<()> {
        if values.len() != self.voxels.len() {
            let (found, expected) = (format!("{} values", values.len()), self.voxels.len().to_string());
            return Err(Error::Shape { what: format!("field {name}"), found, expected });
        }
        match self.fields.iter_mut().find(|f| f.0 == name) {
            Some(field) => field.1 = values,
            None => self.fields.push((name.into(), values)),
        }
        Ok(())
    }

    /// Empties the voxels that a rule picks by their place in the order of [`VoxelGrid::field`];
    /// returns how many were not empty before.
    ///
    /// **Cost** O(voxels).
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 4), [1.0, 1.0])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 1, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// assert_eq!((rock.empty_where(|i| i > 1), rock.solids()), (2, 2));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn empty_where(&mut self, is_open: impl Fn(usize) -> bool) -> usize {
        let mut emptied = 0;
        for i in 0..self.voxels.len() {
            if self.voxels[i] != super::EMPTY && is_open(i) {
                self.clear(i);
                emptied += 1;
            }
        }
        emptied
    }

    /// The first field with a number that is NaN or infinite.
    pub(super) fn not_finite(&self) -> Option<(&'static str, usize)> {
        let bad = |values: &[f32]| parallel::find_first(values.len(), |i| !values[i].is_finite());
        self.fields.iter().find_map(|f| bad(&f.1)).map(|i| ("a field of voxels", i))
    }
}
