//! Solid that is removed from and deposited on the ground around a point.

use super::{Ground, Layers, Materials, NodeSurface};
use crate::Result;
use crate::grid::Domain;

/// Where a brush works: a ball of influence that fades to nothing at its radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Brush {
    /// Middle, m.
    pub at: [f64; 3],
    /// Radius, m.
    pub radius: f64,
}

/// Volume that a brush moved.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Removed {
    /// Volume, m³.
    pub volume: f64,
    /// The same by material: name and volume, m³. One entry, "rock", on ground without layers.
    pub by_material: Vec<(String, f64)>,
}

/// A terrain from which solid can be removed, and on which it can be deposited, around a point.
pub trait Erodible: Ground {
    /// The table of its materials; none where it is all one rock.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Erodible, HeightField};
    ///
    /// let plain = HeightField::new(Grid::new(Shape::new(3, 3), [10.0; 2])?, vec![50.0; 9])?;
    /// assert!(plain.table().is_none());
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn table(&self) -> Option<&Materials>;

    /// Lets the ground give and take less than its smallest piece, where it can: voxels that are
    /// full in part.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Erodible, Materials, VoxelGrid};
    ///
    /// let plan = Grid::new(Shape::new(1, 1), [1.0, 1.0])?;
    /// let mut rock = VoxelGrid::from_fn(plan, 1, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
    /// rock.make_divisible();
    /// assert_eq!(rock.fill(), Some(&[1.0][..]));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn make_divisible(&mut self) {}

    /// The number of the material at the surface beside a place, m; 0 where there is no table.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Erodible, HeightField, NodeSurface};
    ///
    /// let mut plain = HeightField::new(Grid::new(Shape::new(1, 2), [10.0; 2])?, vec![50.0; 2])?;
    /// plain.change_depth("sand", &[2.0, 0.0])?;
    /// let sand = plain.table().and_then(|table| table.find("sand"));
    /// assert_eq!(Some(plain.material_at([0.0, 0.0, 52.0])), sand);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn material_at(&self, place: [f64; 3]) -> u8;

    /// Removes up to a volume (m³) around a point, and adds what is removed to `load`, m³ by the
    /// number of the material (one number, 0, where there is no table). Returns the volume removed.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Brush, Erodible, HeightField};
    ///
    /// let mut plain = HeightField::new(Grid::new(Shape::new(3, 3), [10.0; 2])?, vec![50.0; 9])?;
    /// let (brush, mut load) = (Brush { at: [10.0, 10.0, 50.0], radius: 15.0 }, [0.0]);
    /// assert_eq!(plain.take(brush, 30.0, &mut load), load[0]);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn take(&mut self, brush: Brush, volume: f64, load: &mut [f64]) -> f64;

    /// Deposits up to a volume (m³) of the material of a number around a point, and returns the
    /// volume deposited.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Brush, Erodible, HeightField, Terrain};
    ///
    /// let mut plain = HeightField::new(Grid::new(Shape::new(3, 3), [10.0; 2])?, vec![50.0; 9])?;
    /// let before = plain.volume();
    /// let laid = plain.lay(Brush { at: [10.0, 10.0, 50.0], radius: 15.0 }, 30.0, 0);
    /// assert!((plain.volume() - before - laid).abs() < 1e-9);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn lay(&mut self, brush: Brush, volume: f64, material: u8) -> f64;

    /// Removes a volume (m³) around a point and returns the volume that was removed.
    fn remove(&mut self, brush: Brush, volume: f64) -> Removed {
        let count = self.table().map_or(1, |table| table.all().len());
        let mut load = vec![0.0; count];
        let volume = self.take(brush, volume, &mut load);
        let name = |k: usize| self.table().map_or("rock".into(), |table| table.all()[k].name.clone());
        let some = load.iter().enumerate().filter(|part| *part.1 > 0.0);
        Removed { volume, by_material: some.map(|(k, volume)| (name(k), *volume)).collect() }
    }

    /// Deposits a volume (m³) of a material around a point and returns the volume that was
    /// deposited, m³.
    ///
    /// # Errors
    /// [`crate::Error::Parameter`] for a material that is not in the table of layered ground.
    fn deposit(&mut self, brush: Brush, volume: f64, material: &str) -> Result<f64> {
        let number = self.table().map_or(Ok(0), |table| table.need(material, "material"))?;
        Ok(self.lay(brush, volume, number))
    }
}

/// The rise (m) of each node under a brush that lays a volume, m³: a half-sphere, scaled so that
/// its discrete volume is that one, also where the brush leaves the map; the nearest node alone
/// where the brush is finer than the nodes.
fn half_sphere<T: NodeSurface>(terrain: &T, brush: Brush, volume: f64) -> Vec<(usize, f64)> {
    let mut nodes = terrain.nodes_near([brush.at[0], brush.at[1]], brush.radius);
    let domain = terrain.domain();
    let square = brush.radius * brush.radius;
    let mut whole = 0.0;
    for node in &mut nodes {
        node.1 = (square - node.1).max(0.0).sqrt();
        whole += node.1 * domain.area(node.0);
    }
    if let ([only], true) = (&mut nodes[..], !(whole > 0.0)) {
        (only.1, whole) = (1.0, domain.area(only.0));
    }
    let scale = if whole > 0.0 { volume / whole } else { 0.0 };
    nodes.iter_mut().for_each(|node| node.1 *= scale);
    nodes
}

/// # Sources
/// Hartley (thesis), Equations 6.9 and 6.10. The middle form of 6.9 divides by the factor that the
/// last multiplies with; the last integrates to the volume.
impl<T: NodeSurface + Ground> Erodible for T {
    fn table(&self) -> Option<&Materials> {
        self.layers().map(Layers::materials)
    }

    fn material_at(&self, [x, y, _]: [f64; 3]) -> u8 {
        let Some(layers) = self.layers() else { return 0 };
        let near = self.nodes_near([x, y], 0.0);
        near.first().map_or(0, |node| layers.surface_number(node.0, self.elevation()[node.0]))
    }

    /// **Cost** O(nodes under the brush) on a raster.
    fn take(&mut self, brush: Brush, volume: f64, load: &mut [f64]) -> f64 {
        let nodes = half_sphere(self, brush, -volume);
        let mut taken = 0.0;
        self.change_nodes(0, &nodes, |number, volume| {
            load[usize::from(number)] += volume;
            taken += volume;
        });
        taken
    }

    /// **Cost** O(nodes under the brush) on a raster.
    fn lay(&mut self, brush: Brush, volume: f64, material: u8) -> f64 {
        let nodes = half_sphere(self, brush, volume);
        self.change_nodes(material, &nodes, |_, _| {});
        if nodes.is_empty() { 0.0 } else { volume }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::terrain::{HeightField, Materials, Terrain};

    #[test]
    fn a_brush_moves_exact_volumes_and_tells_materials() {
        let grid = Grid::new(Shape::new(21, 21), [2.0; 2]).unwrap();
        let mut ground = HeightField::new(grid, vec![50.0; 441]).unwrap();
        ground.make_layered(&Materials::default());
        let brush = Brush { at: [20.0, 20.0, 50.0], radius: 7.0 };
        let before = ground.volume();
        assert_eq!(ground.deposit(brush, 30.0, "sand").unwrap(), 30.0);
        assert!((ground.volume() - before - 30.0).abs() < 1e-9);
        let removed = ground.remove(brush, 100.0);
        let of = |name: &str| removed.by_material.iter().find(|m| m.0 == name).map_or(0.0, |m| m.1);
        assert!((of("sand") - 30.0).abs() < 1e-9 && (of("rock") - 70.0).abs() < 1e-9, "{removed:?}");
        assert!((ground.volume() - before + 70.0).abs() < 1e-9);
        assert!(ground.deposit(brush, 1.0, "cheese").is_err());
        // Finer than the nodes: the nearest takes it all.
        assert_eq!(ground.remove(Brush { radius: 0.1, ..brush }, 4.0).volume, 4.0);
        assert!((ground.volume() - before + 74.0).abs() < 1e-9);
    }
}
