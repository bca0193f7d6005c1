//! Starting surfaces.

mod flat;
mod noise;
mod spectral_fbm;
mod stream_graph;

pub use flat::Flat;
pub use noise::Noise;
pub use spectral_fbm::SpectralFbm;
pub use stream_graph::StreamGraph;

use landform_core::Result;
use landform_core::grid::Grid;
use landform_core::units::Length;
use landform_core::verb::Estimate;

/// Raster of a generator: `size` (east, north) in cells of `cell_size`.
fn raster(size: [Length; 2], cell_size: Length) -> Result<Grid> {
    Grid::covering(size.map(Length::si), cell_size.si())
}

/// Needs of a raster with so many scratch values a node.
fn raster_estimate(size: [Length; 2], cell_size: Length, scratch: u64) -> Result<Estimate> {
    let nodes = raster(size, cell_size)?.len() as u64;
    Ok(Estimate { nodes, bytes: nodes * 8 * (1 + scratch), extent: size.map(Length::si) })
}
