//! Solid that is removed from and deposited on the ground around a point.

use super::{Ground, Layer, NodeSurface};
use crate::Result;
use crate::grid::{Domain, Status};

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
    /// Removes a volume (m³) around a point and returns the volume that was removed.
    fn remove(&mut self, brush: Brush, volume: f64) -> Removed;

    /// Deposits a volume (m³) of a material around a point and returns the volume that was
    /// deposited, m³.
    ///
    /// # Errors
    /// [`crate::Error::Parameter`] for a material that is not in the table of layered ground.
    fn deposit(&mut self, brush: Brush, volume: f64, material: &str) -> Result<f64>;
}

/// Nodes under a brush with weights that sum to 1; the nearest node alone where the brush is finer
/// than the nodes.
fn weights<T: NodeSurface>(terrain: &T, brush: Brush) -> Vec<(usize, f64)> {
    let domain = terrain.domain();
    let status = domain.status();
    let square = |i: usize| {
        let [x, y] = terrain.position(i);
        (x - brush.at[0]) * (x - brush.at[0]) + (y - brush.at[1]) * (y - brush.at[1])
    };
    let valid = |i: &usize| status[*i] != Status::Masked;
    let radius = brush.radius * brush.radius;
    let near = (0..status.len()).filter(valid).filter(|&i| square(i) < radius);
    let mut nodes: Vec<(usize, f64)> = near.map(|i| (i, (1.0 - square(i) / radius) * domain.area(i))).collect();
    if nodes.is_empty() {
        let nearest = (0..status.len()).filter(valid).min_by(|&a, &b| square(a).total_cmp(&square(b)));
        nodes.extend(nearest.map(|i| (i, 1.0)));
    }
    let total: f64 = nodes.iter().map(|n| n.1).sum();
    nodes.iter_mut().for_each(|n| n.1 /= total);
    nodes
}

impl<T: NodeSurface + Ground> Erodible for T {
    /// **Cost** O(nodes).
    fn remove(&mut self, brush: Brush, volume: f64) -> Removed {
        let (nodes, domain) = (weights(self, brush), self.domain());
        let eroded = |t: &T| t.layers().map(|l| l.moved().iter().map(|m| m.eroded).collect::<Vec<_>>());
        let before = eroded(self);
        self.change(Layer::Surface("sediment"), |z| {
            nodes.iter().for_each(|&(i, weight)| z[i] -= volume * weight / domain.area(i));
        });
        let by_material = match (before, eroded(self), self.layers()) {
            (Some(before), Some(after), Some(layers)) => {
                let moved = layers.materials().all().iter().zip(before.iter().zip(&after));
                moved.map(|(m, (b, a))| (m.name.clone(), a - b)).filter(|m| m.1 > 0.0).collect()
            }
            _ => vec![("rock".to_string(), volume)],
        };
        Removed { volume, by_material }
    }

    /// **Cost** O(nodes).
    fn deposit(&mut self, brush: Brush, volume: f64, material: &str) -> Result<f64> {
        if let Some(layers) = self.layers() {
            layers.materials().need(material, "material")?;
        }
        let (nodes, domain) = (weights(self, brush), self.domain());
        self.change(Layer::Surface(material), |z| {
            nodes.iter().for_each(|&(i, weight)| z[i] += volume * weight / domain.area(i));
        });
        Ok(volume)
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
