//! The form of a cave, and what its water found on the way.

use landform_core::analysis::cave::{Morphometry, centreline, morphometry};
use landform_core::feature::{Feature, FeatureKind, Features, Property};
use landform_core::terrain::VoxelGrid;
use landform_core::units::Length;
use landform_core::verb::{Landscape, Measure, Params, Source, check_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measures a cave: length, plan area, volume, width, density, coverage, porosity, the kinds of
/// cave with such numbers, and when each inlet broke through.
///
/// ```
/// assert_eq!(landform_io::measure::MeasureCave::default().path, "cave.json");
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureCave {
    /// Path below the output folder.
    pub path: String,
    /// Radius around passages of the optimised cave field.
    #[schemars(extend("x-above" = 0.0, "x-max" = 100_000.0))]
    pub field_radius: Length,
    /// Elevation of standing water, of which the length of flooded passages is found. If not
    /// given, it is not.
    pub water_level: Option<Length>,
}

impl Default for MeasureCave {
    fn default() -> Self {
        Self { path: "cave.json".into(), field_radius: Length::of(12.0), water_level: None }
    }
}

impl Params for MeasureCave {
    const NAME: &'static str = "measure_cave";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Klimchouk (2003)",
            title: "Unconfined versus confined speleogenetic settings: variations of solution porosity, Speleogenesis and Evolution of Karst Aquifers 1(2)",
            doi: "",
        },
        Source {
            authors: "Frumkin & Fischhendler (2005)",
            title: "Morphometry and distribution of isolated caves as a guide for phreatic and confined paleohydrological conditions, Geomorphology 67",
            doi: "10.1016/j.geomorph.2004.11.009",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(20)
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["json"])
    }
}

/// What was measured of a cave.
///
/// ```
/// use landform_core::analysis::cave::morphometry;
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{Materials, VoxelGrid};
///
/// let plan = Grid::new(Shape::new(1, 3), [1.0, 1.0])?;
/// let ground = VoxelGrid::from_fn(plan, 3, 0.0, 1.0, &Materials::default(), |l, n| (l != 1 || n != 1).then_some(0))?;
/// let form = morphometry(&ground, 5.0).unwrap();
/// let found = landform_io::measure::CaveMeasured {
///     form,
///     flooded_length_m: None,
///     breakthroughs: 0,
///     captures: 0,
///     inlets: Vec::new(),
/// };
/// assert_eq!(found.form.volume_m3, 1.0);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize)]
pub struct CaveMeasured {
    /// The form of its passages.
    #[serde(flatten)]
    pub form: Morphometry,
    /// Length of passages under the water level, m; none if no level was given.
    pub flooded_length_m: Option<f64>,
    /// How many inlets an open passage leads from to an outlet.
    pub breakthroughs: usize,
    /// How many of them join the passage of another inlet.
    pub captures: usize,
    /// Each inlet.
    pub inlets: Vec<InletMeasured>,
}

/// What became of an inlet.
///
/// ```
/// let inlet = landform_io::measure::InletMeasured {
///     inlet: "1".into(),
///     breakthrough_iteration: Some(176.0),
///     outlet: Some("1".into()),
///     joins_inlet: None,
/// };
/// assert!(inlet.joins_inlet.is_none());
/// ```
#[derive(Clone, Debug, Serialize)]
pub struct InletMeasured {
    /// Its number in the recipe, from 1.
    pub inlet: String,
    /// Number of the iteration in which an open passage first led to an outlet; none if none does.
    pub breakthrough_iteration: Option<f64>,
    /// Number of the outlet, from 1.
    pub outlet: Option<String>,
    /// The inlet whose passage it joins; none if it leads to the outlet itself.
    pub joins_inlet: Option<String>,
}

impl Measure<VoxelGrid> for MeasureCave {
    type Out = CaveMeasured;

    fn path(&self) -> &str {
        &self.path
    }

    fn measure(&self, landscape: &Landscape<'_, VoxelGrid>) -> Result<CaveMeasured> {
        let form = morphometry(landscape.terrain, self.field_radius.si()).ok_or_else(no_cave)?;
        let inlets = inlets(landscape.terrain.features());
        let through = || inlets.iter().filter(|i| i.breakthrough_iteration.is_some());
        let (breakthroughs, captures) = (through().count(), through().filter(|i| i.joins_inlet.is_some()).count());
        let flooded_length_m = self.water_level.map(|z| centreline(landscape.terrain).length_under(z.si()));
        Ok(CaveMeasured { form, flooded_length_m, breakthroughs, captures, inlets })
    }
}

/// That no voxel is open under the ground.
pub(crate) fn no_cave() -> Error {
    let hint = "`cave` dissolves one; more `iterations` or a lower `empty_above` open more of it";
    Error::Recipe { at: None, what: "there is no cave: no voxel is empty".into(), hint: Some(hint.into()) }
}

fn inlets(features: &Features) -> Vec<InletMeasured> {
    let of = |f: &Feature| {
        let text = |name: &str| match f.property(name) {
            Some(Property::Text(v)) => Some(v.clone()),
            _ => None,
        };
        InletMeasured {
            inlet: f.id.clone(),
            breakthrough_iteration: f.number("breakthrough_iteration"),
            outlet: text("outlet"),
            joins_inlet: text("joins_inlet"),
        }
    };
    features.of(FeatureKind::Sinkhole).map(of).collect()
}
