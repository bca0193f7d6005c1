//! Caves that water dissolves in rock.
//!
//! # Sources
//! Pytel (2015), chapter 5: protochannels, then growth and linkage. Where the thesis leaves the
//! order of updates open, or its listings disagree with its text, the files of this folder say what
//! is done.
//!
//! ```
//! use landform_core::terrain::VoxelGrid;
//! use landform_core::units::Length;
//! use landform_core::verb::{Context, Edit, Generator};
//! use landform_process::cave::{Cave, InletParams, OutletParams};
//! use landform_process::volume::{BlockParams, RockVolume};
//!
//! let grid = BlockParams { size: [20.0, 14.0, 8.0].map(Length::of), cell_size: Length::of(1.0) };
//! let context = Context::default();
//! let mut rock = RockVolume { grid, ..RockVolume::default() }.generate(&context)?;
//! let (at, radius) = ([2.0, 7.0, 5.0].map(Length::of), None);
//! let outlet = OutletParams { at: Some([18.0, 7.0, 2.0].map(Length::of)), ..OutletParams::default() };
//! let cave = Cave { inlets: vec![InletParams { at, pressure: 1.0, radius }], outlets: vec![outlet], ..Cave::default() };
//! cave.edit(&mut rock, &context)?;
//! assert!(rock.solids() < 20 * 14 * 8 && rock.field(VoxelGrid::PRESSURE).is_some());
//! # Ok::<(), landform_core::Error>(())
//! ```

mod breakthrough;
mod growth;
mod places;
mod protochannels;

use landform_core::algo::lattice::Lattice;
use landform_core::analysis::cave::centreline;
use landform_core::feature::{Feature, FeatureKind, Features, Geometry, Property};
use landform_core::terrain::VoxelGrid;
use landform_core::units::{Length, Ratio};
use landform_core::verb::{Context, Edit, Estimate, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use breakthrough::{Breakthrough, Watch};
use growth::{Growth, Law, ONE, Rock};
pub use places::{InletParams, OutletParams};
use protochannels::{CONTESTED, Wanted, protochannels, zones};

landform_core::stages! {
    edit Cave where VoxelGrid;
}

/// Dissolves a cave in a block of rock: protochannels from the inlets, then growth and linkage of
/// channels to the outlets. It leaves the passages empty, the fields porosity, pressure and
/// protochannel, and the centreline, inlets and outlets as features.
///
/// ```
/// assert_eq!(landform_process::cave::Cave::default().iterations, 240);
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Cave {
    /// Places where water enters: { at, pressure, radius }. If none are given, one in the middle of
    /// the west side, near the top.
    pub inlets: Vec<InletParams>,
    /// Places where it leaves: { side, below, above, along } or { at, radius }. If none are given,
    /// the lower quarter of the east side.
    pub outlets: Vec<OutletParams>,
    /// Iterations of growth.
    #[schemars(extend("x-min" = 0, "x-max" = 1_000_000))]
    pub iterations: u32,
    /// Most by which pressure grows in rock, 1/m, away from where it is lower.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1000.0))]
    pub pressure_rate: f64,
    /// The same in channels, 1/m.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1000.0))]
    pub pressure_rate_channel: f64,
    /// Porosity that a full flow adds in an iteration, as a fraction.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub dissolution: f64,
    /// Part of the flow that dissolves the walls beside it.
    #[schemars(extend("x-min" = 0.0, "x-max" = 10.0))]
    pub dissolution_aside: f64,
    /// Power of the flow in dissolution: an exponent.
    #[schemars(extend("x-min" = 0.1, "x-max" = 4.0))]
    pub flow_exponent: f64,
    /// Porosity above which a voxel is empty, in meshes, measures and files.
    #[schemars(extend("x-min" = 0.01, "x-max" = 0.99))]
    pub empty_above: Ratio,
    /// Ways that each inlet's protochannels try.
    #[schemars(extend("x-min" = 1, "x-max" = 1000))]
    pub protochannels: usize,
    /// Part of them that lead towards the outlets; the others lead all around.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub clustered: Ratio,
}

impl Default for Cave {
    fn default() -> Self {
        Self {
            inlets: Vec::new(),
            outlets: Vec::new(),
            iterations: 240,
            pressure_rate: 0.5,
            pressure_rate_channel: 0.001,
            dissolution: 0.15,
            dissolution_aside: 0.25,
            flow_exponent: 1.0,
            empty_above: Ratio::of(0.5),
            protochannels: 12,
            clustered: Ratio::of(0.5),
        }
    }
}

impl Params for Cave {
    const NAME: &'static str = "cave";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Pytel (2015)",
        title: "Erosion, Self-Organization, and Procedural Modeling, chapter 5, University of Waterloo",
        doi: "",
    }];

    fn leaves(&self) -> Vec<String> {
        [VoxelGrid::POROSITY, VoxelGrid::PRESSURE, PROTOCHANNEL].map(String::from).to_vec()
    }

    fn places(&self) -> Vec<(&'static str, [f64; 2])> {
        let of = |name, [x, y, _]: [Length; 3]| (name, [x.si(), y.si()]);
        let outlets = self.outlets.iter().filter_map(|o| o.at).map(|at| of("outlets.at", at));
        self.inlets.iter().map(|i| of("inlets.at", i.at)).chain(outlets).collect()
    }

    fn check(&self) -> Result<()> {
        if self.inlets.len() > 250 {
            return Err(Error::parameter("inlets", self.inlets.len(), "at most 250"));
        }
        if let Some(inlet) = self.inlets.iter().find(|i| !(i.pressure > 0.0 && i.pressure.is_finite())) {
            return Err(Error::parameter("inlets.pressure", inlet.pressure, "more than 0"));
        }
        self.outlets.iter().try_for_each(OutletParams::check)
    }
}

/// Name of the field that is 1 in protochannels, else 0.
const PROTOCHANNEL: &str = "protochannel";

/// Ends of the water's ways: voxels of each, and pressures of inlets.
struct Ends {
    inlets: Vec<(Vec<usize>, f64)>,
    outlets: Vec<Vec<usize>>,
}

impl Cave {
    fn ends(&self, ground: &VoxelGrid, lattice: &Lattice) -> Result<Ends> {
        let [nx, ny, nz] = lattice.size();
        let mut inlets = Vec::new();
        for inlet in &self.inlets {
            inlets.push((inlet.voxels(ground, lattice)?, inlet.pressure));
        }
        if inlets.is_empty() {
            inlets.push((vec![lattice.at([nx / 16, ny / 2, nz - 1 - nz / 8])], 1.0));
        }
        let mut outlets = Vec::new();
        for outlet in &self.outlets {
            outlets.push(outlet.voxels(ground, lattice)?);
        }
        if outlets.is_empty() {
            let low = (0..nz.div_ceil(4)).flat_map(|z| (0..ny).map(move |y| [nx - 1, y, z]));
            outlets.push(low.map(|place| lattice.at(place)).collect());
        }
        let is_both = |i: &usize| outlets.iter().any(|o| o.contains(i));
        match inlets.iter().position(|inlet| inlet.0.iter().any(&is_both)) {
            Some(number) => Err(self.meets_an_outlet(number, lattice)),
            None => Ok(Ends { inlets, outlets }),
        }
    }

    /// That an inlet holds a voxel of an outlet.
    fn meets_an_outlet(&self, number: usize, lattice: &Lattice) -> Error {
        let expected = "a place apart from the outlets";
        match self.inlets.get(number).map(|inlet| inlet.radius) {
            Some(Some(radius)) => {
                let given = format!("{radius} for inlet {}, within which an outlet lies", number + 1);
                Error::parameter("inlets.radius", given, "a radius that does not reach the outlets")
            }
            Some(None) => Error::parameter("inlets", "a place that is an outlet too", expected),
            None => {
                let [nx, ny, nz] = lattice.size();
                let given = format!("not given, in a block of {nx} x {ny} x {nz} voxels, where an outlet is");
                Error::parameter("inlets", given, &format!("{expected}, or a larger block"))
            }
        }
    }

    fn law(&self, unit: f64) -> Law {
        Law {
            rates: [self.pressure_rate, self.pressure_rate_channel].map(|r| (r * unit).max(1.0) as f32),
            open: (self.empty_above.si() * f64::from(ONE)) as u32,
            dissolution: self.dissolution,
            aside: self.dissolution_aside,
            exponent: self.flow_exponent,
        }
    }
}

/// The rock as whole numbers; empty voxels are all pores. Ground without such fields has 5 % of
/// pores, the permeability of plain rock and the solubility of its materials.
fn rock_of(ground: &VoxelGrid, lattice: &Lattice) -> Rock {
    let field = |name: &str| ground.field(name);
    let (porosity, permeability) = (field(VoxelGrid::POROSITY), field(VoxelGrid::PERMEABILITY));
    let solubility = field(VoxelGrid::SOLUBILITY);
    let (nodes, count) = (ground.plan().len(), ground.plan().len() * ground.levels());
    let material = |i: usize| ground.material(i / nodes, i % nodes);
    let units = |i: usize| {
        let part = porosity.map_or(0.05, |p| f64::from(p[i]));
        if material(i).is_some() { ((part * f64::from(ONE)) as u32).clamp(1, ONE) } else { ONE }
    };
    let of_material = |i: usize| material(i).map_or(0.0, |number| ground.materials().get(number).solubility as f32);
    Rock {
        porosity: lattice.padded((0..count).map(units), 0),
        permeability: lattice.padded((0..count).map(|i| permeability.map_or(1.0, |k| k[i].max(1e-3))), 0.0),
        solubility: lattice
            .padded((0..count).map(|i| solubility.map_or_else(|| of_material(i), |s| s[i].clamp(0.0, 1.0))), 0.0),
    }
}

impl Edit<VoxelGrid> for Cave {
    fn edit(&self, terrain: &mut VoxelGrid, context: &Context) -> Result<()> {
        let lattice = Lattice::over(terrain);
        let (rock, ends) = (rock_of(terrain, &lattice), self.ends(terrain, &lattice)?);
        let highest = ends.inlets.iter().map(|i| i.1).fold(0.0, f64::max);
        let unit = f64::from(ONE) / highest;
        let zone = zones(&lattice, &rock, &ends.inlets);
        let all_outlets: Vec<usize> = ends.outlets.iter().flatten().copied().collect();
        let seed = context.seed.named("protochannels");
        let wanted = Wanted { count: self.protochannels, clustered: self.clustered.si(), seed };
        let channel = protochannels(&lattice, &rock, &zone, &ends.inlets, &all_outlets, &wanted);
        let pressures: Vec<u32> = ends.inlets.iter().map(|i| (i.1 * unit).max(1.0) as u32).collect();
        let lowest = pressures.iter().copied().min().unwrap_or(ONE);
        let of_zone = |z: u8| match z {
            0 => 0,
            CONTESTED => lowest,
            z => pressures[usize::from(z) - 1],
        };
        let pressure = zone.iter().map(|z| of_zone(*z)).collect();
        let law = self.law(unit);
        let all_inlets = ends.inlets.iter().flat_map(|i| &i.0).copied().collect();
        let mut growth = Growth::new(&lattice, rock, law, pressure, &channel, [all_inlets, all_outlets]);
        let mut watch = Watch::new(&lattice, &ends);
        let open: Vec<usize> = lattice.voxels().filter(|&i| growth.rock.porosity[i] > law.open).collect();
        watch.open(0, &open, &growth.pressure);
        for iteration in 1..=self.iterations {
            let opened = growth.step();
            watch.open(iteration, &opened, &growth.pressure);
        }
        let share = |values: &[u32], unit: f64| -> Vec<f32> {
            lattice.unpadded(values).into_iter().map(|v| (f64::from(v) / unit) as f32).collect()
        };
        terrain.set_field(VoxelGrid::POROSITY, share(&growth.rock.porosity, f64::from(ONE)))?;
        terrain.set_field(VoxelGrid::PRESSURE, share(&growth.pressure, unit))?;
        let proto = lattice.unpadded(&channel).into_iter().map(|c| f32::from(u8::from(c))).collect();
        terrain.set_field(PROTOCHANNEL, proto)?;
        let porosity = lattice.unpadded(&growth.rock.porosity);
        terrain.empty_where(|i| porosity[i] > law.open);
        let ends_found = marks(terrain, &lattice, &ends, &watch.found);
        let mut features: Features = centreline(terrain).network().features().into_iter().collect();
        features.update(ends_found.into_iter().collect());
        terrain.features_mut().update(features);
        Ok(())
    }

    fn estimate(&self, before: Estimate) -> Estimate {
        // Of which 26 are the flow's, and 60 the growth's.
        Estimate { bytes: before.nodes * 150, ..before }
    }
}

/// Inlets and outlets as features; inlets say when they broke through.
fn marks(ground: &VoxelGrid, lattice: &Lattice, ends: &Ends, found: &[Option<Breakthrough>]) -> Vec<Feature> {
    let place = |voxels: &[usize]| {
        let sum = voxels.iter().map(|&i| lattice.middle(ground, i));
        let sum = sum.fold([0.0; 3], |a, m| [0, 1, 2].map(|k| a[k] + m[k]));
        Geometry::Point(sum.map(|v| v / voxels.len().max(1) as f64))
    };
    let inlets = ends.inlets.iter().zip(found).enumerate().map(|(k, ((voxels, pressure), found))| {
        let number = |v: Option<f64>| v.map_or(Property::None, Property::Number);
        let properties = vec![
            ("pressure".into(), Property::Number(*pressure)),
            ("breakthrough_iteration".into(), number(found.map(|f| f64::from(f.iteration)))),
            ("outlet".into(), found.map_or(Property::None, |f| Property::Text((f.outlet + 1).to_string()))),
            (
                "joins_inlet".into(),
                found.and_then(|f| f.joins).map_or(Property::None, |j| Property::Text((j + 1).to_string())),
            ),
        ];
        Feature { id: (k + 1).to_string(), kind: FeatureKind::Sinkhole, geometry: place(voxels), properties }
    });
    let outlets = ends.outlets.iter().enumerate().map(|(k, voxels)| {
        // Where passages reach it, if they do.
        let nodes = ground.plan().len();
        let is_open = |i: &usize| {
            let [x, y, z] = lattice.place(*i);
            ground.material(z, ground.plan().shape.index(y, x) % nodes).is_none()
        };
        let open: Vec<usize> = voxels.iter().copied().filter(is_open).collect();
        let geometry = place(if open.is_empty() { voxels } else { &open });
        Feature { id: (k + 1).to_string(), kind: FeatureKind::Spring, geometry, properties: Vec::new() }
    });
    inlets.chain(outlets).collect()
}

#[cfg(test)]
mod tests {
    use landform_core::grid::Side;
    use landform_core::verb::Generator;

    use super::*;
    use crate::volume::RockVolume;

    fn rock(text: &str) -> VoxelGrid {
        let rock: RockVolume = serde_json::from_str(text).unwrap();
        rock.generate(&Context::default()).unwrap()
    }

    /// Three protochannels side by side, of which the first leads by the outlet: all leave through
    /// one passage (phreatic loops; Pytel, Figures 5.6 and 5.7).
    #[test]
    fn far_inlets_link_up_with_near_ones() {
        let lattice = Lattice::new([64, 44, 1], [1.0; 3]);
        let n = lattice.voxels().count();
        let rock = Rock {
            porosity: lattice.padded(std::iter::repeat_n(ONE / 10, n), 0),
            permeability: lattice.padded(std::iter::repeat_n(1.0, n), 0.0),
            solubility: lattice.padded(std::iter::repeat_n(1.0, n), 0.0),
        };
        let mut channel = vec![false; lattice.stored()];
        let rows = [10, 22, 34];
        rows.iter().for_each(|&y| (10..=60).for_each(|x| channel[lattice.at([x, y, 0])] = true));
        let inlet = |y: &usize| vec![lattice.at([60, *y, 0])];
        let ends = Ends {
            inlets: rows.iter().map(|y| (inlet(y), 1.0)).collect(),
            outlets: vec![vec![lattice.at([4, 10, 0])]],
        };
        let law = Law {
            rates: [0.05, 0.001].map(|r| (r * f64::from(ONE)) as f32),
            open: ONE / 2,
            dissolution: 0.15,
            aside: 0.25,
            exponent: 1.0,
        };
        let pressure = lattice.padded(std::iter::repeat_n(ONE, n), 0);
        let both = [rows.iter().flat_map(inlet).collect(), ends.outlets.concat()];
        let mut growth = Growth::new(&lattice, rock, law, pressure, &channel, both);
        let mut watch = Watch::new(&lattice, &ends);
        for iteration in 1..=600 {
            let opened = growth.step();
            watch.open(iteration, &opened, &growth.pressure);
        }
        let joins: Vec<_> = watch.found.iter().map(|f| f.map(|f| f.joins)).collect();
        let direct = joins.iter().filter(|j| **j == Some(None)).count();
        assert!(direct == 1 && joins.iter().all(Option::is_some), "{joins:?}");
        // None of the far protochannels opens a way of its own to the outlet.
        let is_open = |[x, y]: [usize; 2]| growth.rock.porosity[lattice.at([x, y, 0])] > law.open;
        assert!((16..44).all(|y| !is_open([4, y])));
    }

    #[test]
    fn places_off_the_rock_and_outlets_without_a_place_are_refused() {
        let mut ground = rock(r#"{"grid":{"size":["10 m","8 m","6 m"],"cell_size":"1 m"}}"#);
        let place = |x: f64| InletParams { at: [x, 2.0, 3.0].map(Length::of), pressure: 1.0, radius: None };
        let far = Cave { inlets: vec![place(50.0)], ..Cave::default() };
        assert!(far.edit(&mut ground, &Context::default()).unwrap_err().to_string().contains("inlets.at"));
        let nowhere = Cave { outlets: vec![OutletParams::default()], ..Cave::default() };
        assert!(nowhere.validate().is_err());
        let high = OutletParams { side: Some(Side::East), above: Some(Length::of(90.0)), ..OutletParams::default() };
        let dry = Cave { outlets: vec![high], ..Cave::default() };
        assert!(dry.edit(&mut ground, &Context::default()).is_err());
        let outlets = vec![OutletParams { side: Some(Side::West), ..OutletParams::default() }];
        let same = Cave { inlets: vec![place(0.5)], outlets, ..Cave::default() };
        assert!(same.edit(&mut ground, &Context::default()).unwrap_err().to_string().contains("outlet too"));
        let wide = InletParams { radius: Some(Length::of(20.0)), ..place(2.0) };
        let wide = Cave { inlets: vec![wide], ..Cave::default() };
        assert!(
            wide.edit(&mut ground, &Context::default()).unwrap_err().to_string().contains("`inlets.radius` is 20 m")
        );
        let mut tiny = rock(r#"{"grid":{"size":["1 m","1 m","1 m"],"cell_size":"1 m"}}"#);
        let told = Cave::default().edit(&mut tiny, &Context::default()).unwrap_err().to_string();
        assert!(told.contains("not given, in a block of 1 x 1 x 1 voxels"), "{told}");
        // A plan knows them before a run.
        assert_eq!(Cave { inlets: vec![place(50.0)], ..Cave::default() }.places(), [("inlets.at", [50.0, 2.0])]);
    }

    #[test]
    fn outlets_whose_numbers_contradict_each_other_are_told_by_name() {
        let told = |text: &str| {
            let outlets = vec![serde_json::from_str(text).unwrap()];
            Cave { outlets, ..Cave::default() }.validate().unwrap_err().to_string()
        };
        assert!(told(r#"{"side":"east","along":[0.7,0.2]}"#).starts_with("parameter `outlets.along` is [0.7, 0.2]"));
        assert!(told(r#"{"side":"east","below":"2 m","above":"6 m"}"#).starts_with("parameter `outlets.below` is 2 m"));
        assert!(told(r#"{"side":"east","radius":"2 m"}"#).starts_with("parameter `outlets.radius` is 2 m"));
        assert!(told(r#"{"side":"east","at":["1 m","1 m","1 m"]}"#).contains("one of them"));
        let mut ground = rock(r#"{"grid":{"size":["10 m","8 m","6 m"],"cell_size":"1 m"}}"#);
        let outlets = vec![serde_json::from_str(r#"{"side":"east","along":[0.51,0.52]}"#).unwrap()];
        let narrow = Cave { outlets, ..Cave::default() }.edit(&mut ground, &Context::default());
        assert!(narrow.unwrap_err().to_string().contains("between two voxels"));
    }

    #[test]
    fn rock_that_water_cannot_dissolve_stays_closed() {
        let bed = r#"{"grid":{"size":["20 m","12 m","8 m"],"cell_size":"1 m"},"beds":[{"material":"granite","thickness":"9 m"}]}"#;
        let mut ground = rock(bed);
        Cave::default().edit(&mut ground, &Context::default()).unwrap();
        assert_eq!(ground.solids(), 20 * 12 * 8);
        let found = ground.features().of(FeatureKind::Sinkhole).next().unwrap();
        assert!(found.properties.iter().any(|p| p.0 == "breakthrough_iteration" && p.1 == Property::None));
    }
}
