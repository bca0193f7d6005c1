//! Coral islands and the growth of reefs.
//!
//! # Model
//! Corals build as fast as light lets them: G(w) = G_m tanh((I_0 / I_k) e^(-k w)) at the depth w,
//! up to low water and no higher. Over ground that sinks, or under a sea that rises, by s,
//! dw/dt = s - e G(w). Where G(w) = s, at w*, a reef is at the edge: from less depth it catches up
//! with the sea and then keeps up, from more it gives up. e, from 0 to 1, is the part that shelter
//! leaves: it falls with the distance to open water, e^(-d / restriction). So an old reef builds a
//! rim and leaves a lagoon, whose floor receives the sand that the rim sheds.
//!
//! # Symbols
//! G_m `max_rate`, I_0 `light`, I_k `saturation`, k `extinction`; d distance over the sea to open
//! water, which is deeper than `open_depth` and in reach of the map's border.
//!
//! # Method
//! Each node by itself within a step, with ground and sea that move steadily through it: a place
//! that reaches low water at the rate of its greatest depth is set there, the others go by the
//! midpoint rule in parts in which light changes little. So steps of a kyr do not overshoot. Growth
//! for which a reef at low water has no room is lost but for the part `shed`, which settles in
//! enclosed water deeper than `lagoon_depth`, more where it is deeper. Whenever the sea has moved
//! over the ground by 15 % of a cell's width, open water and distances to it are found anew, and
//! coral that stands under water steeper than `talus_angle` slips, from the highest down.
//! **Cost** O(n), and O(r log r) for the r nodes of reef where they are found anew.
//!
//! # Limits
//! One coral: no zones by depth or species, and none by waves, wind or temperature. No erosion by
//! waves and no karst, so that dry reef stays as it is unless another process acts on it; no islets
//! of rubble on the rim. The law of shelter is our own choice of a form: published models agree
//! that growth falls away from open water, not on how. Rubble of the front and reef are one
//! material, "coral"; "sediment" of a lagoon lies on it even where coral grew later. Open water
//! comes and goes with a step as a passage opens.
//!
//! # Sources
//! Bosscher & Schlager (1992), eq. 2, for G and its ranges; Neumann & Macintyre (1985) for keep-up,
//! catch-up and give-up; Nakamura & Nakamori (2007) for growth that falls away from open water by
//! what the water still carries; Schlager, Reijmer & Droxler (1994) for what reefs at the surface
//! shed. Darwin (1842) and Daly (1915) for the histories that recipes tell; Droxler & Jorry (2021)
//! dispute Darwin's. The draft of Hartley's thesis scales the ground about a zero level to sink an
//! island, which keeps its shore in place and leaves no lagoon: here the ground is lowered.
//!
//! # Checked by
//! `tests` here and in the files: CR1 to CR8, mass, steps of any length, histories of the sea.
//!
//! # Example
//! A shelf 20 m under the sea grows up to low water within 5 kyr and stays there:
//!
//! ```
//! use landform_core::grid::{Edge, Edges, Grid, Shape};
//! use landform_core::sim::Model;
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::units::KYR;
//! use landform_process::reef::ReefGrowth;
//!
//! let mut grid = Grid::new(Shape::new(9, 9), [10.0, 10.0])?;
//! grid.edges = Edges::all(Edge::Closed);
//! let mut model = Model::new(HeightField::new(grid, vec![-20.0; 81])?).dt(KYR);
//! model.add(ReefGrowth::default())?;
//! model.advance_steps(5)?;
//! assert!((model.terrain().elevation()[0] + 0.5).abs() < 1e-9);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod growth;
mod island;
mod labels;
mod light;
mod open_water;
mod params;
mod talus;
#[cfg(test)]
mod tests;

pub use island::{BandParams, CoralIsland, OutlineParams, WarpParams};
pub use light::{Light, Water};
pub use params::ReefGrowth;

use landform_core::terrain::{HeightField, Mesh};

/// The material of reefs and their rubble.
const CORAL: &str = "coral";
/// The material that settles in lagoons.
const SEDIMENT: &str = "sediment";

landform_core::stages! {
    generate CoralIsland => HeightField;
    process ReefGrowth where HeightField, Mesh;
}
