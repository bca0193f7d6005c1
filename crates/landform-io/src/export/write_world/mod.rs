//! The land as a world for a simulator of robots.
//!
//! # Model
//! All worlds have metres, x east, y north, z up. The middle of the land in plan is at x = y = 0
//! and heights are the landscape's own, so that sea level is at z = 0; the card says where the
//! middle lies on the landscape.
//!
//! # Limits
//! Gazebo and MuJoCo stretch one elevation a node over a rectangle: nodata gets the least height.
//! USD leaves holes open.
//!
//! # Sources
//! SDFormat 1.9 (`heightmap`, `mesh`); gz-sim, gz-physics and gz-common (the collision takes its
//! place from `pose`, the picture of it from `pos`; pixels are divided by the greatest one);
//! MuJoCo's XML reference (`hfield`: rows from the south in its own binary files, half sides);
//! OpenUSD (`UsdGeomMesh`, `UsdPhysics`, `UsdPreviewSurface`).
//!
//! # Checked by
//! `tests`: a letter that no turn or flip leaves as it is, read back from each file in metres; and
//! by hand with the readers of MuJoCo and OpenUSD.

mod gazebo;
mod mujoco;
mod usd;

use landform_core::terrain::{HeightField, NodeSurface, Rasterize};
use landform_core::units::Length;
use landform_core::verb::{Environment, Export, Landscape, Output, Params, Reach, Source, check_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::colours::ground_texture;
use crate::format::{MeshFile, mesh_file_from_height_field};

/// Simulator that reads a world.
///
/// ```
/// use landform_io::export::{Simulator, WriteWorld};
///
/// assert_eq!(WriteWorld::default().preset, Simulator::Gazebo);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Simulator {
    /// Gazebo: SDF 1.9, with heights as a 16-bit picture, or a mesh.
    #[default]
    Gazebo,
    /// MuJoCo: MJCF, with heights in MuJoCo's own binary form.
    Mujoco,
    /// Isaac Sim, Omniverse and whatever reads OpenUSD: text, with a mesh.
    Usd,
}

/// Writes the land as a world for a simulator of robots, in metres about its middle, with a card
/// (name.ext.md): gazebo (sdf), mujoco (xml), usd (usda). What the world reads lies beside it.
///
/// ```
/// use landform_core::verb::Params;
/// use landform_io::export::{Simulator, WriteWorld};
///
/// let world = WriteWorld { preset: Simulator::Mujoco, path: "world.xml".into(), ..WriteWorld::default() };
/// assert_eq!(world.outputs(), ["world.xml", "world.hfield", "world.xml.md"]);
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteWorld {
    /// Path below the output folder.
    pub path: String,
    /// Simulator that reads it.
    pub preset: Simulator,
    /// Greatest vertical distance of any node from the mesh that is seen and collided with (gazebo,
    /// usd). If not given, gazebo has a height map instead, and usd a mesh of all nodes.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1e6))]
    pub max_error: Option<Length>,
    /// Nodes along a side of the height map of gazebo: a power of two and one. If not given, it is
    /// the one nearest to the landscape's own.
    #[schemars(extend("x-min" = 33, "x-max" = 4097))]
    pub size: Option<usize>,
    /// Whether the ground's colours lie on it as a picture (usd; gazebo with a height map).
    pub texture: bool,
}

impl Default for WriteWorld {
    fn default() -> Self {
        Self { path: "world.sdf".into(), preset: Simulator::default(), max_error: None, size: None, texture: false }
    }
}

/// How the world of a simulator is written.
struct Writer {
    /// The preset's word.
    word: &'static str,
    extensions: &'static [&'static str],
    /// Files beside the world's: ends of their names.
    beside: fn(&WriteWorld) -> Vec<&'static str>,
    /// What else the preset asks of its parameters.
    check: fn(&WriteWorld) -> Result<()>,
    /// Bytes a node.
    bytes: fn(&WriteWorld) -> u64,
    write: fn(&World, &mut dyn Output) -> Result<()>,
}

impl Simulator {
    fn writer(self) -> &'static Writer {
        match self {
            Self::Gazebo => &gazebo::WRITER,
            Self::Mujoco => &mujoco::WRITER,
            Self::Usd => &usd::WRITER,
        }
    }
}

/// Bytes a node of a mesh that leaves out nodes.
const BYTES_OF_A_MESH: u64 = 360;

impl Params for WriteWorld {
    const NAME: &'static str = "write_world";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some((self.preset.writer().bytes)(self))
    }

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        let beside = (self.preset.writer().beside)(self).into_iter().map(|end| self.beside(end));
        std::iter::once(self.path.clone()).chain(beside).chain([format!("{}.md", self.path)]).collect()
    }

    fn check(&self) -> Result<()> {
        let writer = self.preset.writer();
        check_path(&self.path, writer.extensions)?;
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./".contains(c);
        if !self.path.chars().all(is_plain) {
            let expected = "a path of letters, digits, `-`, `_`, `.` and `/`, which all simulators read";
            return Err(Error::parameter("path", format!("{:?}", self.path), expected));
        }
        if self.size.is_some() && (self.preset != Simulator::Gazebo || self.max_error.is_some()) {
            let expected = "none: only the height map of preset \"gazebo\" has a size of its own";
            return Err(Error::parameter("size", format!("given for preset \"{}\"", writer.word), expected));
        }
        (writer.check)(self)
    }
}

impl WriteWorld {
    /// Path of a file beside the world's, by the end of its name.
    fn beside(&self, end: &str) -> String {
        let stem = self.path.rsplit_once('.').map_or(self.path.as_str(), |(stem, _)| stem);
        format!("{stem}{end}")
    }
}

/// What is written.
struct World<'a> {
    stage: &'a WriteWorld,
    /// The land as it is, with holes.
    field: &'a HeightField,
    environment: &'a Environment,
    title: &'a str,
    seed: u64,
}

impl World<'_> {
    /// The name by which the world's file calls one beside it.
    fn name(&self, end: &str) -> String {
        let path = self.stage.beside(end);
        path.rsplit('/').next().unwrap_or(&path).to_string()
    }

    /// Middle of the land in plan, m.
    fn middle(&self) -> [f64; 2] {
        let [lo, hi] = self.field.bounds();
        [0.5 * (lo[0] + hi[0]), 0.5 * (lo[1] + hi[1])]
    }

    /// The ground as a mesh about its middle, of as few nodes as its error allows; and that error.
    fn mesh(&self) -> Result<(MeshFile, Option<f64>)> {
        let mut mesh = mesh_file_from_height_field(self.field);
        if mesh.triangles.is_empty() {
            return Err(Error::NoFace { what: "the surface" });
        }
        let [x, y] = self.middle();
        mesh.points.iter_mut().for_each(|p| (p[0], p[1]) = (p[0] - x, p[1] - y));
        mesh.middle = Some([0.0; 2]);
        if self.stage.texture {
            mesh.texture = Some(ground_texture(self.field, self.environment, None)?);
        }
        match self.stage.max_error {
            Some(tolerance) => {
                let (thin, error) = mesh.decimated(tolerance.si());
                Ok((thin, Some(error)))
            }
            None => Ok((mesh, None)),
        }
    }

    /// The card: what the world is, and how it is opened.
    fn card(&self, simulator: &str, rows: &[(&str, String)], steps: &str) -> String {
        let [x, y] = self.middle();
        let [w, h] = self.field.grid().extent();
        let (lo, hi) = range(self.field);
        let mut card = format!(
            "# {simulator}: card for {}\n\n`{}`, seed {}, written by landform {}.\n\n| | |\n|---|---|\n\
             | extent | {} m x {} m (east, north) |\n| heights | {} m to {} m |\n\
             | x = 0, y = 0 | ({}, {}) of the landscape, its middle |\n",
            self.title,
            self.stage.path,
            self.seed,
            env!("CARGO_PKG_VERSION"),
            digits(w),
            digits(h),
            digits(lo),
            digits(hi),
            digits(x),
            digits(y),
        );
        let shape = self.field.grid().shape;
        let at_middle = self.field.elevation()[shape.index(shape.rows / 2, shape.cols / 2)];
        if at_middle.is_finite() {
            card += &format!("| ground in the middle | {} m: put a robot above that |\n", digits(at_middle));
        }
        for (name, value) in rows {
            card += &format!("| {name} | {value} |\n");
        }
        card + "\nMetres; x east, y north, z up; sea level (0 m) is z = 0.\n\n" + steps
    }
}

impl<T: Rasterize> Export<T> for WriteWorld {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let field = landscape.terrain.rasterized()?;
        let shape = field.grid().shape;
        if shape.rows < 2 || shape.cols < 2 {
            return Err(Error::NoFace { what: "a world" });
        }
        if field.elevation().iter().all(|z| z.is_nan()) {
            return Err(Error::Empty { what: "the land".into() });
        }
        let (environment, title, seed) = (landscape.environment, landscape.title, landscape.seed);
        let world = World { stage: self, field: &field, environment, title, seed };
        (self.preset.writer().write)(&world, out)
    }
}

/// Least and greatest height, m.
fn range(field: &HeightField) -> (f64, f64) {
    let finite = field.elevation().iter().copied().filter(|z| z.is_finite());
    finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)))
}

/// The land with nodata at its least height; how many nodes had none.
fn filled(field: &HeightField) -> Result<(HeightField, usize)> {
    let (least, _) = range(field);
    let count = field.elevation().iter().filter(|z| z.is_nan()).count();
    let z = field.elevation().iter().map(|&z| if z.is_nan() { least } else { z }).collect();
    Ok((HeightField::new(field.grid().clone(), z)?, count))
}

/// A number of metres to the micrometre, without trailing zeros.
fn digits(v: f64) -> String {
    let text = format!("{v:.6}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".into() } else { short.to_string() }
}

#[cfg(test)]
mod tests;
