//! Karst networks: passages from sinkholes to springs, in rock with beds and fractures.
//!
//! # Method
//! Water of a sinkhole falls to the water table by shafts and short meanders. From there a network
//! leads to the springs. It grows from the springs towards the feet of the shafts (space
//! colonisation), or follows the cheapest ways through random places in the rock, thinned to a
//! gamma-graph (Paris et al. 2021). Both ask the rock what a way costs per metre. Loops are closed
//! between passages that lie near each other and far apart along the network; radii follow from the
//! water that each passage carries: at a junction r³ is the sum of those of the passages that join.
//!
//! # Checked by
//! `tests`: every sinkhole reaches a spring, no passage leaves the rock or enters a forbidden
//! sphere, shares of water and radii at junctions and springs, azimuths of fractures, distance to
//! beds against a control, length against the distance of samples, same bytes on any number of
//! threads, and statistics against natural networks.
//!
//! ```
//! use landform_core::feature::{ConduitNetwork, FeatureKind};
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::verb::{Context, Edit};
//! use landform_process::karst::KarstNetwork;
//!
//! let mut plateau = HeightField::new(Grid::new(Shape::new(41, 41), [25.0; 2])?, vec![120.0; 1681])?;
//! let network: KarstNetwork = serde_json::from_str(
//!     r#"{ "sinkholes": 12, "springs": [ { "at": ["950 m", "100 m"], "water_table": "20 m" } ] }"#,
//! ).map_err(|e| landform_core::Error::parameter("json", e, "parameters"))?;
//! network.edit(&mut plateau, &Context::default())?;
//! assert_eq!(plateau.features().of(FeatureKind::Sinkhole).count(), 12);
//! assert!(ConduitNetwork::of(plateau.features()).length() > 1_000.0);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod colonise;
mod grow;
mod keys;
mod leads;
mod loops;
mod maze;
mod near;
mod params;
mod preset;
mod radii;
mod rock;
mod shortest;
mod space;
#[cfg(test)]
mod tests;
mod wander;

use landform_core::terrain::HeightField;

pub use params::{Bed, Forbidden, Fracture, KarstNetwork, Method, Sinkholes, Spring};
pub use preset::Preset;

landform_core::stages! {
    edit KarstNetwork where HeightField;
}
