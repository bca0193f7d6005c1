//! Starting surfaces.
//!
//! The top of a cone is the middle of its map:
//!
//! ```
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::units::Length;
//! use landform_core::verb::{Context, Generator};
//! use landform_process::generate::{Form, GridParams, Shape};
//!
//! let grid = GridParams::of([1_000.0, 1_000.0], 100.0);
//! let cone = Shape { grid, form: Form::Cone, high: Length::of(300.0), ..Shape::default() };
//! let ground: HeightField = cone.generate(&Context::default())?;
//! assert!((ground.elevation()[60] - 300.0).abs() < 1e-9);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod blend;
mod faulting;
mod flat;
mod layered_ground;
mod midpoint_displacement;
mod noise;
mod shape;
mod spectral_fbm;
mod stream_graph;
mod surface;

pub use crate::mechanism::GridParams;
pub use blend::{Blend, BlendMode};
pub use faulting::Faulting;
pub use flat::Flat;
pub use layered_ground::{BedParams, FoldParams, JointParams, LayeredGround, LooseParams, RockKind, SequenceParams};
pub use midpoint_displacement::MidpointDisplacement;
pub use noise::Noise;
pub use shape::{Form, Shape};
pub use spectral_fbm::SpectralFbm;
pub use stream_graph::StreamGraph;
pub use surface::Surface;

use landform_core::Result;
use landform_core::grid::Grid;
use landform_core::terrain::{HeightField, Mesh};
use landform_core::verb::{Context, Estimate, Generator, Params};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

landform_core::stages! {
    generate StreamGraph => Mesh;
    generate Faulting => HeightField;
    generate Flat => HeightField;
    generate LayeredGround => HeightField;
    generate MidpointDisplacement => HeightField;
    generate Noise => HeightField;
    generate Shape => HeightField;
    generate SpectralFbm => HeightField;
    generate Surface => HeightField;
    edit Blend where HeightField;
}

/// A generator that can make its surface on any grid: as ground of its own, or as a layer of
/// [`Blend`].
pub(crate) trait OnGrid: Params {
    /// Extent and distance between nodes when it stands alone.
    fn grid(&self) -> &GridParams;

    /// Elevations on a grid, m.
    fn elevations(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>>;

    /// Bytes of scratch that `nodes` need.
    fn scratch(&self, nodes: u64) -> u64 {
        8 * nodes
    }
}

/// The surface of a generator on its own grid.
fn alone(generator: &impl OnGrid, context: &Context) -> Result<HeightField> {
    let grid = context.wanted(generator.grid().grid()?)?;
    let elevations = generator.elevations(&grid, context)?;
    HeightField::new(grid, elevations)
}

/// Memory that the generator needs.
fn alone_estimate(generator: &impl OnGrid, context: &Context) -> Result<Estimate> {
    let grid = context.wanted(generator.grid().grid()?)?;
    let (nodes, extent) = (grid.len() as u64, grid.extent());
    Ok(Estimate {
        nodes,
        bytes: 8 * nodes + generator.scratch(nodes),
        extent,
        origin: Some([0.0; 2]),
        ..Estimate::default()
    })
}

/// Makes generators of what is [`OnGrid`], and each a layer of [`Blend`].
macro_rules! on_grid {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        $(impl Generator<HeightField> for $name {
            fn generate(&self, context: &Context) -> Result<HeightField> {
                alone(self, context)
            }

            fn estimate(&self, context: &Context) -> Result<Estimate> {
                alone_estimate(self, context)
            }
        })*

        /// A generator that works on any raster.
        #[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
        #[serde(tag = "use", rename_all = "snake_case")]
        pub enum Layer {
            $($(#[$doc])* $name($name),)*
        }

        impl Layer {
            fn generator(&self) -> &dyn blend::LayerGenerator {
                match self {
                    $(Self::$name(p) => p,)*
                }
            }
        }
    };
}

on_grid! {
    /// Ground broken by faults.
    Faulting,
    /// Level ground.
    Flat,
    /// Fractal ground by subdivision.
    MidpointDisplacement,
    /// Octaves of noise.
    Noise,
    /// A simple shape.
    Shape,
    /// Fractional Brownian ground.
    SpectralFbm,
    /// Ground from a map or a formula.
    Surface,
}
