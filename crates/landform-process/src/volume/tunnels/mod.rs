//! Passages in voxels along the conduits of a landscape.

mod section;

use landform_core::feature::{ConduitNetwork, Feature, FeatureKind, Features};
use landform_core::grid::{Grid, Shape};
use landform_core::terrain::{Bounds, HeightField, Materials, NodeSurface, VoxelGrid};
use landform_core::units::Length;
use landform_core::verb::{Convert, Estimate, FeatureWord, Params, Source};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use section::{Piece, Section};

/// Turns the ground around conduits into voxels and hollows out their passages: tubes, canyons,
/// keyholes and shafts. The rest of the map is left out; fields of the raster are lost.
///
/// ```
/// let text = r#"{"cell_size":"2 m","around":{"feature":"conduits","buffer":"40 m"}}"#;
/// let given: landform_process::volume::Tunnels = serde_json::from_str(text).unwrap();
/// assert_eq!(given.cell_size.si(), 2.0);
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Tunnels {
    /// Shape of passages across.
    pub sections: Sections,
    /// Side of a voxel. No passage is narrower than lets it hang together.
    #[schemars(extend("x-min" = 0.01, "x-role" = "resolution"))]
    pub cell_size: Length,
    /// Features that are hollowed out, and the ground around them that is kept.
    pub around: Around,
}

/// Shape of passages across.
///
/// ```
/// use landform_process::volume::{Sections, Tunnels};
///
/// assert_eq!(Tunnels::default().sections, Sections::BySlope);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sections {
    /// By the slope of the passage and by its water: wide tubes under the water table, canyons
    /// where water runs down to it, keyholes where the water table has fallen a little, shafts
    /// where it drops. All have the area of a circle of the conduit's radius.
    #[default]
    BySlope,
    /// As far to all sides as the conduit says.
    AsGiven,
}

/// The ground around features.
///
/// ```
/// let text = r#"{"feature":"conduits","buffer":"40 m"}"#;
/// let given: landform_process::volume::Around = serde_json::from_str(text).unwrap();
/// assert_eq!(given.buffer.si(), 40.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Around {
    /// Kind of feature: "conduits".
    pub feature: FeatureWord,
    /// Ground that is kept beside and under them.
    #[schemars(extend("x-min" = 0.0, "x-max" = 100_000.0))]
    pub buffer: Length,
}

impl Default for Around {
    fn default() -> Self {
        Self { feature: FeatureWord::Conduits, buffer: Length::of(20.0) }
    }
}

impl Default for Tunnels {
    fn default() -> Self {
        Self { sections: Sections::default(), cell_size: Length::of(2.0), around: Around::default() }
    }
}

/// More voxels than this are refused.
const MOST_VOXELS: f64 = 4e9;

impl Params for Tunnels {
    const NAME: &'static str = "tunnels";
    const NEEDS: &'static [FeatureKind] = &[FeatureKind::Conduit];
    const SOURCES: &'static [Source] = &[Source {
        authors: "Palmer (1991)",
        title: "Origin and morphology of limestone caves, GSA Bulletin 103",
        doi: "10.1130/0016-7606(1991)103<0001:OAMOLC>2.3.CO;2",
    }];

    fn leaves(&self) -> Vec<String> {
        ["rock", "material"].map(String::from).to_vec()
    }

    fn check(&self) -> Result<()> {
        if self.around.feature == FeatureWord::Conduits {
            return Ok(());
        }
        let given = format!("\"{}s\"", self.around.feature.kind().word());
        Err(Error::parameter("around.feature", given, "\"conduits\""))
    }
}

impl Tunnels {
    /// Voxels of the ground around a network, solid.
    fn block(&self, source: &HeightField, network: &ConduitNetwork) -> Result<VoxelGrid> {
        let (cell, buffer) = (self.cell_size.si(), self.around.buffer.si());
        let Bounds { low, high } = Bounds::around(&network.nodes);
        let bounds = source.bounds();
        let first = [0, 1].map(|k| ((low[k] - buffer).max(bounds[0][k]) / cell).ceil());
        let last = [0, 1].map(|k| ((high[k] + buffer).min(bounds[1][k]) / cell).floor());
        let count = [0, 1].map(|k| (last[k] - first[k] + 1.0).max(1.0));
        if !(count[0] * count[1] < MOST_VOXELS) {
            return Err(self.too_many(count[0] * count[1]));
        }
        let mut plan = Grid::new(Shape::new(count[1] as usize, count[0] as usize), [cell; 2])?;
        plan.origin = [first[0] * cell, last[1] * cell];
        plan.georeference = source.grid().georeference.clone();
        let top = parallel::map(plan.len(), |i| source.elevation_at(plan.position(i)));
        let highest = top.iter().copied().filter(|z| z.is_finite()).fold(high[2], f64::max);
        let bottom = ((low[2] - buffer) / cell).floor() * cell;
        let levels = ((highest - bottom) / cell).ceil().max(1.0);
        if !(levels * plan.len() as f64 <= MOST_VOXELS) {
            return Err(self.too_many(levels * plan.len() as f64));
        }
        let materials = source.layers().map_or_else(Materials::default, |layers| layers.materials().clone());
        let material = |level: usize, node: usize| {
            let middle = bottom + (level as f64 + 0.5) * cell;
            if !(middle < top[node]) {
                return None;
            }
            let column = source.layers().zip(source.grid().node_at(plan.position(node)));
            let mut strata = column.map(|(layers, n)| layers.column(n, top[node]));
            Some(strata.as_mut().and_then(|s| s.find(|s| s.bottom < middle)).map_or(0, |stratum| stratum.number))
        };
        VoxelGrid::from_fn(plan.clone(), levels as usize, bottom, cell, &materials, material)
    }

    fn too_many(&self, voxels: f64) -> Error {
        let given = format!("{}: {voxels:.1e} voxels", self.cell_size);
        Error::parameter("cell_size", given, &format!("cells of which {MOST_VOXELS:.0e} make the ground around"))
    }
}

impl Convert<HeightField, VoxelGrid> for Tunnels {
    fn convert(&self, source: &HeightField) -> Result<VoxelGrid> {
        source.features().need(FeatureKind::Conduit, &format!("`{}`", Self::NAME))?;
        let network = ConduitNetwork::of(source.features());
        let mut ground = self.block(source, &network)?;
        let water = depths_under_water(source.features());
        // Voxels that a line passes hang together over faces, edges or corners.
        let least = 0.87 * self.cell_size.si();
        for (k, conduit) in network.conduits.iter().enumerate() {
            for (n, ends) in conduit.nodes.windows(2).enumerate() {
                let ends = [ends[0], ends[1]].map(|i| network.nodes[i as usize]);
                let walls = [conduit.passages[n], conduit.passages[n + 1]];
                let depth = water.get(k).and_then(|w| w.as_ref()).map(|w| 0.5 * (w[n] + w[n + 1]));
                let section = match self.sections {
                    Sections::BySlope => Section::of(ends, depth),
                    Sections::AsGiven => Section::AsGiven,
                };
                let piece = Piece::new(ends, walls, section, least);
                ground.empty(piece.bounds(), |at| piece.holds(at));
            }
        }
        let walls = network.conduits.iter().flat_map(|c| &c.passages);
        let widest = walls.fold(0.0_f64, |w, p| w.max(p.width()).max(p.height()));
        if self.cell_size.si() > widest && !has_roof(&ground) {
            let expected = format!("finer cells: no passage of these has a roof; the widest is {widest:.1} m wide");
            return Err(Error::parameter("cell_size", self.cell_size, &expected));
        }
        *ground.features_mut() = source.features().clone();
        Ok(ground)
    }

    /// As if the network filled the map, in ground a tenth as high as the map is wide.
    fn estimate(&self, source: Estimate) -> Estimate {
        let columns = source.raster_nodes(self.cell_size.si());
        let height = 0.1 * source.extent[0].max(1.0) + self.around.buffer.si();
        let nodes = columns.saturating_mul((height / self.cell_size.si()).ceil() as u64);
        let bytes =
            (source.nodes * 60).saturating_add(nodes.saturating_mul(2)).saturating_add(columns.saturating_mul(8));
        Estimate { nodes, columns, bytes, ..source }
    }
}

/// Whether an empty voxel lies under a solid one.
fn has_roof(ground: &VoxelGrid) -> bool {
    (1..ground.levels()).any(|level| {
        (0..ground.plan().len())
            .any(|node| ground.material(level - 1, node).is_none() && ground.material(level, node).is_some())
    })
}

/// For each conduit how deep its places lie under the water table, m, where that is known.
fn depths_under_water(features: &Features) -> Vec<Option<Vec<f64>>> {
    let of = |f: &Feature| {
        let places = f.numbers("left_m")?.len();
        f.numbers("depth_under_water_table_m").filter(|depths| depths.len() == places).map(<[f64]>::to_vec)
    };
    features.of(FeatureKind::Conduit).map(of).collect()
}

#[cfg(test)]
mod tests {
    use landform_core::feature::Passage;
    use landform_core::terrain::{Ground, Terrain};

    use super::*;

    /// A plain at 60 m over a level tube, with a shaft down to it.
    fn ground(radius: f64) -> HeightField {
        let plan = Grid::new(Shape::new(41, 81), [5.0; 2]).unwrap();
        let mut ground = HeightField::new(plan, vec![60.0; 41 * 81]).unwrap();
        let nodes = vec![[100.0, 100.0, 60.0], [100.0, 100.0, 20.0], [300.0, 100.0, 20.0]];
        let network = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2]], |_| Passage::round(radius));
        *ground.features_mut() = network.features().into_iter().collect();
        ground
    }

    #[test]
    fn passages_have_the_volume_of_their_tubes_and_keep_the_ground_above() {
        for sections in [Sections::AsGiven, Sections::BySlope] {
            let tunnels = Tunnels { sections, cell_size: Length::of(1.0), ..Tunnels::default() };
            let found = tunnels.convert(&ground(6.0)).unwrap();
            let full = tunnels.block(&ground(6.0), &ConduitNetwork::of(ground(6.0).features())).unwrap();
            // The far end is a half ball.
            let expected = std::f64::consts::PI * 36.0 * (240.0 + 4.0);
            let volume = full.volume() - found.volume();
            assert!((volume / expected - 1.0).abs() < 0.05, "{sections:?} {volume} {expected}");
            assert_eq!(found.height_at([200.0, 100.0]), Some(60.0));
            assert!(found.hit([103.0, 100.0, 20.0], [297.0, 100.0, 20.0]).is_none(), "one sees through");
            assert!(found.hit([100.0, 100.0, 59.0], [100.0, 100.0, 21.0]).is_none());
            assert_eq!(found.features(), ground(6.0).features());
        }
    }

    #[test]
    fn thin_passages_hang_together() {
        let tunnels = Tunnels { cell_size: Length::of(2.0), ..Tunnels::default() };
        let found = tunnels.convert(&ground(0.2)).unwrap();
        assert!(found.hit([102.0, 100.0, 20.0], [298.0, 100.0, 20.0]).is_none());
    }

    #[test]
    fn ground_without_conduits_and_too_fine_cells_are_refused() {
        let plain = HeightField::new(Grid::new(Shape::new(2, 2), [10.0; 2]).unwrap(), vec![0.0; 4]).unwrap();
        let error = Tunnels::default().convert(&plain).unwrap_err();
        assert!(error.hint().is_some_and(|h| h.contains("karst_network")), "{error}");
        let fine = Tunnels { cell_size: Length::of(0.01), ..Tunnels::default() };
        assert!(fine.convert(&ground(2.0)).unwrap_err().to_string().contains("voxels"));
        let coarse = Tunnels { cell_size: Length::of(100.0), ..Tunnels::default() };
        let error = coarse.convert(&ground(2.0)).unwrap_err().to_string();
        assert!(error.contains("`cell_size`") && error.contains("4.0 m wide"), "{error}");
        let rivers = Around { feature: FeatureWord::Rivers, ..Around::default() };
        assert!(Tunnels { around: rivers, ..Tunnels::default() }.check().is_err());
    }
}
