use landform_core::grid::Grid;
use landform_core::terrain::NodeSurface;

use super::*;
use crate::format::raster_format;

fn file(epsg: Option<u16>) -> (Grid, Vec<f64>) {
    let mut grid = Grid::new(Shape::new(3, 4), [20.0, 25.0]).unwrap();
    grid.origin = [400_000.0, 5_000_000.0];
    grid.georeference.epsg = epsg;
    (grid, (0..12).map(f64::from).collect())
}

#[test]
fn a_file_is_the_specification_byte_by_byte() {
    let (grid, values) = file(None);
    let bytes = write(&RasterFile::real(&grid, &values, "elevation", "m", 0)).unwrap();
    assert_eq!(bytes[..8], [b'C', b'D', b'F', 1, 0, 0, 0, 0]);
    // Two dimensions: y of 3, x of 4.
    let dimensions =
        [0, 0, 0, 10, 0, 0, 0, 2, 0, 0, 0, 1, b'y', 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 1, b'x', 0, 0, 0, 0, 0, 0, 4];
    assert_eq!(bytes[8..40], dimensions);
    // The last numbers are the field's, in 32 bits, the last one 11.
    assert_eq!(bytes[bytes.len() - 4..], 11.0_f32.to_be_bytes());
    assert_eq!(bytes.len() % 4, 0);
}

#[test]
fn place_and_system_come_back_from_either_end() {
    let (grid, values) = file(Some(32_611));
    let format = raster_format("a.nc".as_ref()).unwrap();
    let bytes = write(&RasterFile::real(&grid, &values, "elevation", "m", 0)).unwrap();
    let back = format.read(&bytes, None).unwrap();
    assert_eq!((back.grid().origin, back.grid().spacing, back.epsg()), (grid.origin, grid.spacing, Some(32_611)));
    assert_eq!(back.elevation(), values);
    // As others write it: rows from the south.
    let mut out = Writer::new(&[("y", 3), ("x", 4)]);
    let metres = || vec![("units", Attribute::of_text("m"))];
    out.variable("y", &[0], metres(), Kind::Float, vec![0.0, 25.0, 50.0]);
    out.variable("x", &[1], metres(), Kind::Double, vec![0.0, 20.0, 40.0, 60.0]);
    let packed = vec![
        ("scale_factor", Attribute::Numbers(Kind::Double, vec![0.5])),
        ("_FillValue", Attribute::Numbers(Kind::Short, vec![-1.0])),
    ];
    let mut numbers = values.clone();
    numbers[5] = -1.0;
    out.variable("z", &[0, 1], packed, Kind::Short, numbers);
    let back = format.read(&out.bytes().unwrap(), None).unwrap();
    assert_eq!((back.grid().origin, back.grid().spacing), ([0.0, 50.0], [20.0, 25.0]));
    assert_eq!(back.elevation()[..4], [4.0, 4.5, 5.0, 5.5]);
    assert!(back.elevation()[5].is_nan() && back.elevation()[11] == 1.5);
}

#[test]
fn what_is_no_raster_is_told() {
    let told = |bytes: &[u8]| read(bytes, None).unwrap_err().to_string();
    assert!(told(b"\x89HDF\r\n\x1a\n").contains("netCDF-4"));
    assert!(told(b"CDF\x05").contains("classic format"));
    assert!(told(b"CDF\x01\0\0\0\0").contains("truncated"));
    assert!(told(&Writer::new(&[("x", 3)]).bytes().unwrap()).contains("two coordinates"));
    let mut out = Writer::new(&[("y", 1), ("x", 3)]);
    out.variable("y", &[0], Vec::new(), Kind::Double, vec![0.0]);
    out.variable("x", &[1], Vec::new(), Kind::Double, vec![0.0, 1.0, 5.0]);
    out.variable("z", &[0, 1], Vec::new(), Kind::Double, vec![0.0; 3]);
    assert!(told(&out.bytes().unwrap()).contains("not evenly spaced"));
}
