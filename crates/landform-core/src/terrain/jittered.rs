//! A raster on nodes off the centres of its cells, and back.

use super::{HeightField, Interpolation, NodeSurface, sample_by};
use crate::field::names;
use crate::grid::{Domain, Grid, Jitter, RasterDomain, Status};
use crate::parallel;
use crate::random::Seed;

impl HeightField {
    /// The grid with its nodes off the centres; none if they are already, or the raster is too
    /// narrow.
    fn grid_off_centres(&self, seed: Seed) -> Option<Grid> {
        let regular = self.grid();
        let is_fit = regular.jitter.is_none() && regular.shape.rows >= 3 && regular.shape.cols >= 3;
        is_fit.then(|| Grid { jitter: Some(Jitter { seed }), ..regular.clone() })
    }

    /// The graph of the nodes at places off the centres of their cells, for what runs over the
    /// ground without moving its nodes. None if they stand there already, or the raster has fewer
    /// than three rows or columns.
    ///
    /// ```
    /// use landform_core::grid::{Domain, Grid, Shape};
    /// use landform_core::random::Seed;
    /// use landform_core::terrain::HeightField;
    ///
    /// let flat = HeightField::new(Grid::new(Shape::new(5, 5), [10.0, 10.0])?, vec![1.0; 25])?;
    /// let domain = flat.domain_off_centres(Seed(1)).unwrap();
    /// // The middle's neighbour in the east stands nearer or farther than a cell.
    /// assert!((domain.distance(12, 0) - 10.0).abs() > 0.01);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn domain_off_centres(&self, seed: Seed) -> Option<RasterDomain> {
        let grid = self.grid_off_centres(seed)?;
        let valid: Vec<bool> = (0..grid.len()).map(|i| self.is_valid(i)).collect();
        let mut domain = RasterDomain::new(&grid, &valid);
        domain.set_status(self.domain().status().to_vec());
        Some(domain)
    }

    /// Elevations (m) at the places of [`Self::domain_off_centres`], by smooth curves through the
    /// nodes; those of base levels, nodata and sides stay. **Cost** O(n).
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::random::Seed;
    /// use landform_core::terrain::{HeightField, NodeSurface};
    ///
    /// let grid = Grid::new(Shape::new(9, 9), [10.0, 10.0])?;
    /// let slope = HeightField::new(grid, (0..81).map(|i| f64::from(i % 9)).collect())?;
    /// let there = slope.elevation_off_centres(Seed(1));
    /// // Sides stay; inside a node is as high as the slope is where it stands.
    /// assert!(there[0] == 0.0 && (there[40] - 4.0).abs() <= 0.5);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn elevation_off_centres(&self, seed: Seed) -> Vec<f64> {
        let (domain, regular, old) = (self.domain(), self.grid(), self.elevation());
        let Some(grid) = self.grid_off_centres(seed) else { return old.to_vec() };
        let stays = |i: usize| domain.status()[i] != Status::Interior;
        parallel::map(old.len(), |i| {
            let there = if stays(i) { old[i] } else { sample_by(Interpolation::Cubic, regular, old, grid.position(i)) };
            if there.is_nan() { old[i] } else { there }
        })
    }

    /// Elevations at the jittered places, by smooth curves through the nodes. Base levels, nodata
    /// and sides stay as they are, and so do fields and the depths of layers. **Cost** O(n).
    pub(super) fn off_centres(&self, seed: Seed) -> Option<Self> {
        let grid = self.grid_off_centres(seed)?;
        let new = self.elevation_off_centres(seed);
        let mut field = self.clone();
        field.set_grid(grid).ok()?;
        field.parts_mut().0.copy_from_slice(&new);
        Some(field)
    }

    /// Elevations at the centres of the cells, by planes through the nodes around them; base levels
    /// keep theirs. Lakes keep their level. None if the nodes are there already. **Cost** O(n).
    pub(super) fn on_centres(&self) -> Option<Self> {
        let domain = self.domain();
        let centres = domain.centres()?;
        let old = self.elevation();
        let new = centres.values(old);
        let mut field = self.clone();
        if let Ok(depth) = self.fields.get(&names::LAKE_DEPTH, "lakes") {
            let depth =
                parallel::map(
                    old.len(),
                    |i| {
                        if depth[i] > 0.0 { (old[i] + depth[i] - new[i]).max(0.0) } else { depth[i] }
                    },
                );
            field.fields.insert(&names::LAKE_DEPTH, depth).ok()?;
        }
        field.set_grid(Grid { jitter: None, ..self.grid().clone() }).ok()?;
        field.parts_mut().0.copy_from_slice(&new);
        Some(field)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;
    use crate::terrain::Rasterize;

    #[test]
    fn a_plane_goes_off_the_centres_and_comes_back() {
        let grid = Grid::new(Shape::new(20, 30), [10.0; 2]).unwrap();
        let plane = |[x, y]: [f64; 2]| 100.0 + 0.5 * x - 0.25 * y;
        let z: Vec<f64> = (0..grid.len()).map(|i| plane(grid.position(i))).collect();
        let regular = HeightField::new(grid, z).unwrap();
        let jittered = regular.jittered(Seed(3)).unwrap();
        assert!(jittered.jittered(Seed(3)).is_none());
        assert!((0..600).all(|i| (jittered.elevation()[i] - plane(jittered.position(i))).abs() < 1e-9));
        let moved = (0..600).filter(|&i| (jittered.elevation()[i] - regular.elevation()[i]).abs() > 0.5).count();
        assert!(moved > 300, "{moved}");
        let back = jittered.at_centres();
        assert!((0..600).all(|i| (back.elevation()[i] - regular.elevation()[i]).abs() < 1e-4));
        assert_eq!(back.grid(), regular.grid());
    }
}
