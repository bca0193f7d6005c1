//! Duran's sandpile: a rough heap of slabs slips until nothing stands too steep, and becomes hills
//! (Pytel 2015, figure 3.1, top row).
//!
//! `cargo run --release --example sandpile` writes sandpile.png and sandpile_spectrum.png into the
//! folder it is run in.

use landform::core::Result;
use landform::core::agents::Sand;
use landform::core::analysis::density;
use landform::core::grid::{Edge, Edges, Grid, Shape};
use landform::core::random::Seed;
use landform::core::terrain::HeightField;
use landform::io::format::encode_png;
use landform::io::render::{MapStyle, Ramp, shaded_map, value_picture};

/// Slabs of sand at random heights on a torus of n by n sites, after they have slipped; and before.
pub(crate) fn sandpile(n: usize, seed: u64) -> Result<[HeightField; 2]> {
    let mut grid = Grid::new(Shape::new(n, n), [1.0, 1.0])?;
    grid.edges = Edges::all(Edge::Periodic);
    // Two slabs are the most that one site may stand above the next, three along the diagonal.
    let mut sand = Sand::new(grid.shape, true, vec![0; n * n], [2, 2, 3], 1);
    let mut draws = Seed(seed).draws();
    for site in 0..n * n {
        sand.lay(site, draws.below(64) as i32);
    }
    let heights = |sand: &Sand| sand.surface().iter().map(|&h| f64::from(h) / 3.0).collect();
    let before = HeightField::new(grid.clone(), heights(&sand))?;
    // Every slab that slips may set off others: above it, where it leaves a gap, and where it comes
    // to rest.
    sand.settle();
    Ok([before, HeightField::new(grid, heights(&sand))?])
}

fn main() -> Result<()> {
    let [_, after] = sandpile(256, 1)?;
    let map = shaded_map(&after, &MapStyle { water: false, ..MapStyle::default() })?;
    let write = |path: &str, bytes: Vec<u8>| {
        std::fs::write(path, bytes).map_err(|e| landform::core::Error::io("write", std::path::Path::new(path), e))
    };
    write("sandpile.png", encode_png(&map.pixels, map.shape)?)?;
    if let Some((_, density)) = density(after.grid(), landform::core::terrain::NodeSurface::elevation(&after), false) {
        let plot = value_picture(Shape::new(512, 512), &density.log_plot(512), Ramp::Dusk);
        write("sandpile_spectrum.png", encode_png(&plot.pixels, plot.shape)?)?;
    }
    Ok(())
}
