use landform_core::grid::{Georeference, Grid, Registration, Shape};
use landform_core::terrain::{HeightField, NodeSurface};

use super::*;
use crate::format::reading::{Beside, decide};
use crate::format::{RasterFile, Samples};

fn again(file: &RasterFile) -> HeightField {
    decide(NAME, read(&write(file).unwrap(), None).unwrap(), Beside::default()).unwrap().field
}

fn field(rows: usize, cols: usize, georeference: Georeference) -> HeightField {
    let mut grid = Grid::new(Shape::new(rows, cols), [30.0, 25.0]).unwrap();
    grid.origin = [350_015.0, 3_800_040.0];
    grid.georeference = georeference;
    let z = (0..grid.len()).map(|i| {
        if i % 17 == 3 { f64::NAN } else { f64::from((landform_core::math::sin(i as f64 * 0.37) * 900.0) as f32) }
    });
    HeightField::new(grid.clone(), z.collect()).unwrap()
}

fn options() -> Vec<GeotiffOptions> {
    let mut all = Vec::new();
    for data_type in [DataType::Float32, DataType::Int16] {
        for compression in [Compression::Deflate, Compression::Lzw, Compression::None] {
            for tile in [Some(16), Some(64), None] {
                all.push(GeotiffOptions { data_type, compression, tile });
            }
        }
    }
    all
}

#[test]
fn every_layout_is_read_back_with_its_georeference() {
    for (rows, cols) in [(40, 53), (1, 1), (130, 3)] {
        for epsg in [Some(32_611), None] {
            for registration in [Registration::Area, Registration::Point] {
                let source = field(rows, cols, Georeference { epsg, registration, ..Georeference::default() });
                for geotiff in options() {
                    let file = RasterFile {
                        spread: None,
                        grid: source.grid(),
                        values: source.elevation(),
                        field: "elevation",
                        unit: "m",
                        samples: Samples::Real,
                        legend: Vec::new(),
                        seed: 1,
                        geotiff,
                    };
                    let back = again(&file);
                    let mut expected = source.grid().clone();
                    if epsg.is_none() {
                        expected.georeference.registration = Registration::Area;
                    }
                    assert_eq!(*back.grid(), expected, "{geotiff:?}");
                    for (a, b) in source.elevation().iter().zip(back.elevation()) {
                        let expected = if geotiff.data_type == DataType::Int16 { a.round() } else { *a };
                        assert!(expected == *b || (a.is_nan() && b.is_nan()), "{geotiff:?}: {a} {b}");
                    }
                }
            }
        }
    }
}

#[test]
fn longitude_and_latitude_are_known_as_such() {
    let source = field(8, 9, {
        let registration = Registration::Area;
        Georeference { epsg: Some(4326), geographic: true, registration, ..Georeference::default() }
    });
    let file = RasterFile {
        spread: None,
        grid: source.grid(),
        values: source.elevation(),
        field: "elevation",
        unit: "m",
        samples: Samples::Real,
        legend: Vec::new(),
        seed: 1,
        geotiff: GeotiffOptions::default(),
    };
    assert!(again(&file).grid().georeference.geographic);
}
