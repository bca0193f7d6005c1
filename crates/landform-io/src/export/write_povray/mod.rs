//! The landscape as a scene for POV-Ray.

mod heights;
mod scene;

use landform_core::terrain::{NodeSurface, Rasterize};
use landform_core::units::{Angle, Length};
use landform_core::verb::{Export, Landscape, Output, Params, Reach, Source, check_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::encode_grey;
use crate::render::{BlockView, View};
use heights::Heights;
use scene::{Ground, Scene};

/// Writes a scene for POV-Ray 3.7: the block of land of `write_picture` in metres, from the same
/// side and under the same sun. Beside it lie the heights it reads, 16-bit PNG: those of the ground
/// (name_ground.png) and, where there are lakes, of their surface (name_lakes.png). Nodata is drawn
/// at the least elevation. A mesh is written as a raster.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WritePovray {
    /// Path below the output folder.
    pub path: String,
    /// Whether lakes and the sea are in the scene.
    pub water: bool,
    /// Level of the sea, which lies on ground below it where other ground rises above it. If not
    /// given, it is the environment's, or else 0 m.
    pub sea_level: Option<Length>,
    /// Compass direction from which the camera looks. With 180 deg the north is in the middle.
    pub view_from: Angle,
    /// Angle by which the camera looks down.
    #[schemars(extend("x-min" = 3.0, "x-max" = 89.0))]
    pub tilt: Angle,
    /// Compass direction of the sun.
    pub sun: Angle,
    /// Altitude of the sun.
    #[schemars(extend("x-min" = 1.0, "x-max" = 90.0))]
    pub sun_altitude: Angle,
    /// Factor on elevations.
    #[schemars(extend("x-above" = 0.0, "x-max" = 100.0))]
    pub exaggeration: f64,
    /// Zoom factor. With 1 the whole block is in view; larger values come closer.
    #[schemars(extend("x-min" = 0.1, "x-max" = 20.0))]
    pub zoom: f64,
}

impl Default for WritePovray {
    fn default() -> Self {
        let view = View::default();
        Self {
            path: "scene.pov".into(),
            water: view.water,
            sea_level: None,
            view_from: Angle::from_si(view.from),
            tilt: Angle::from_si(view.tilt),
            sun: Angle::from_si(view.sun),
            sun_altitude: Angle::from_si(view.sun_altitude),
            exaggeration: view.exaggeration,
            zoom: view.zoom,
        }
    }
}

impl Params for WritePovray {
    const NAME: &'static str = "write_povray";
    const SOURCES: &'static [Source] = &[];

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone(), self.beside("ground"), self.beside("lakes")]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["pov"])?;
        if !self.path.chars().all(|c| c.is_ascii_graphic() && c != '\\' || c == ' ') {
            let expected = "a path of plain letters (ASCII), without a backslash: POV-Ray reads no others";
            return Err(Error::parameter("path", format!("{:?}", self.path), expected));
        }
        let numbers = [("exaggeration", self.exaggeration), ("zoom", self.zoom)];
        match numbers.into_iter().find(|n| !n.1.is_finite()) {
            Some((name, value)) => Err(Error::parameter(name, value, "a finite number, such as 1.5")),
            None => Ok(()),
        }
    }
}

impl WritePovray {
    /// Path of a file of heights beside the scene.
    fn beside(&self, what: &str) -> String {
        let stem = self.path.rsplit_once('.').map_or(self.path.as_str(), |(stem, _)| stem);
        format!("{stem}_{what}.png")
    }

    fn view(&self) -> View {
        View {
            from: self.view_from.si(),
            tilt: self.tilt.si(),
            sun: self.sun.si(),
            sun_altitude: self.sun_altitude.si(),
            exaggeration: self.exaggeration,
            zoom: self.zoom,
            water: self.water,
            ..View::default()
        }
    }
}

impl<T: Rasterize> Export<T> for WritePovray {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let raster = landscape.terrain.rasterized()?;
        let (grid, z) = (raster.grid(), raster.elevation());
        if grid.shape.rows < 2 || grid.shape.cols < 2 {
            return Err(Error::NoFace { what: "a height field" });
        }
        let level = landscape.environment.sea(self.sea_level).unwrap_or(0.0);
        let view = View { sea_level: level, ..self.view() };
        let block = BlockView::new(&raster, &view);
        let ground = Ground::of(&raster, block.range);
        let has_sea = self.water && ground.low < level && level < ground.high;
        let is_sea = |z: f64| has_sea && z < level;
        let lake = |(&z, &depth): (&f64, &f64)| if is_sea(z) { 0.0 } else { depth };
        let depth: Vec<f64> = z.iter().zip(&block.depth).map(lake).collect();
        let surface = z.iter().zip(&depth).filter(|(z, _)| z.is_finite()).map(|(z, depth)| z + depth);
        let heights = Heights::between(block.foot / self.exaggeration, surface.fold(ground.high, f64::max));
        let lakes = if self.water { heights.lakes(grid.shape, z, &depth) } else { None };
        let [ground_file, lakes_file] = ["ground", "lakes"].map(|what| self.beside(what));
        let scene = Scene {
            title: landscape.title,
            seed: landscape.seed,
            path: &self.path,
            ground_file: &ground_file,
            lakes_file: lakes.as_ref().map(|_| lakes_file.as_str()),
            grid,
            heights,
            ground,
            sea: has_sea.then_some(level),
            block: &block,
            view: &view,
            nodata: z.iter().filter(|z| z.is_nan()).count(),
        };
        if scene.nodata > 0 {
            out.note(format!("{} nodes without data lie at the least elevation in `{}`", scene.nodata, self.path));
        }
        out.put(&ground_file, &encode_grey(&heights.ground(z, ground.low), grid.shape)?)?;
        if let Some(lakes) = lakes {
            out.put(&lakes_file, &encode_grey(&lakes, grid.shape)?)?;
        }
        out.put(&self.path, scene.text().as_bytes())
    }
}

#[cfg(test)]
mod tests;
