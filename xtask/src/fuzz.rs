//! Damaged files against every reader. A reader may refuse, never panic; a panic stops the run and
//! leaves the file.
//!
//! Seeds are valid files of each format, made on the spot; damage is cuts, splices, flipped bits
//! and extreme integers, drawn from a seed of the clock, which is printed.

use std::path::Path;
use std::time::{Instant, SystemTime};

use landform::core::grid::{Grid, Shape};
use landform::core::random::{Draws, Seed};
use landform::core::terrain::{HeightField, NodeSurface};
use landform::io::format::{Compression, DataType, GeotiffOptions, RASTER_FORMATS, RasterFile, Sidecar, read_grey};
use landform::recipe::Recipe;

/// Spends `seconds` on each reader.
pub(crate) fn run(seconds: f64) -> bool {
    let clock = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |d| d.as_nanos() as u64);
    println!("seed {clock}");
    let mut fine = true;
    for format in RASTER_FORMATS {
        let seeds = seeds(format.write);
        fine &= hammer(format.name, &seeds, seconds, Seed(clock), |bytes| {
            format.read(bytes, None).ok();
        });
    }
    let pictures = seeds_of("PNG");
    fine &= hammer("grey picture", &pictures, seconds, Seed(clock), |bytes| {
        read_grey(bytes).ok();
    });
    let sidecar = br#"{"dx_m": 3, "scale": 1e-3, "width": 4, "height": 4, "crs": "EPSG:32611"}"#.to_vec();
    fine &= hammer("sidecar", &[sidecar], seconds, Seed(clock), |bytes| {
        Sidecar::parse(bytes).ok();
    });
    let recipes: Vec<Vec<u8>> = landform::recipe::GALLERY.iter().map(|r| r.text.as_bytes().to_vec()).collect();
    fine &= hammer("recipe", &recipes, seconds, Seed(clock), |bytes| {
        Recipe::parse(&String::from_utf8_lossy(bytes), "fuzz", Path::new("."), &[]).ok();
    });
    fine
}

type Write = fn(&RasterFile) -> landform::core::Result<Vec<u8>>;

fn seeds_of(name: &str) -> Vec<Vec<u8>> {
    RASTER_FORMATS.iter().filter(|f| f.name == name).flat_map(|f| seeds(f.write)).collect()
}

fn seeds(write: Write) -> Vec<Vec<u8>> {
    let mut all = Vec::new();
    for (rows, cols) in [(1, 1), (9, 14), (40, 33)] {
        let Ok(grid) = Grid::new(Shape::new(rows, cols), [10.0, 10.0]) else { continue };
        let z = (0..grid.len()).map(|i| if i % 11 == 5 { f64::NAN } else { (i as f64).sqrt() * 7.0 }).collect();
        let Ok(field) = HeightField::new(grid, z) else { continue };
        for data_type in [DataType::Float32, DataType::Float64, DataType::Int16] {
            for compression in [Compression::Deflate, Compression::Lzw, Compression::None] {
                for tile in [Some(16), None] {
                    let geotiff = GeotiffOptions { data_type, compression, tile };
                    let values = field.elevation();
                    let file = RasterFile::real(field.grid(), values, "elevation", "m", 0);
                    all.extend(write(&RasterFile { geotiff, ..file }));
                }
            }
        }
    }
    all.sort();
    all.dedup();
    all
}

fn hammer(
    name: &str,
    seeds: &[Vec<u8>],
    seconds: f64,
    seed: Seed,
    read: impl Fn(&[u8]) + std::panic::RefUnwindSafe,
) -> bool {
    let start = Instant::now();
    let mut count = 0u64;
    while start.elapsed().as_secs_f64() < seconds {
        let mut draws = seed.named(name).with(count).draws();
        let bytes = damage(seeds, &mut draws);
        count += 1;
        if std::panic::catch_unwind(|| read(&bytes)).is_err() {
            let path = std::env::temp_dir().join(format!("landform-fuzz-{}", name.replace(' ', "-")));
            std::fs::write(&path, &bytes).ok();
            eprintln!("{name}: PANIC; the file is {}", path.display());
            return false;
        }
    }
    println!("{name}: {count} files, no panic");
    true
}

fn damage(seeds: &[Vec<u8>], draws: &mut Draws) -> Vec<u8> {
    let mut bytes = seeds[draws.below(seeds.len())].clone();
    for _ in 0..1 + draws.below(8) {
        if bytes.is_empty() {
            break;
        }
        let at = draws.below(bytes.len());
        match draws.below(7) {
            0 => bytes[at] ^= 1 << draws.below(8),
            1 => bytes[at] = [0, 0xff, 0x7f, 0x80, b'9', b'-'][draws.below(6)],
            2 => bytes.truncate(at),
            3 => {
                let end = (at + 4).min(bytes.len());
                bytes[at..end].fill([0, 0xff, 0x7f][draws.below(3)]);
            }
            4 => {
                let end = (at + 1 + draws.below(40)).min(bytes.len());
                bytes.drain(at..end);
            }
            5 => {
                let end = (at + 1 + draws.below(40)).min(bytes.len());
                let copy = bytes[at..end].to_vec();
                let to = draws.below(bytes.len());
                bytes.splice(to..to, copy);
            }
            _ => {
                let other = &seeds[draws.below(seeds.len())];
                let cut = draws.below(other.len());
                bytes.truncate(at);
                bytes.extend(&other[cut..]);
            }
        }
    }
    bytes
}
