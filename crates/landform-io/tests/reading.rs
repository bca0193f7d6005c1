//! What files and their neighbours say is used, or noted.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::{Path, PathBuf};

use landform_core::grid::{GeoKeys, Georeference, Grid, Registration, Shape};
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_io::format::{
    Compression, DataType, GeotiffOptions, RasterFile, Reading, Sidecar, raster_format, read_grid, read_raster,
    sidecar_path,
};

/// A folder that goes when it is no longer needed.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("landform-reading-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn put(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }

    fn read(&self, name: &str, bytes: impl AsRef<[u8]>) -> Reading {
        read_raster(&self.put(name, bytes)).unwrap()
    }

    fn refusal(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        let error = read_raster(&self.put(name, bytes)).unwrap_err();
        format!("{error} {}", error.hint().unwrap_or_default())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        std::fs::remove_dir_all(&self.0).ok();
    }
}

/// 3 x 4 elevations, the last of them missing if so wished.
fn field(georeference: Georeference, hole: bool) -> HeightField {
    let mut grid = Grid::new(Shape::new(3, 4), [30.0, 30.0]).unwrap();
    (grid.origin, grid.georeference) = ([500_000.0, 4_200_000.0], georeference);
    let z = (0..12).map(|i| if hole && i == 11 { f64::NAN } else { 100.0 + f64::from(i * i) }).collect();
    HeightField::new(grid, z).unwrap()
}

fn utm() -> Georeference {
    Georeference { epsg: Some(32_611), ..Georeference::default() }
}

fn written(name: &str, field: &HeightField) -> Vec<u8> {
    let file = RasterFile::real(field.grid(), field.elevation(), "elevation", "m", 1);
    (raster_format(Path::new(name)).unwrap().write)(&file).unwrap()
}

/// Writes a raster and, where its format wants one, its sidecar.
fn save(folder: &Folder, name: &str, field: &HeightField) -> PathBuf {
    let file = RasterFile::real(field.grid(), field.elevation(), "elevation", "m", 1);
    let format = raster_format(Path::new(name)).unwrap();
    if let Some(sidecar) = format.sidecar(&file) {
        folder.put(&sidecar_path(name), sidecar.text().unwrap());
    }
    folder.put(name, (format.write)(&file).unwrap())
}

fn noted(reading: &Reading, text: &str) -> bool {
    reading.notes.iter().any(|n| n.contains(text))
}

/// A little-endian TIFF of one strip or several, laid out by hand: tags of 16-bit, 32-bit, real and
/// text values.
#[derive(Default)]
struct Tiff {
    tags: Vec<(u16, Value)>,
    blocks: Vec<Vec<u8>>,
}

enum Value {
    Short(Vec<u16>),
    Long(Vec<u32>),
    Real(Vec<f64>),
    Text(&'static str),
}

impl Tiff {
    /// Of 4 x 3 samples.
    fn new(bits: u16, format: u16, bands: u16, blocks: Vec<Vec<u8>>) -> Self {
        let tags = vec![
            (256, Value::Short(vec![4])),
            (257, Value::Short(vec![3])),
            (258, Value::Short(vec![bits; bands as usize])),
            (262, Value::Short(vec![1])),
            (277, Value::Short(vec![bands])),
            (278, Value::Short(vec![3])),
            (284, Value::Short(vec![1])),
            (339, Value::Short(vec![format; bands as usize])),
            (33_550, Value::Real(vec![30.0, 30.0, 0.0])),
            (33_922, Value::Real(vec![0.0, 0.0, 0.0, 500_000.0, 4_200_000.0, 0.0])),
        ];
        Self { tags, blocks }.with(259, Value::Short(vec![1]))
    }

    fn with(mut self, tag: u16, value: Value) -> Self {
        self.tags.retain(|t| t.0 != tag);
        self.tags.push((tag, value));
        self
    }

    fn without(mut self, tag: u16) -> Self {
        self.tags.retain(|t| t.0 != tag);
        self
    }

    /// The file; blocks without bytes are absent.
    fn bytes(mut self) -> Vec<u8> {
        let mut file = b"II*\0\0\0\0\0".to_vec();
        let mut offsets = Vec::new();
        for block in &self.blocks {
            offsets.push(if block.is_empty() { 0 } else { file.len() as u32 });
            file.extend(block);
        }
        let lengths = self.blocks.iter().map(|b| b.len() as u32).collect();
        let tiled = self.tags.iter().any(|t| t.0 == 322);
        self.tags.push((if tiled { 324 } else { 273 }, Value::Long(offsets)));
        self.tags.push((if tiled { 325 } else { 279 }, Value::Long(lengths)));
        self.tags.sort_by_key(|t| t.0);
        let mut entries = Vec::new();
        for (tag, value) in &self.tags {
            let (kind, count, data): (u16, usize, Vec<u8>) = match value {
                Value::Short(v) => (3, v.len(), v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                Value::Long(v) => (4, v.len(), v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                Value::Real(v) => (12, v.len(), v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                Value::Text(v) => (2, v.len() + 1, v.bytes().chain([0]).collect()),
            };
            entries.extend(tag.to_le_bytes());
            entries.extend(kind.to_le_bytes());
            entries.extend((count as u32).to_le_bytes());
            if data.len() <= 4 {
                let mut data = data;
                data.resize(4, 0);
                entries.extend(data);
            } else {
                entries.extend((file.len() as u32).to_le_bytes());
                file.extend(data);
            }
        }
        let start = file.len() as u32;
        file[4..8].copy_from_slice(&start.to_le_bytes());
        file.extend((self.tags.len() as u16).to_le_bytes());
        file.extend(entries);
        file.extend([0; 4]);
        file
    }
}

/// 0, 10, .. 110 as 16-bit numbers.
fn tens() -> Vec<u8> {
    (0..12_u16).flat_map(|v| (v * 10).to_le_bytes()).collect()
}

fn tens_f64() -> Vec<f64> {
    (0..12).map(|v| f64::from(v * 10)).collect()
}

#[test]
fn absent_tiles_are_nodata_or_zero() {
    let folder = Folder::new("sparse");
    let tiff = || {
        let tile: Vec<u8> = (0..256_u16).flat_map(|_| 7_u16.to_le_bytes()).collect();
        Tiff::new(16, 1, 1, vec![tile, vec![]])
            .with(256, Value::Short(vec![20]))
            .without(278)
            .with(322, Value::Short(vec![16]))
            .with(323, Value::Short(vec![16]))
    };
    let found = folder.read("a.tif", tiff().with(42_113, Value::Text("-9999")).bytes());
    assert_eq!((found.field.nodata_count(), found.field.elevation()[0]), (12, 7.0));
    assert!(found.notes.is_empty(), "{:?}", found.notes);
    let found = folder.read("b.tif", tiff().bytes());
    assert_eq!((found.field.nodata_count(), found.field.elevation()[19]), (0, 0.0));
    assert!(noted(&found, "1 strips or tiles are absent"));
}

#[test]
fn every_plain_number_is_read_from_a_tiff() {
    let folder = Folder::new("numbers");
    let all = |bytes: fn(i32) -> Vec<u8>| (0..12).flat_map(|v| bytes(v * 10)).collect::<Vec<u8>>();
    let cases: [(u16, u16, Vec<u8>); 9] = [
        (8, 1, all(|v| vec![v as u8])),
        (16, 1, all(|v| (v as u16).to_le_bytes().into())),
        (32, 1, all(|v| (v as u32).to_le_bytes().into())),
        (64, 1, all(|v| (v as u64).to_le_bytes().into())),
        (8, 2, all(|v| (v as i8).to_le_bytes().into())),
        (64, 2, all(|v| i64::from(v).to_le_bytes().into())),
        (32, 3, all(|v| (v as f32).to_le_bytes().into())),
        (64, 3, all(|v| f64::from(v).to_le_bytes().into())),
        (
            16,
            3,
            [0, 0x4900, 0x4D00, 0x4F80, 0x5100, 0x5240, 0x5380, 0x5460, 0x5500, 0x55A0, 0x5640, 0x56E0_u16]
                .into_iter()
                .flat_map(u16::to_le_bytes)
                .collect(),
        ),
    ];
    for (bits, format, data) in cases {
        let found = folder.read("a.tif", Tiff::new(bits, format, 1, vec![data]).bytes());
        assert_eq!(found.field.elevation(), tens_f64(), "{bits} {format}");
        assert_eq!(found.field.grid().origin, [500_015.0, 4_199_985.0]);
    }
    let text = folder.refusal("b.tif", Tiff::new(64, 6, 1, vec![vec![0; 96]]).bytes());
    assert!(text.contains("complex") && text.contains("gdal_translate"), "{text}");
}

#[test]
fn white_may_be_the_least_and_bands_may_lie_apart() {
    let folder = Folder::new("bands");
    let found = folder.read("white.tif", Tiff::new(16, 1, 1, vec![tens()]).with(262, Value::Short(vec![0])).bytes());
    assert_eq!(found.field.elevation(), tens_f64(), "numbers are numbers, not greys");
    let planes = Tiff::new(16, 1, 2, vec![tens(), vec![0xFF; 24]]).with(284, Value::Short(vec![2]));
    let found = folder.read("planes.tif", planes.bytes());
    assert_eq!(found.field.elevation(), tens_f64());
    assert!(noted(&found, "the first of 2 bands"));
}

#[test]
fn bands_of_opacity_and_masks_are_heeded() {
    let folder = Folder::new("alpha");
    let pixels: Vec<u8> =
        (0..12_u16).flat_map(|v| [v * 10, if v == 3 { 0 } else { 255 }]).flat_map(u16::to_le_bytes).collect();
    for (extra, holes) in [(1, 1), (2, 1), (0, 0)] {
        let tiff = Tiff::new(16, 1, 2, vec![pixels.clone()]).with(338, Value::Short(vec![extra]));
        let found = folder.read("a.tif", tiff.bytes());
        assert_eq!(found.field.nodata_count(), holes, "extra sample {extra}");
        assert_eq!(found.field.elevation()[4], 40.0);
    }
    let mask: Vec<u8> = (0..12).map(|v| u8::from(v != 5)).collect();
    folder.put("b.tif.msk", Tiff::new(8, 1, 1, vec![mask]).bytes());
    let found = folder.read("b.tif", Tiff::new(16, 1, 1, vec![tens()]).bytes());
    assert!(found.field.nodata_count() == 1 && found.field.elevation()[5].is_nan());
}

#[test]
fn items_of_other_bands_do_not_count() {
    let folder = Folder::new("items");
    let items = r#"<GDALMetadata><Item name="SCALE" sample="1" role="scale">0.001</Item>
        <Item name="OFFSET" sample="1" role="offset">5</Item></GDALMetadata>"#;
    let found = folder.read("a.tif", Tiff::new(16, 1, 1, vec![tens()]).with(42_112, Value::Text(items)).bytes());
    assert_eq!(found.field.elevation(), tens_f64());
    let items = r#"<GDALMetadata><Item name="UNITTYPE" sample="0" role="unittype">ft</Item></GDALMetadata>"#;
    let found = folder.read("b.tif", Tiff::new(16, 1, 1, vec![tens()]).with(42_112, Value::Text(items)).bytes());
    assert!((found.field.elevation()[11] - 110.0 * 0.3048).abs() < 1e-9 && noted(&found, "0.3048 m"));
}

fn keyed(entries: &[[u16; 4]]) -> Tiff {
    let count = entries.len() as u16;
    let directory = [1, 1, 0, count].into_iter().chain(entries.iter().flatten().copied()).collect();
    Tiff::new(16, 1, 1, vec![tens()]).with(34_735, Value::Short(directory))
}

#[test]
fn feet_are_refused_on_the_ground_and_converted_upward() {
    let folder = Folder::new("feet");
    for entries in
        [&[[1024, 0, 1, 1], [3072, 0, 1, 2263]][..], &[[1024, 0, 1, 1], [3072, 0, 1, 32_767], [3076, 0, 1, 9003]]]
    {
        let text = folder.refusal("a.tif", keyed(entries).bytes());
        assert!(text.contains("not in metres") && text.contains("gdalwarp"), "{text}");
    }
    for (key, value, unit) in [(4099, 9003, 1200.0 / 3937.0), (4099, 9002, 0.3048), (4096, 6360, 1200.0 / 3937.0)] {
        let found = folder.read("b.tif", keyed(&[[1024, 0, 1, 1], [3072, 0, 1, 32_611], [key, 0, 1, value]]).bytes());
        assert!((found.field.elevation()[11] - 110.0 * unit).abs() < 1e-9, "{key} {value}");
        assert_eq!(found.field.grid().georeference.keys, None, "metres are not written back as feet");
    }
    let found = folder.read("c.tif", keyed(&[[1024, 0, 1, 1], [3072, 0, 1, 32_611], [4099, 0, 1, 9001]]).bytes());
    assert_eq!(found.field.elevation(), tens_f64());
}

#[test]
fn systems_that_no_code_tells_are_carried_from_file_to_file() {
    let folder = Folder::new("system");
    let keys = GeoKeys {
        directory: vec![
            1, 1, 0, 5, 1024, 0, 1, 1, 1025, 0, 1, 2, 3072, 0, 1, 32_767, 3073, 34_737, 6, 0, 3080, 34_736, 1, 0,
        ],
        numbers: vec![-117.25],
        text: "local|".into(),
    };
    let georeference = Georeference {
        registration: Registration::Point,
        keys: Some(std::sync::Arc::new(keys.clone())),
        ..Georeference::default()
    };
    for name in ["a.tif", "a.npy", "a.png"] {
        let path = save(&folder, name, &field(georeference.clone(), false));
        let found = read_raster(&path).unwrap();
        assert_eq!(found.field.grid().georeference.keys.as_deref(), Some(&keys), "{name}");
        assert_eq!(found.field.grid().origin, [500_000.0, 4_200_000.0], "{name}");
        assert!(found.notes.is_empty(), "{name}: {:?}", found.notes);
    }
    // A key of the registration that was not there comes in order.
    let mut bare = keys.clone();
    bare.directory.splice(8..12, []);
    bare.directory[3] = 4;
    let georeference = Georeference { keys: Some(std::sync::Arc::new(bare)), ..georeference };
    let found = read_raster(&save(&folder, "d.tif", &field(georeference, false))).unwrap();
    assert_eq!(found.field.grid().georeference.keys.as_deref(), Some(&keys));
    assert_eq!(found.field.grid().origin, [500_000.0, 4_200_000.0]);
    let compound = keyed(&[[1024, 0, 1, 1], [1025, 0, 1, 1], [3072, 0, 1, 32_611], [4096, 0, 1, 5773]]);
    let found = folder.read("b.tif", compound.bytes());
    let again = folder.read("c.tif", written("c.tif", &found.field));
    assert!(again.field.grid().georeference.keys.is_some());
    assert_eq!(again.field.grid().georeference, found.field.grid().georeference);
}

#[test]
fn control_points_and_rotations_are_refused_with_the_way_out() {
    let folder = Folder::new("tied");
    let tied = Tiff::new(16, 1, 1, vec![tens()])
        .without(33_550)
        .with(33_922, Value::Real([[0.0, 0.0, 0.0, 1.0, 2.0, 0.0], [3.0, 0.0, 0.0, 4.0, 2.5, 0.0]].concat()));
    let text = folder.refusal("a.tif", tied.bytes());
    assert!(text.contains("control points") && text.contains("gdalwarp"), "{text}");
    let matrix = |t: [f64; 6]| {
        let [x, dx, row_x, y, col_y, dy] = t;
        let matrix = vec![dx, row_x, 0.0, x, col_y, dy, 0.0, y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        Tiff::new(16, 1, 1, vec![tens()]).without(33_550).without(33_922).with(34_264, Value::Real(matrix)).bytes()
    };
    let found = folder.read("b.tif", matrix([0.0, 30.0, 1e-9, 90.0, 1e-9, -30.0]));
    assert_eq!((found.field.grid().origin, found.field.grid().spacing), ([15.0, 75.0], [30.0, 30.0]));
    for t in [[0.0, 30.0, 1.0, 90.0, 1.0, -30.0], [0.0, -30.0, 0.0, 90.0, 0.0, -30.0]] {
        assert!(folder.refusal("c.tif", matrix(t)).contains("rotated or flipped"));
    }
}

#[test]
fn every_packing_is_read_and_others_are_named() {
    let folder = Folder::new("packed");
    let zstd = {
        // A frame of one raw block, without a checksum: 24 bytes of content.
        let block = (24_u32 << 3) | 1;
        [&[0x28, 0xB5, 0x2F, 0xFD, 0x20, 24][..], &block.to_le_bytes()[..3], &tens()].concat()
    };
    let found = folder.read("zstd.tif", Tiff::new(16, 1, 1, vec![zstd]).with(259, Value::Short(vec![50_000])).bytes());
    assert_eq!(found.field.elevation(), tens_f64());
    let packed = [&[23][..], &tens()].concat();
    let tiff = Tiff::new(16, 1, 1, vec![packed]).with(259, Value::Short(vec![32_773]));
    assert_eq!(folder.read("bits.tif", tiff.bytes()).field.elevation(), tens_f64());
    for (number, name) in [(34_887, "LERC"), (50_001, "WebP"), (34_925, "LZMA"), (9_999, "9999")] {
        let text = folder
            .refusal("other.tif", Tiff::new(16, 1, 1, vec![tens()]).with(259, Value::Short(vec![number])).bytes());
        assert!(text.contains(name) && text.contains("COMPRESS=DEFLATE"), "{text}");
    }
    let source = field(utm(), true);
    for compression in [Compression::Deflate, Compression::Lzw, Compression::None] {
        for data_type in [DataType::Float32, DataType::Float64, DataType::Int16] {
            for tile in [Some(16), None] {
                let mut file = RasterFile::real(source.grid(), source.elevation(), "elevation", "m", 1);
                file.geotiff = GeotiffOptions { data_type, compression, tile };
                let bytes = (raster_format(Path::new("x.tif")).unwrap().write)(&file).unwrap();
                let found = folder.read("x.tif", bytes);
                assert_eq!(found.field.elevation()[..11], source.elevation()[..11], "{:?}", file.geotiff);
                assert!(found.field.elevation()[11].is_nan());
            }
        }
    }
}

/// A TIFF of which nothing is said but its numbers.
fn bare() -> Vec<u8> {
    Tiff::new(16, 1, 1, vec![tens()]).without(33_550).without(33_922).bytes()
}

#[test]
fn world_files_and_notes_of_gdal_place_a_raster() {
    let utm = r#"PROJCS["WGS 84 / UTM zone 11N",GEOGCS["WGS 84"],UNIT["metre",1],AUTHORITY["EPSG","32611"]]"#;
    for (name, world) in [("a.tif", "a.tfw"), ("b.tif", "b.tifw"), ("c.tif", "c.wld")] {
        let folder = Folder::new(&format!("world-{name}"));
        folder.put(world, "30\n0\n0\n-30\n500015\n4199985\n");
        folder.put(&name.replace(".tif", ".prj"), utm);
        let found = folder.read(name, bare());
        assert_eq!((found.field.grid().spacing, found.field.grid().origin), ([30.0; 2], [500_015.0, 4_199_985.0]));
        assert_eq!(found.field.grid().georeference.epsg, Some(32_611));
        assert!(found.notes.is_empty(), "{:?}", found.notes);
    }
    let folder = Folder::new("aux");
    let quoted = utm.replace('"', "&quot;");
    folder.put(
        "d.tif.aux.xml",
        format!(
            r#"<PAMDataset><SRS>{quoted}</SRS><GeoTransform>500000, 30, 0, 4200000, 0, -30</GeoTransform>
            <PAMRasterBand band="2"><NoDataValue>0</NoDataValue></PAMRasterBand>
            <PAMRasterBand band="1"><NoDataValue>110</NoDataValue><Scale>2</Scale><UnitType>m</UnitType></PAMRasterBand></PAMDataset>"#
        ),
    );
    let found = folder.read("d.tif", bare());
    assert_eq!((found.field.grid().spacing, found.field.grid().origin), ([30.0; 2], [500_015.0, 4_199_985.0]));
    assert_eq!((found.field.nodata_count(), found.field.elevation()[10]), (1, 200.0));
    assert_eq!(found.field.grid().georeference.epsg, Some(32_611));
    let folder = Folder::new("feet-beside");
    folder.put("e.prj", r#"PROJCS["x",GEOGCS["y"],UNIT["Foot_US",0.3048006096012192]]"#);
    folder.put("e.tfw", "30\n0\n0\n-30\n0\n0\n");
    assert!(folder.refusal("e.tif", bare()).contains("not in metres"));
    assert!(noted(&folder.read("f.tif", bare()), "nothing says how large its cells are"));
}

#[test]
fn ascii_grids_are_read_in_their_variants() {
    let folder = Folder::new("ascii");
    let head = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\n";
    let text = format!("{head}dx 10\ndy 5\nNODATA_value -9999\n1 2 3\n4 5 -9999\n");
    let found = folder.read("a.asc", &text);
    assert_eq!((found.field.grid().spacing, found.field.grid().origin), ([10.0, 5.0], [105.0, 207.5]));
    assert_eq!(found.field.nodata_count(), 1);
    // What was read is written as it came.
    let again = folder.read("b.asc", written("b.asc", &found.field));
    assert_eq!(again.field.grid(), found.field.grid());
    let wide =
        |order: fn(u16) -> [u8; 2]| [0xFEFF].into_iter().chain(text.encode_utf16()).flat_map(order).collect::<Vec<_>>();
    for bytes in [[b"\xEF\xBB\xBF", text.as_bytes()].concat(), wide(u16::to_le_bytes), wide(u16::to_be_bytes)] {
        assert_eq!(folder.read("c.asc", bytes).field.grid(), found.field.grid());
    }
    let lowest = format!("{head}cellsize 10\nNODATA_value -3.402823e+38\n1 -3.40282346638528859e+38 3\n4 1.5D+01 6\n");
    let found = folder.read("d.asc", lowest);
    assert_eq!((found.field.nodata_count(), found.field.elevation()[4]), (1, 15.0));
    // Decimal commas, lines of Windows, rows that go on over lines.
    let wrapped =
        "NCOLS 3\r\nNROWS 2\r\nXLLCENTER 0,5\r\nYLLCENTER 0,5\r\nCELLSIZE 1\r\n1,5 2\r\n3,25 4\r\n5\r\n6,25\r\n";
    let found = folder.read("e.asc", wrapped);
    assert_eq!(found.field.elevation(), [1.5, 2.0, 3.25, 4.0, 5.0, 6.25]);
    assert_eq!(found.field.grid().origin, [0.5, 1.5]);
}

#[test]
fn nodata_may_be_the_word_nan() {
    let folder = Folder::new("nan");
    let numbers: Vec<u8> =
        (0..12).map(|i| if i == 5 { f32::NAN } else { i as f32 }).flat_map(f32::to_le_bytes).collect();
    for word in ["nan", "NaN", "nan\0"] {
        let found =
            folder.read("a.tif", Tiff::new(32, 3, 1, vec![numbers.clone()]).with(42_113, Value::Text(word)).bytes());
        assert_eq!((found.field.nodata_count(), found.field.elevation()[11]), (1, 11.0), "{word}");
    }
}

#[test]
fn a_grid_is_known_without_the_samples() {
    let folder = Folder::new("grids");
    let degrees = Georeference { epsg: Some(4326), geographic: true, ..Georeference::default() };
    let mut in_degrees = field(degrees.clone(), true);
    in_degrees.set_grid(Grid { spacing: [0.001, 0.002], origin: [10.0, 45.0], ..in_degrees.grid().clone() }).unwrap();
    for (name, source) in [
        ("a.tif", field(utm(), true)),
        ("b.tif", in_degrees.clone()),
        ("c.asc", field(utm(), true)),
        ("d.npy", in_degrees),
    ] {
        let path = save(&folder, name, &source);
        assert_eq!(read_grid(&path).unwrap().unwrap(), *read_raster(&path).unwrap().field.grid(), "{name}");
    }
    folder.put("e.tfw", "30\n0\n0\n-30\n500015\n4199985\n");
    let path = folder.put("e.tif", bare());
    assert_eq!(read_grid(&path).unwrap().unwrap().origin, [500_015.0, 4_199_985.0]);
    let keyed = keyed(&[[3072, 0, 1, 32_611], [4096, 0, 1, 8228]]).bytes();
    let path = folder.put("f.tif", keyed);
    assert_eq!(read_grid(&path).unwrap().unwrap(), *read_raster(&path).unwrap().field.grid());
    let path = save(&folder, "g.png", &field(utm(), false));
    assert!(read_grid(&path).unwrap().is_none(), "pictures are read to be known");
    // Files that are cut off are found out, where their headers say how much there should be.
    for name in ["a.tif", "d.npy"] {
        let bytes = std::fs::read(folder.0.join(name)).unwrap();
        let cut = folder.put(&format!("cut-{name}"), &bytes[..bytes.len() - 40]);
        let error = read_grid(&cut).err().or_else(|| read_raster(&cut).err());
        assert!(error.is_some(), "{name}");
    }
    let cut = &npy("<f4", "(3, 4)", &[0; 47]);
    assert!(read_grid(&folder.put("j.npy", cut)).unwrap_err().to_string().contains("truncated"));
    let mut tiff = Tiff::new(16, 1, 1, vec![tens()]).bytes();
    // The tags lie behind the strip: the strip is said to begin where nothing is.
    let at = tiff.windows(4).position(|w| w == [17, 1, 4, 0]).unwrap() + 8;
    tiff[at..at + 4].copy_from_slice(&90_000_u32.to_le_bytes());
    assert!(read_grid(&folder.put("k.tif", tiff)).unwrap_err().to_string().contains("truncated"));
    // A header alone is enough, and one that lies is found out.
    let path = folder.put("h.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 x\n");
    assert!(read_grid(&path).is_ok() && read_raster(&path).is_err());
    let path = folder.put("i.asc", "ncols 2000\nnrows 1000\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n");
    assert!(read_grid(&path).unwrap_err().to_string().contains("2000 x 1000"));
}

#[test]
fn nearby_json_is_no_sidecar_unless_it_fits() {
    let folder = Folder::new("json");
    folder.put("a.json", r#"{"width":"12","scale":[1,2]}"#);
    assert_eq!(folder.read("a.tif", written("a.tif", &field(utm(), false))).field.elevation()[0], 100.0);
    let found = folder.read("a.png", written("a.png", &field(utm(), false)));
    assert!(noted(&found, "a.json beside it was not used"));
    folder.put("b.json", r#"{"scale":5000,"height":2600,"width":5000}"#);
    let text = folder.refusal("b.png", written("b.png", &field(utm(), false)));
    assert!(text.contains("5000 x 2600") && text.contains("4 x 3") && text.contains("b.json"), "{text}");
    folder.put("c.json", r#"{"scale":2,"height":3,"width":4}"#);
    let found = folder.read("c.png", written("c.png", &field(utm(), false)));
    assert!(noted(&found, "c.json beside it was used") && found.field.elevation()[11] == 131_070.0);
    folder.put("d.json", r#"{"author":"someone"}"#);
    assert_eq!(
        folder.read("d.png", written("d.png", &field(utm(), false))).notes.len(),
        1,
        "but for the size of cells"
    );
}

#[test]
fn degrees_and_nodata_come_through_sidecars() {
    let folder = Folder::new("sidecar");
    let georeference = Georeference { epsg: Some(4326), geographic: true, ..Georeference::default() };
    let mut grid = field(georeference.clone(), true).grid().clone();
    (grid.spacing, grid.origin) = ([0.001, 0.002], [10.0, 45.0]);
    let source = HeightField::new(grid.clone(), field(georeference, true).elevation().to_vec()).unwrap();
    for name in ["a.npy", "a.exr", "a.png", "a.pgm", "a.r16"] {
        let found = read_raster(&save(&folder, name, &source)).unwrap();
        assert_eq!(found.field.grid().georeference, grid.georeference, "{name}");
        assert_eq!((found.field.grid().spacing, found.field.grid().origin), (grid.spacing, grid.origin), "{name}");
        assert_eq!(found.field.nodata_count(), 1, "{name}");
        assert!((found.field.elevation()[10] - 200.0).abs() < 0.01, "{name}");
    }
    let samples = folder.0.join("a.r16");
    let turned = Sidecar {
        row_order: Some("south to north".into()),
        byte_order: Some("big".into()),
        ..Sidecar::parse(&std::fs::read(folder.0.join("a.r16.landform.json")).unwrap()).unwrap()
    };
    let bytes: Vec<u8> = std::fs::read(samples).unwrap().chunks(8).rev().flatten().copied().collect();
    folder.put("b.r16.landform.json", turned.text().unwrap());
    let found = folder.read("b.r16", bytes.chunks(2).flat_map(|b| [b[1], b[0]]).collect::<Vec<u8>>());
    assert!((found.field.elevation()[10] - 200.0).abs() < 0.01 && found.field.elevation()[11].is_nan());
}

fn npy(kind: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}\n");
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), data].concat()
}

#[test]
fn arrays_of_every_plain_type_are_read() {
    let folder = Folder::new("npy");
    let le = |bytes: fn(i32) -> Vec<u8>| [0, 1, -2].into_iter().flat_map(bytes).collect::<Vec<u8>>();
    for (kind, data) in [
        ("<i8", le(|v| i64::from(v).to_le_bytes().into())),
        (">i8", le(|v| i64::from(v).to_be_bytes().into())),
        ("|i1", le(|v| (v as i8).to_le_bytes().into())),
        ("<f2", vec![0x00, 0x00, 0x00, 0x3C, 0x00, 0xC0]),
        (">f2", vec![0x00, 0x00, 0x3C, 0x00, 0xC0, 0x00]),
        ("<f4", le(|v| (v as f32).to_le_bytes().into())),
    ] {
        for shape in ["(1, 3)", "(1, 1, 3)", "(1, 3, 1)"] {
            let found = folder.read("a.npy", npy(kind, shape, &data));
            assert_eq!(found.field.elevation(), [0.0, 1.0, -2.0], "{kind} {shape}");
        }
    }
    let data = [1.0_f32, f32::INFINITY, 3.0].into_iter().flat_map(f32::to_le_bytes).collect::<Vec<u8>>();
    let found = folder.read("b.npy", npy("<f4", "(1, 3)", &data));
    assert!(found.field.nodata_count() == 1 && noted(&found, "1 number is infinite"));
    let text = folder.refusal("c.npy", npy("<f4", "(2, 2, 2)", &[0; 32]));
    assert!(text.contains("3 dimensions") && text.contains("array[0]"), "{text}");
    assert!(folder.refusal("d.npy", npy("<f2", "(1, 3)", &[0; 4])).contains("truncated"));
    let data: Vec<u8> = [1.0_f32, 4.0, 2.0, 5.0, 3.0, 6.0].into_iter().flat_map(f32::to_be_bytes).collect();
    let mut bytes = npy(">f4", "(2, 3)", &data);
    let at = bytes.windows(5).position(|w| w == b"False").unwrap();
    bytes[at..at + 5].copy_from_slice(b"True ");
    assert_eq!(folder.read("e.npy", bytes).field.elevation(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
}

#[test]
fn float64_is_kept_where_float32_would_blur() {
    let folder = Folder::new("blur");
    let mut grid = field(utm(), false).grid().clone();
    grid.origin = [0.0, 60.0];
    let z: Vec<f64> = (0..12).map(|i| 1e6 + f64::from(i) * 1e-4).collect();
    let source = HeightField::new(grid, z).unwrap();
    for name in ["a.tif", "a.npy", "a.asc"] {
        let mut file = RasterFile::real(source.grid(), source.elevation(), "elevation", "m", 1);
        assert!(file.needs_float64(1e-6));
        file.geotiff.data_type = DataType::Float64;
        let found = folder.read(name, (raster_format(Path::new(name)).unwrap().write)(&file).unwrap());
        assert_eq!(found.field.elevation(), source.elevation(), "{name}");
    }
    let plain = field(utm(), true);
    assert!(!RasterFile::real(plain.grid(), plain.elevation(), "elevation", "m", 1).needs_float64(1e-6));
}

#[test]
fn colours_are_no_elevations_and_clear_pixels_no_data() {
    let folder = Folder::new("png");
    let png = |pixels: &[u8], colour: png::ColorType| {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
        encoder.set_color(colour);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.write_header().unwrap().write_image_data(pixels).unwrap();
        bytes
    };
    let text = folder.refusal("a.png", png(&[128, 3, 7, 128, 4, 9], png::ColorType::Rgb));
    assert!(text.contains("colour picture") && text.contains("Terrarium"), "{text}");
    let found = folder.read("b.png", png(&[9, 9, 9, 30, 30, 30], png::ColorType::Rgb));
    assert_eq!(found.field.elevation(), [9.0, 30.0]);
    let found = folder.read("c.png", png(&[9, 255, 30, 0], png::ColorType::GrayscaleAlpha));
    assert!(found.field.elevation()[0] == 9.0 && found.field.elevation()[1].is_nan());
    let found = folder.read("d.png", png(&[9, 0, 30, 0], png::ColorType::GrayscaleAlpha));
    assert_eq!(found.field.elevation(), [9.0, 30.0]);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Four);
    encoder.write_header().unwrap().write_image_data(&[0x3C]).unwrap();
    assert_eq!(folder.read("f.png", bytes).field.elevation(), [3.0, 12.0]);
    assert_eq!(folder.read("e.pgm", "P2 3 1 1000 0 500 880").field.elevation(), [0.0, 500.0, 880.0]);
}

#[test]
fn channels_of_heights_are_found_by_name() {
    use exr::prelude::*;
    let folder = Folder::new("exr");
    let layer = |name: &str, channels: &[(&str, f32)]| {
        let channel = |&(name, value): &(&str, f32)| {
            let samples = FlatSamples::F32(vec![value, value + 1.0]);
            AnyChannel::new(Text::new_or_panic(name), samples)
        };
        let channels = AnyChannels::sort(channels.iter().map(channel).collect());
        Layer::new((2, 1), LayerAttributes::named(Text::new_or_panic(name)), Encoding::UNCOMPRESSED, channels)
    };
    let write = |layers: Vec<Layer<AnyChannels<FlatSamples>>>| {
        let mut bytes = std::io::Cursor::new(Vec::new());
        let display = IntegerBounds::from_dimensions((2, 1));
        let image = Image::from_layers(ImageAttributes::new(display), layers);
        image.write().non_parallel().to_buffered(&mut bytes).unwrap();
        bytes.into_inner()
    };
    let found = folder.read("a.exr", write(vec![layer("x", &[("A", 1.0), ("height", 100.0)])]));
    assert_eq!(found.field.elevation(), [100.0, 101.0]);
    assert!(noted(&found, "channel height of A, height is taken"));
    let parts = vec![layer("mask", &[("A", 1.0)]), layer("ground", &[("Y", 100.0)])];
    assert_eq!(folder.read("b.exr", write(parts)).field.elevation(), [100.0, 101.0]);
    let halves = AnyChannel::new("Y", FlatSamples::F16(vec![f16::from_f32(100.0), f16::from_f32(145.5)]));
    let channels = AnyChannels::sort([halves].into_iter().collect());
    let half = Layer::new((2, 1), LayerAttributes::named("h"), Encoding::UNCOMPRESSED, channels);
    assert_eq!(folder.read("e.exr", write(vec![half])).field.elevation(), [100.0, 145.5]);
    let text = folder.refusal("c.exr", write(vec![layer("x", &[("A", 1.0)])]));
    assert!(text.contains("no channel of heights"), "{text}");
    let found = folder.read("d.exr", write(vec![layer("x", &[("A", 0.0), ("Y", 100.0)])]));
    assert!(found.field.elevation()[0].is_nan() && found.field.elevation()[1] == 101.0);
}

#[test]
fn coordinates_without_a_system_are_degrees_only_if_they_look_so() {
    let folder = Folder::new("guess");
    let text =
        |cell: f64, x: f64| format!("ncols 2\nnrows 2\nxllcorner {x}\nyllcorner 45\ncellsize {cell}\n1 2\n3 4\n");
    for (cell, degrees) in
        [(1.0 / 3_600.0, true), (0.000_833_333_333_333_333, true), (0.05, false), (0.001, false), (30.0, false)]
    {
        let found = folder.read("a.asc", text(cell, 10.0));
        assert_eq!(found.field.grid().georeference.geographic, degrees, "{cell}");
        assert_eq!(noted(&found, "taken as degrees"), degrees);
    }
    // A sidecar that says metres is believed.
    let mut small = field(Georeference::default(), false).grid().clone();
    (small.spacing, small.origin) = ([1.0 / 3_600.0; 2], [0.5, 0.5]);
    let small = HeightField::new(small, vec![1.0; 12]).unwrap();
    for name in ["b.npy", "b.tif"] {
        assert!(!read_raster(&save(&folder, name, &small)).unwrap().field.grid().georeference.geographic, "{name}");
    }
}

/// The text or bytes with some of them changed.
fn damaged(bytes: &[u8], seed: Seed) -> Vec<u8> {
    let mut changed = bytes.to_vec();
    for k in 0..1 + seed.bits(0) % 5 {
        let at = seed.bits(2 * k + 1) as usize % changed.len();
        changed[at] = seed.bits(2 * k + 2) as u8;
    }
    changed.truncate(if seed.bits(99).is_multiple_of(4) { seed.bits(98) as usize % bytes.len() } else { bytes.len() });
    changed
}

#[test]
fn no_damage_makes_a_reader_panic() {
    let folder = Folder::new("damage");
    let opaque: Vec<u8> = (0..24_u16).flat_map(u16::to_le_bytes).collect();
    let zstd = [&[0x28, 0xB5, 0x2F, 0xFD, 0x20, 24, 0xC1, 0, 0][..], &tens()].concat();
    let tiffs = [
        Tiff::new(16, 1, 2, vec![opaque]).with(338, Value::Short(vec![2])).bytes(),
        Tiff::new(16, 1, 1, vec![zstd]).with(259, Value::Short(vec![50_000])).with(317, Value::Short(vec![2])).bytes(),
        Tiff::new(8, 1, 1, vec![vec![3; 256]])
            .without(278)
            .with(322, Value::Short(vec![16]))
            .with(323, Value::Short(vec![16]))
            .bytes(),
        keyed(&[[1024, 0, 1, 1], [3072, 0, 1, 32_767], [4099, 0, 1, 9003]]).with(34_737, Value::Text("a|b|")).bytes(),
    ];
    let beside: [(&str, &[u8]); 4] = [
        ("tif.aux.xml", br#"<PAMDataset><GeoTransform>0,1,0,0,0,-1</GeoTransform><PAMRasterBand band="1"><Scale>2</Scale></PAMRasterBand></PAMDataset>"#),
        ("tfw", b"30\n0\n0\n-30\n500015\n4199985\n"),
        ("prj", br#"PROJCS["a",GEOGCS["b",UNIT["degree",0.017]],UNIT["metre",1],AUTHORITY["EPSG","32611"]]"#),
        ("tif.msk", &tiffs[2]),
    ];
    for trial in 0..300 {
        let seed = Seed(7).with(trial);
        for (k, tiff) in tiffs.iter().enumerate() {
            let _ = read_raster(&folder.put("a.tif", damaged(tiff, seed.with(k as u64))));
        }
        for (k, (name, bytes)) in beside.iter().enumerate() {
            folder.put(&format!("b.{name}"), damaged(bytes, seed.with(10 + k as u64)));
        }
        let _ = read_raster(&folder.put("b.tif", bare()));
    }
}
