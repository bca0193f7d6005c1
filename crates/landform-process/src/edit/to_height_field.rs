//! From a mesh to a raster.

use landform_core::Result;
use landform_core::algo::flow::Flow;
use landform_core::algo::outlets::at_or_under;
use landform_core::field::names;
use landform_core::terrain::{
    HeightField, Layer, Mesh, NodeSurface, cubic_from_mesh, gaussian_from_mesh, height_field_from_mesh, sea_level,
};
use landform_core::units::Length;
use landform_core::verb::{Convert, Estimate, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::mechanism::write_drainage_fields;

/// Turns a mesh into a raster, with its fields, linear on every triangle. Drainage area and basins
/// are routed anew, so that rivers run through the raster's own valleys.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ToHeightField {
    /// Distance between nodes; adjusted so that a whole number of cells fits.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub cell_size: Length,
    /// How elevation is carried over.
    pub method: Method,
    /// Gaussian only: width of the kernel, in cells.
    #[schemars(extend("x-min" = 0.3, "x-max" = 50.0))]
    pub sigma: f64,
}

/// How elevation is carried over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Linear on every triangle: slopes and ridges as they are.
    Linear,
    /// Smooth curves through the nodes (Clough and Tocher): no facets, but a little beyond the
    /// nodes where the ground bends sharply. For cells that are smaller than the distance between
    /// nodes.
    Cubic,
    /// The mean of nodes under a Gaussian kernel (Bell's thesis): smooth, and lower on ridges.
    Gaussian,
}

impl Default for ToHeightField {
    fn default() -> Self {
        Self { cell_size: Length::of(50.0), method: Method::Linear, sigma: 2.0 }
    }
}

impl Params for ToHeightField {
    const NAME: &'static str = "to_height_field";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Clough & Tocher (1965)",
        title: "Finite element stiffness matrices for analysis of plate bending, Proc. 1st Conf. Matrix Methods in Structural Mechanics",
        doi: "",
    }];

    fn warning(&self, before: &Estimate, _: f64) -> Option<String> {
        let (cell, spacing) = (self.cell_size.si(), before.spacing()?);
        (self.method == Method::Linear && cell < 0.75 * spacing).then(|| {
            format!(
                "cells of {cell} m are finer than the mesh, whose nodes stand about {spacing:.0} m apart: its \
                 triangles show as facets; `method = \"cubic\"` rounds them, a finer mesh has more to show"
            )
        })
    }
}

impl Convert<Mesh, HeightField> for ToHeightField {
    fn convert(&self, source: &Mesh) -> Result<HeightField> {
        let mut field = height_field_from_mesh(source, self.cell_size.si())?;
        let smooth = match self.method {
            Method::Linear => None,
            Method::Cubic => Some(cubic_from_mesh(source, &field)),
            Method::Gaussian => Some(gaussian_from_mesh(source, &field, self.sigma)),
        };
        if let Some(smooth) = smooth {
            field.change(Layer::Bedrock, |z| z.copy_from_slice(&smooth));
            let sea = source.chosen_status().and_then(|status| sea_level(status, source.elevation()));
            if let Some(level) = sea {
                let status = at_or_under(level, &field);
                field.set_status(Some(status));
            }
        }
        if field.fields.get(&names::DRAINAGE_AREA, "").is_ok() {
            let depth = field.fields.remove(names::LAKE_DEPTH.name);
            let domain = field.domain();
            write_drainage_fields(&mut field, &domain, &mut Flow::new(), None)?;
            // Between nodes there are depressions that the mesh does not have.
            if let Some(depth) = depth {
                field.fields.insert_values(names::LAKE_DEPTH.name, depth)?;
            }
        }
        Ok(field)
    }

    fn estimate(&self, source: Estimate) -> Estimate {
        let nodes = source.raster_nodes(self.cell_size.si());
        Estimate { nodes, bytes: source.nodes * 250 + nodes * 60, ..source }
    }
}
