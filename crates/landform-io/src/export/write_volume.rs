//! The voxels as a volume: VTK image data, NRRD, or a NumPy array.
//!
//! # Sources
//! VTK file formats, "XML file formats": image data, cell data, appended raw. NumPy enhancement
//! proposal 1. Kindlmann, *Definition of NRRD File Format*.

use landform_core::terrain::{Bounds, Ground, VoxelGrid};
use landform_core::verb::{Export, Landscape, Output, Params, Source, check_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::format::{from_the_south, write_nrrd};

/// Writes the values of voxels; the extension sets the format: vti (VTK image data, for ParaView;
/// x east, y north, z up), nrrd (one field, the same axes) or npy (one field, indexed by level from
/// the underside, row from the north, column from the west, with its size and place in a JSON file
/// beside it). `volume_file` reads them.
///
/// ```
/// assert_eq!(landform_io::export::WriteVolume::default().field, "rock");
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteVolume {
    /// Path below the output folder.
    pub path: String,
    /// Field that is written: "rock" for the materials and all fields, "material" for numbers of
    /// materials (255 is empty), or a field such as "porosity".
    pub field: String,
}

impl Default for WriteVolume {
    fn default() -> Self {
        Self { path: "volume.vti".into(), field: "rock".into() }
    }
}

/// Values of a field.
enum Values<'a> {
    Bytes(Vec<u8>),
    Real(&'a [f32]),
}

impl Values<'_> {
    /// As stored in a file, in an order of voxels.
    fn bytes(&self, order: impl Iterator<Item = usize>) -> Vec<u8> {
        match self {
            Self::Bytes(all) => order.map(|i| all[i]).collect(),
            Self::Real(all) => order.flat_map(|i| all[i].to_le_bytes()).collect(),
        }
    }

    fn kinds(&self) -> [&'static str; 2] {
        match self {
            Self::Bytes(_) => ["UInt8", "|u1"],
            Self::Real(_) => ["Float32", "<f4"],
        }
    }
}

impl Params for WriteVolume {
    const NAME: &'static str = "write_volume";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(64)
    }

    fn outputs(&self) -> Vec<String> {
        let beside = format!("{}.landform.json", self.path);
        if self.is_npy() { vec![self.path.clone(), beside] } else { vec![self.path.clone()] }
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["vti", "npy", "nrrd"])?;
        if (self.is_npy() || self.is_nrrd()) && self.field == "rock" {
            let expected = "one field, such as \"porosity\" or \"material\"; a .vti holds all";
            return Err(Error::parameter("field", "\"rock\", which is all of them", expected));
        }
        Ok(())
    }
}

impl WriteVolume {
    fn is_npy(&self) -> bool {
        self.path.to_lowercase().ends_with(".npy")
    }

    fn is_nrrd(&self) -> bool {
        self.path.to_lowercase().ends_with(".nrrd")
    }

    fn nrrd(&self, ground: &VoxelGrid) -> Result<Vec<u8>> {
        let values = Self::values(ground, &self.field)?;
        let kind = if matches!(values, Values::Bytes(_)) { "uint8" } else { "float" };
        let (shape, [dx, dy]) = (ground.plan().shape, ground.plan().spacing);
        let size = [shape.cols, shape.rows, ground.levels()];
        let place = [ground.bounding_box().low, [dx, dy, ground.height()]];
        Ok(write_nrrd(kind, &self.field, size, place, &values.bytes(from_the_south(size))))
    }

    fn values<'a>(ground: &'a VoxelGrid, name: &str) -> Result<Values<'a>> {
        if name != "material" {
            return ground.need_field(name, "`write_volume`").map(Values::Real);
        }
        let nodes = ground.plan().len();
        let number = |i: usize| ground.material(i / nodes, i % nodes).unwrap_or(u8::MAX);
        Ok(Values::Bytes((0..nodes * ground.levels()).map(number).collect()))
    }

    fn vti(&self, ground: &VoxelGrid) -> Result<Vec<u8>> {
        let names: Vec<&str> = match self.field.as_str() {
            "rock" => std::iter::once("material").chain(ground.field_names()).collect(),
            name => vec![name],
        };
        let (shape, levels) = (ground.plan().shape, ground.levels());
        let [nx, ny, nz] = [shape.cols, shape.rows, levels];
        let Bounds { low, .. } = ground.bounding_box();
        let [dx, dy] = ground.plan().spacing;
        let extent = format!("0 {nx} 0 {ny} 0 {nz}");
        let (mut arrays, mut data) = (String::new(), Vec::new());
        for name in names {
            let values = Self::values(ground, name)?;
            let bytes = values.bytes(from_the_south([nx, ny, nz]));
            let [kind, _] = values.kinds();
            arrays += &format!(
                "        <DataArray type=\"{kind}\" Name=\"{name}\" format=\"appended\" offset=\"{}\"/>\n",
                data.len()
            );
            data.extend_from_slice(&(bytes.len() as u64).to_le_bytes());
            data.extend_from_slice(&bytes);
        }
        let head = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n  <ImageData WholeExtent=\"{extent}\" Origin=\"{} {} {}\" Spacing=\"{dx} {dy} {}\">\n    \
             <Piece Extent=\"{extent}\">\n      <CellData>\n{arrays}      </CellData>\n    </Piece>\n  </ImageData>\n  \
             <AppendedData encoding=\"raw\">\n_",
            low[0],
            low[1],
            low[2],
            ground.height()
        );
        Ok([head.as_bytes(), &data, b"\n  </AppendedData>\n</VTKFile>\n"].concat())
    }

    fn npy(&self, ground: &VoxelGrid) -> Result<Vec<u8>> {
        let (shape, levels) = (ground.plan().shape, ground.levels());
        let values = Self::values(ground, &self.field)?;
        let [_, kind] = values.kinds();
        let shape = format!("({levels}, {}, {})", shape.rows, shape.cols);
        let mut text = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
        // What precedes the numbers fills whole pieces of 64 bytes.
        let length = (10 + text.len() + 1).next_multiple_of(64) - 10;
        text += &" ".repeat(length - text.len() - 1);
        text.push('\n');
        let head = [b"\x93NUMPY\x01\x00".as_slice(), &(length as u16).to_le_bytes(), text.as_bytes()].concat();
        Ok([head, values.bytes(0..ground.plan().len() * levels)].concat())
    }
}

impl Export<VoxelGrid> for WriteVolume {
    fn export(&self, landscape: &Landscape<'_, VoxelGrid>, out: &mut dyn Output) -> Result<()> {
        let ground = landscape.terrain;
        if self.is_nrrd() {
            return out.put(&self.path, &self.nrrd(ground)?);
        }
        if !self.is_npy() {
            return out.put(&self.path, &self.vti(ground)?);
        }
        out.put(&self.path, &self.npy(ground)?)?;
        let Bounds { low, .. } = ground.bounding_box();
        let [dx, dy] = ground.plan().spacing;
        let materials: Vec<&str> = ground.materials().all().iter().map(|m| m.name.as_str()).collect();
        let beside = json!({
            "field": self.field,
            "axes": ["level, upwards", "row, from the north", "column, from the west"],
            "low_corner_m": low,
            "voxel_m": [dx, dy, ground.height()],
            "materials": materials,
        });
        let text = serde_json::to_string_pretty(&beside).unwrap_or_default();
        out.put(&format!("{}.landform.json", self.path), text.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::path::Path;
    use std::sync::Arc;

    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::{HeightField, Materials};
    use landform_core::units::Ratio;
    use landform_core::verb::{Context, Generator, Image, Maps, MemoryOutput, NoMaps};

    use super::*;
    use crate::import::VolumeFileParams;

    fn rock() -> Result<VoxelGrid> {
        let plan = Grid::new(Shape::new(2, 3), [2.0, 2.0])?;
        let mut ground =
            VoxelGrid::from_fn(plan, 2, 10.0, 1.0, &Materials::default(), |l, n| (l + n != 0).then_some(3))?;
        ground.set_field("porosity", (0..12).map(|i| i as f32).collect())?;
        Ok(ground)
    }

    fn written(path: &str, field: &str) -> Result<Vec<u8>> {
        let ground = rock()?;
        let write = WriteVolume { path: path.into(), field: field.into() };
        write.check()?;
        let mut out = MemoryOutput::default();
        write.export(&Landscape::plain(&ground), &mut out)?;
        Ok(out.0[path].clone())
    }

    #[test]
    fn an_image_has_its_place_and_runs_from_the_south() {
        let file = written("a.vti", "rock").unwrap();
        let at = file.windows(6).position(|w| w == b"raw\">\n").unwrap() + 7;
        let head = String::from_utf8_lossy(&file[..at]);
        assert!(head.contains("WholeExtent=\"0 3 0 2 0 2\" Origin=\"-1 -1 10\" Spacing=\"2 2 1\""), "{head}");
        // Numbers of materials: the south row first, then the north one, whose first is empty.
        assert_eq!(file[at..at + 8], 12_u64.to_le_bytes());
        assert_eq!(file[at + 8..at + 14], [3, 3, 3, 255, 3, 3]);
        let porosity = &file[at + 20 + 8..];
        assert_eq!(porosity[..4], 3_f32.to_le_bytes());
        assert!(file.ends_with(b"</VTKFile>\n"));
    }

    #[test]
    fn an_array_has_levels_rows_and_columns() {
        let file = written("a.npy", "porosity").unwrap();
        assert!(file.starts_with(b"\x93NUMPY\x01\x00") && file.len() == 128 + 48);
        assert!(String::from_utf8_lossy(&file[..128]).contains("'<f4', 'fortran_order': False, 'shape': (2, 2, 3)"));
        assert_eq!(file[128 + 44..], 11_f32.to_le_bytes());
    }

    /// Files by name.
    struct Files(BTreeMap<String, Vec<u8>>);

    impl Maps for Files {
        fn bytes(&self, path: &Path) -> Result<Vec<u8>> {
            let found = self.0.get(&path.to_string_lossy().into_owned()).cloned();
            found.ok_or_else(|| Error::io("read", path, std::io::ErrorKind::NotFound.into()))
        }
        fn image(&self, path: &Path) -> Result<Image> {
            NoMaps.image(path)
        }
        fn raster(&self, path: &Path) -> Result<Arc<HeightField>> {
            NoMaps.raster(path)
        }
    }

    fn read(path: &str, files: BTreeMap<String, Vec<u8>>, empty_above: Option<Ratio>) -> Result<VoxelGrid> {
        let params = VolumeFileParams { path: path.into(), empty_above, ..VolumeFileParams::default() };
        let context = Context { maps: &Files(files), ..Context::default() };
        params.estimate(&context)?;
        params.generate(&context)
    }

    fn files(path: &str, field: &str) -> BTreeMap<String, Vec<u8>> {
        let mut out = MemoryOutput::default();
        let write = WriteVolume { path: path.into(), field: field.into() };
        write.export(&Landscape::plain(&rock().unwrap()), &mut out).unwrap();
        out.0.into_iter().collect()
    }

    #[test]
    fn volumes_are_read_as_they_were_written() {
        assert_eq!(read("a.vti", files("a.vti", "rock"), None).unwrap(), rock().unwrap());
        for path in ["a.nrrd", "a.npy"] {
            let materials = read(path, files(path, "material"), None).unwrap();
            assert_eq!((materials.solids(), materials.bounding_box()), (11, rock().unwrap().bounding_box()), "{path}");
            assert_eq!(materials.material(0, 0), None);
            let porosity = read(path, files(path, "porosity"), Some(Ratio::of(9.5))).unwrap();
            assert_eq!(porosity.field("porosity"), rock().unwrap().field("porosity"), "{path}");
            assert_eq!((porosity.solids(), porosity.material(1, 4)), (10, None), "{path}");
        }
    }

    #[test]
    fn damaged_volumes_are_refused() {
        for (path, field) in [("a.vti", "rock"), ("a.nrrd", "porosity"), ("a.npy", "porosity")] {
            let whole = files(path, field)[path].clone();
            // The end of a .vti has no numbers.
            let numbers = whole.len() - if path == "a.vti" { 33 } else { 0 };
            for length in (0..numbers).step_by(3) {
                let cut = BTreeMap::from([(path.to_string(), whole[..length].to_vec())]);
                assert!(read(path, cut, None).is_err(), "{path} of {length} bytes");
            }
        }
        let lies = |path: &str, field: &str, from: &str, to: &str| {
            let whole = files(path, field)[path].clone();
            let at = whole.windows(from.len()).position(|w| w == from.as_bytes()).unwrap();
            let changed = [&whole[..at], to.as_bytes(), &whole[at + from.len()..]].concat();
            read(path, BTreeMap::from([(path.to_string(), changed)]), None).unwrap_err().to_string()
        };
        assert!(
            lies("a.nrrd", "porosity", "sizes: 3 2 2", "sizes: 10000 10000 10000").contains("expected 1 to 4.29e9")
        );
        assert!(lies("a.nrrd", "porosity", "sizes: 3 2 2", "sizes: 3 2 9").contains("truncated"));
        assert!(lies("a.vti", "rock", "\"0 3 0 2 0 2\"", "\"0 9999 0 9999 0 99999\"").contains("voxels"));
        assert!(lies("a.npy", "porosity", "(2, 2, 3), }", "(2, 2, 4), }").contains("truncated"));
        assert!(lies("a.vti", "rock", "Spacing=\"2 2 1\"", "Spacing=\"2 0 1\"").contains("from 1e-6 to 1e6 m"));
        assert!(lies("a.vti", "rock", "Spacing=\"2 2 1\"", "Spacing=\"2 1e300 1\"").contains("from 1e-6 to 1e6 m"));
    }

    #[test]
    fn a_field_that_is_not_there_is_told() {
        assert!(written("a.vti", "presure").unwrap_err().to_string().contains("`presure` is missing"));
        assert!(written("a.npy", "rock").is_err() && written("a.vtk", "rock").is_err());
    }
}
