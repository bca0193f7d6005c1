//! The report card's verdict on a bank of fakes, and on crops of real ground.

use std::path::Path;
use std::sync::Arc;

use landform::core::analysis::{metrics, report_card, verdict};
use landform::core::grid::{Grid, Shape};
use landform::core::terrain::{HeightField, NodeSurface};
use landform::core::verb::MemoryOutput;
use landform::core::{Error, Result};
use landform::io::format::read_raster;
use landform::recipe::{AnyTerrain, Options, Outputs, Ran, Recipe};

/// Side of a crop, nodes.
const SIDE: usize = 256;
/// Least share of a crop with data.
const LEAST_DATA: f64 = 0.95;

fn fakes() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src/validate/card/fakes"))
}

/// Title and reason of the verdict.
fn judge(ground: &HeightField) -> Result<(String, String)> {
    let (measured, _) = metrics(ground, None)?;
    let found = verdict(&measured, &report_card(&measured));
    Ok((found.title, found.reason))
}

fn passes(title: &str) -> bool {
    title.starts_with("Like natural ground")
}

/// The ground of a recipe of the bank.
fn fake(name: &str) -> Result<Arc<AnyTerrain>> {
    let path = fakes().join(format!("{name}.toml"));
    let text = std::fs::read_to_string(&path).map_err(|e| Error::io("read", &path, e))?;
    let recipe = Recipe::parse(&text, name, fakes(), &[])?;
    let quiet = Options { outputs: Outputs::Nothing, ..Options::default() };
    match recipe.run(&mut MemoryOutput::default(), &quiet)? {
        Ran::ToTheEnd(terrain, _) => Ok(terrain),
        _ => Err(Error::Empty { what: "the run".into() }),
    }
}

fn names() -> Vec<String> {
    let files = std::fs::read_dir(fakes()).into_iter().flatten().flatten();
    let stem = |f: std::fs::DirEntry| f.path().file_stem().map(|s| s.to_string_lossy().into_owned());
    let mut names: Vec<String> = files.filter_map(stem).collect();
    names.sort_unstable();
    names
}

/// The square of some side at a place; none where too much of it is without data.
fn crop(ground: &HeightField, row: usize, col: usize) -> Option<HeightField> {
    let (grid, z) = (ground.grid(), ground.elevation());
    let square: Vec<f64> = (0..SIDE * SIDE).map(|i| z[grid.shape.index(row + i / SIDE, col + i % SIDE)]).collect();
    let with_data = square.iter().filter(|v| !v.is_nan()).count() as f64;
    if with_data < LEAST_DATA * square.len() as f64 {
        return None;
    }
    HeightField::new(Grid::new(Shape::new(SIDE, SIDE), grid.spacing).ok()?, square).ok()
}

/// Crops that do not overlap, a quarter of a side apart.
fn crops(ground: &HeightField) -> Vec<HeightField> {
    let shape = ground.grid().shape;
    let mut taken: Vec<(usize, usize)> = Vec::new();
    let mut found = Vec::new();
    for row in (0..(shape.rows + 1).saturating_sub(SIDE)).step_by(SIDE / 4) {
        for col in (0..(shape.cols + 1).saturating_sub(SIDE)).step_by(SIDE / 4) {
            if taken.iter().any(|&(r, c)| row.abs_diff(r) < SIDE && col.abs_diff(c) < SIDE) {
                continue;
            }
            if let Some(square) = crop(ground, row, col) {
                taken.push((row, col));
                found.push(square);
            }
        }
    }
    found
}

/// Prints the verdict on every fake, and on crops of the elevation files of a folder, in metres.
pub(super) fn study(real: Option<&Path>) -> Result<()> {
    println!("\nVerdicts of the report card on a bank of fakes");
    let (mut told, names) = (0, names());
    for name in &names {
        let ground = fake(name)?;
        let (title, reason) = judge(ground.get(name)?)?;
        told += usize::from(!passes(&title));
        println!("{name:>32}  {title}. {reason}");
    }
    println!("{told} of {} fakes told", names.len());
    let Some(folder) = real else { return Ok(()) };
    let files = std::fs::read_dir(folder).map_err(|e| Error::io("read", folder, e))?;
    let mut files: Vec<_> = files.flatten().map(|f| f.path()).collect();
    files.sort_unstable();
    println!("\nVerdicts on crops of {SIDE} x {SIDE} nodes of real ground");
    for file in files {
        // Files of other kinds, and of ground too small, have no crops.
        let Ok(reading) = read_raster(&file) else { continue };
        let titles: Result<Vec<_>> = crops(&reading.field).iter().map(judge).collect();
        let titles = titles?;
        let passed = titles.iter().filter(|t| passes(&t.0)).count();
        println!("{:>5} of {:>3} like natural ground: {}", passed, titles.len(), file.display());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fakes_of_every_kind_are_told() {
        let some =
            ["fbm_gentle_filled", "fbm_blurred_filled", "voronoi_filled", "faults", "talus_cone", "dunes_of_stars"];
        for name in some {
            let (title, reason) = judge(fake(name).unwrap().get(name).unwrap()).unwrap();
            assert!(!passes(&title), "{name}: {title}. {reason}");
        }
    }

    #[test]
    fn real_crops_pass() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/landform-io/tests/data/reference");
        for name in ["cevennes_crop.tif", "tujunga_crop.tif"] {
            let field = read_raster(&folder.join(name)).unwrap().field;
            let square = HeightField::new(
                Grid::new(field.grid().shape, field.grid().spacing).unwrap(),
                field.elevation().to_vec(),
            );
            let (title, reason) = judge(&square.unwrap()).unwrap();
            assert!(passes(&title), "{name}: {title}. {reason}");
        }
    }
}
