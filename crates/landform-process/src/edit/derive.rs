//! Fields that follow from the ground.

use landform_core::algo::derivative::{gradient, local_relief, position_index, quadratic, slope};
use landform_core::algo::flow::{Flow, node_areas};
use landform_core::algo::horizon::shadow;
use landform_core::field::{Key, names};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Angle, Length};
use landform_core::verb::{Context, Edit, Params, Reach, Source};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Adds fields that follow from the ground as it is now: slope, aspect, curvatures, position above
/// the surroundings, relief, exposure to sun or wind, spread drainage area. They can be written,
/// drawn, and used as masks.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Derive {
    /// Fields that are added.
    pub fields: Vec<Derived>,
    /// position_index and local_relief: half of the side of the square around each node.
    #[schemars(extend("x-above" = 0.0))]
    pub radius: Length,
    /// exposure: compass direction from which the sun or the wind comes.
    pub light_from: Angle,
    /// exposure: its angle above level.
    #[schemars(extend("x-above" = 0.0, "x-max" = 90.0))]
    pub altitude: Angle,
}

/// A field that follows from the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Derived {
    /// Rise over run (Horn 1981).
    Slope,
    /// Compass direction that the ground faces, degrees.
    Aspect,
    /// Curvature along the slope, 1/m (Evans 1972).
    ProfileCurvature,
    /// Curvature of the contour, 1/m.
    PlanCurvature,
    /// Elevation less the mean of the surroundings, m.
    PositionIndex,
    /// Highest less lowest elevation of the surroundings, m.
    LocalRelief,
    /// 1 where the sun or the wind reaches, 0 in shadow.
    Exposure,
    /// Drainage area by D-infinity, m2.
    SpreadArea,
}

impl Default for Derive {
    fn default() -> Self {
        Self {
            fields: vec![Derived::Slope, Derived::Aspect, Derived::ProfileCurvature, Derived::PlanCurvature],
            radius: Length::of(500.0),
            light_from: Angle::of(315.0),
            altitude: Angle::of(30.0),
        }
    }
}

impl Params for Derive {
    const NAME: &'static str = "derive";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Horn (1981)",
            title: "Hill shading and the reflectance map, Proceedings of the IEEE 69(1)",
            doi: "10.1109/PROC.1981.11918",
        },
        Source {
            authors: "Tarboton (1997)",
            title: "A new method for the determination of flow directions and upslope areas in grid digital elevation models, Water Resources Research 33(2)",
            doi: "10.1029/96WR03137",
        },
    ];

    fn leaves(&self) -> Vec<String> {
        self.fields.iter().map(|what| what.key().name.to_string()).collect()
    }

    fn reach(&self) -> Reach {
        self.fields.iter().fold(Reach::Point, |reach, &what| reach.or(self.reach_of(what)))
    }
}

impl Derived {
    /// The key of its field.
    fn key(self) -> &'static Key<f64> {
        match self {
            Self::Slope => &names::SLOPE,
            Self::Aspect => &names::ASPECT,
            Self::ProfileCurvature => &names::PROFILE_CURVATURE,
            Self::PlanCurvature => &names::PLAN_CURVATURE,
            Self::PositionIndex => &names::POSITION_INDEX,
            Self::LocalRelief => &names::LOCAL_RELIEF,
            Self::Exposure => &names::EXPOSURE,
            Self::SpreadArea => &names::SPREAD_AREA,
        }
    }
}

impl Derive {
    /// How far around a node a field reads.
    fn reach_of(&self, what: Derived) -> Reach {
        match what {
            Derived::Slope | Derived::Aspect | Derived::ProfileCurvature | Derived::PlanCurvature => Reach::Cells(1),
            // The window is rounded to whole cells.
            Derived::LocalRelief => Reach::Distance(1.5 * self.radius.si()),
            // Sums slide along rows; light and water come from afar.
            Derived::PositionIndex | Derived::Exposure | Derived::SpreadArea => Reach::Whole,
        }
    }

    /// The values of a field.
    fn field(&self, what: Derived, terrain: &HeightField) -> Vec<f64> {
        let (grid, z) = (terrain.grid(), terrain.elevation());
        let cell = grid.spacing[0].max(grid.spacing[1]);
        let radius = (self.radius.si() / cell).round().max(1.0) as usize;
        match what {
            Derived::Slope => slope(grid, z),
            Derived::Aspect => parallel::map(z.len(), |i| gradient(grid, z, i).aspect().to_degrees()),
            Derived::ProfileCurvature => parallel::map(z.len(), |i| quadratic(grid, z, i).profile_curvature()),
            Derived::PlanCurvature => parallel::map(z.len(), |i| quadratic(grid, z, i).plan_curvature()),
            Derived::PositionIndex => position_index(grid.shape, z, radius),
            Derived::LocalRelief => local_relief(grid.shape, z, radius),
            Derived::Exposure => {
                let dark = shadow(grid, z, self.light_from.si(), self.altitude.si());
                let value = |i: usize| if z[i].is_nan() { f64::NAN } else { f64::from(u8::from(!dark[i])) };
                parallel::map(z.len(), value)
            }
            Derived::SpreadArea => {
                let domain = terrain.domain();
                let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
                flow.route(&*domain, z, &mut area);
                let mut area = node_areas(&*domain);
                flow.accumulate_infinity(&domain, grid, z, &mut area);
                area
            }
        }
    }
}

impl Edit<HeightField> for Derive {
    fn edit(&self, terrain: &mut HeightField, _: &Context) -> Result<()> {
        if self.fields.is_empty() {
            return Err(Error::parameter("fields", "[]", "at least one field, for example [\"slope\"]"));
        }
        for &what in &self.fields {
            let values = self.field(what, terrain);
            terrain.fields.insert(what.key(), values)?;
        }
        Ok(())
    }
}
