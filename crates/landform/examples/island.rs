//! An island rises out of the sea and rivers cut it: a raster, a mesh and a picture in a line each.
//!
//! `cargo run --release --example island` writes island.tif, island.glb and island.png into the
//! folder it is run in.

use landform::core::verb::{Formula, NamedOutlets, Outlets};
use landform::prelude::*;

/// An island in 24 km of sea, after some millions of years; nodes at least `spacing` m apart.
pub(crate) fn island(spacing: f64, millions_of_years: f64) -> Result<Landscape> {
    let sea_floor = StreamGraph {
        size: [metres(24_000.0); 2],
        spacing: Some(metres(spacing)),
        elevation: metres(-60.0),
        ..StreamGraph::default()
    };
    let mut land = Landscape::from(sea_floor.generate(&Context::default())?);
    land.title = "An island".into();
    // r is 0 in the middle and 1 half a side away from it.
    let formula = Formula::parse("0.7*smoothstep(0.85, 0.2, r + 0.35*noise(x/7000, y/7000))")?;
    let rivers = StreamPower {
        sea_level: Some(metres(0.0).into()),
        outlets: Some(Outlets::Named(NamedOutlets::Sea)),
        ..StreamPower::default()
    };
    land.evolve(kyr(50.0), myr(millions_of_years))
        .with(Uplift { rate: Varying::Formula { formula, unit: "mm/yr".into() } })
        .with(rivers)
        .run()?;
    land.apply(ToHeightField { cell_size: metres(0.5 * spacing), ..ToHeightField::default() })?;
    Ok(land)
}

fn main() -> Result<()> {
    let land = island(120.0, 3.0)?;
    land.save_raster("elevation", "island.tif")?;
    land.save_mesh("island.glb")?;
    land.save_picture("island.png")
}
