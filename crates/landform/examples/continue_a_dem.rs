//! Real ground, and what becomes of it: a DEM is read, coarsened, worn for half a million years and
//! written where it was, in its own coordinates.
//!
//! `cargo run --release --example continue_a_dem [DEM.tif]` writes later.tif and later.png into the
//! folder it is run in. Without a name it takes a catchment in the San Gabriel Mountains.

use std::path::Path;

use landform::prelude::*;
use landform::process::edit::Resample;

/// The ground of a file on cells of `cell` m, before and after some thousands of years.
pub(crate) fn continued(dem: &Path, cell: f64, thousands_of_years: f64) -> Result<[Landscape; 2]> {
    let mut before = Landscape::open(dem)?;
    before.apply(Resample { cell_size: metres(cell), ..Resample::default() })?;
    let mut after = before.clone();
    after
        .evolve(kyr(10.0), kyr(thousands_of_years))
        .with(Uplift { rate: mm_per_yr(0.5).into() })
        .with(StreamPower::default())
        .with(LinearDiffusion::default())
        .run()?;
    Ok([before, after])
}

fn main() -> Result<()> {
    let catchment = Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery/data/big_tujunga_ca_srtm1_utm11.tif");
    let dem = std::env::args().nth(1).map_or(catchment, Into::into);
    let [_, later] = continued(&dem, 90.0, 500.0)?;
    later.save_raster("elevation", "later.tif")?;
    later.save_picture("later.png")
}
