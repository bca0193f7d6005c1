//! The landscape as a picture.

use landform_core::analysis::{LEAST_WINDOW, density};
use landform_core::field::names::unit_of;
use landform_core::grid::Shape;
use landform_core::terrain::{Bounds, Ground, HeightField, Mesh, NodeSurface, Rasterize, VoxelGrid, nothing_solid};
use landform_core::units::{Angle, Length};
use landform_core::verb::{Environment, Export, Landscape, Output, Params, Reach, Source, file_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::encode_png;
use crate::render::{
    CutawayView, MapStyle, Picture, Ramp, Standpoint, View, cutaway, field_map_with_legend, perspective, shaded_map,
    solid, value_picture,
};

/// Writes a picture (PNG): a map from above, or a perspective view.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WritePicture {
    /// Path below the output folder.
    pub path: String,
    /// View that is drawn.
    pub view: ViewKind,
    /// Length of the longer side, pixels.
    #[schemars(extend("x-min" = 16, "x-max" = 16_384))]
    pub size: usize,
    /// Map only: field that is shown, with a legend of its ramp. If not given, it is elevation with
    /// rivers and lakes.
    pub field: Option<String>,
    /// Map only: colour ramp.
    pub ramp: Option<Ramp>,
    /// Map only: whether the field has a logarithmic scale.
    pub logarithmic: Option<bool>,
    /// Whether rivers and lakes are drawn.
    pub water: bool,
    /// Sea level. If not given, it is the environment's, or else 0 m.
    pub sea_level: Option<Length>,
    /// Perspective and landscape: compass direction from which the camera looks. With 180 deg the
    /// north is in the middle.
    pub view_from: Angle,
    /// Perspective and landscape: angle by which the camera looks down. If not given, it is 26 deg
    /// before a block, and in the land one that shows the skyline.
    #[schemars(extend("x-min" = -60.0, "x-max" = 89.0))]
    pub tilt: Option<Angle>,
    /// Landscape only: place of the eye, [x, y] from the south-west corner of the map. If not
    /// given, it is one with a wide view, on the side from which one looks.
    pub standpoint: Option<[Length; 2]>,
    /// Landscape only: height of the eye over the ground. If not given, it is 3 % of the relief,
    /// and at least 2 m.
    #[schemars(extend("x-above" = 0.0))]
    pub eye_height: Option<Length>,
    /// Perspective and landscape: compass direction of the sun.
    pub sun: Angle,
    /// Perspective and landscape: altitude of the sun.
    #[schemars(extend("x-min" = 1.0, "x-max" = 90.0))]
    pub sun_altitude: Angle,
    /// Perspective and landscape: factor on elevations.
    #[schemars(extend("x-above" = 0.0, "x-max" = 100.0))]
    pub exaggeration: f64,
    /// Perspective and landscape: zoom factor. With 1 the whole block is in view, or an angle of
    /// 56 deg in the land; larger values come closer.
    #[schemars(extend("x-min" = 0.1, "x-max" = 20.0))]
    pub zoom: f64,
}

/// View of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ViewKind {
    /// From above, north up.
    Map,
    /// A block of land under a low sun; of voxels with their overhangs, seen from far.
    Perspective,
    /// The land from a standpoint in it, up to the horizon.
    Landscape,
    /// The spectral density of relief over the plane of wave numbers, with long waves in the
    /// middle. Density and radius are logarithmic.
    Spectrum,
    /// Voxels only: a block of rock cut open, with the passages of its cave.
    Cutaway,
}

impl Default for WritePicture {
    fn default() -> Self {
        let view = View::default();
        Self {
            path: "picture.png".into(),
            view: ViewKind::Perspective,
            size: 1600,
            field: None,
            ramp: None,
            logarithmic: None,
            water: true,
            sea_level: None,
            view_from: Angle::from_si(view.from),
            tilt: None,
            standpoint: None,
            eye_height: None,
            sun: Angle::from_si(view.sun),
            sun_altitude: Angle::from_si(view.sun_altitude),
            exaggeration: view.exaggeration,
            zoom: view.zoom,
        }
    }
}

impl Params for WritePicture {
    const NAME: &'static str = "write_picture";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(if self.view == ViewKind::Map { 85 } else { 150 })
    }

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        file_path(&self.path)?;
        if !(self.zoom.is_finite() && self.exaggeration.is_finite()) {
            return Err(Error::parameter("zoom", "not a finite number", "a number such as 1.5"));
        }
        if !self.path.to_lowercase().ends_with(".png") {
            return Err(Error::extension("path", &self.path, &["png"]));
        }
        let given = [("standpoint", self.standpoint.is_some()), ("eye_height", self.eye_height.is_some())];
        if let Some((name, _)) = given.into_iter().find(|g| g.1 && self.view != ViewKind::Landscape) {
            return Err(Error::Incomplete { name: name.into(), needs: "view = \"landscape\"" });
        }
        if self.view == ViewKind::Perspective && self.tilt.is_some_and(|tilt| tilt.si() < 3.0_f64.to_radians()) {
            let tilt = self.tilt.map_or(0.0, Angle::si).to_degrees();
            let expected = "at least 3 deg before a block; view = \"landscape\" stands in the land";
            return Err(Error::parameter("tilt", format!("{tilt:.1} deg"), expected));
        }
        Ok(())
    }
}

impl WritePicture {
    /// Draws the picture.
    ///
    /// # Errors
    /// If a field is missing, and where `HeightField::new` fails.
    pub fn draw<T: Rasterize>(&self, terrain: &T) -> Result<Picture> {
        let raster = terrain.rasterized()?;
        if [ViewKind::Perspective, ViewKind::Landscape].contains(&self.view) {
            let view = View::default();
            self.check_standpoint(raster.grid().extent())?;
            let standpoint = Standpoint {
                at: self.standpoint.map(|place| place.map(Length::si)),
                height: self.eye_height.map(Length::si),
                tilt: self.tilt.map(Angle::si),
            };
            return Ok(perspective(
                &raster,
                &View {
                    width: self.size,
                    height: self.size * 9 / 16,
                    from: self.view_from.si(),
                    tilt: self.tilt.map_or(view.tilt, Angle::si),
                    sun: self.sun.si(),
                    sun_altitude: self.sun_altitude.si(),
                    exaggeration: self.exaggeration,
                    zoom: self.zoom,
                    water: self.water,
                    sea_level: self.sea_level.map_or(0.0, Length::si),
                    standpoint: (self.view == ViewKind::Landscape).then_some(standpoint),
                    ..view
                },
            ));
        }
        if self.view == ViewKind::Cutaway {
            let expected = "a view of a surface; `to_voxels` or `rock_volume` make what can be cut open";
            return Err(Error::parameter("view", "\"cutaway\" on a surface", expected));
        }
        if self.view == ViewKind::Spectrum {
            return self.spectrum(&raster);
        }
        let field = self.field.as_deref().filter(|f| *f != "elevation");
        let style = MapStyle {
            size: self.size,
            ramp: self.ramp.unwrap_or(if field.is_some() { Ramp::Dusk } else { Ramp::Terrain }),
            logarithmic: self.logarithmic.unwrap_or(field == Some("drainage_area")),
            water: self.water,
            sea_level: self.sea_level.map_or(0.0, Length::si),
        };
        match field {
            None => shaded_map(&raster, &style),
            Some(name) => {
                let values = raster.real(name, "`write_picture`")?;
                let title = match unit_of(name) {
                    None | Some("1") => name.to_string(),
                    Some(unit) => format!("{name}, {unit}"),
                };
                field_map_with_legend(&raster, &values, &title, &style)
            }
        }
    }
}

impl WritePicture {
    fn check_standpoint(&self, [width, height]: [f64; 2]) -> Result<()> {
        let Some(place) = self.standpoint.map(|place| place.map(Length::si)) else { return Ok(()) };
        if (0.0..=width).contains(&place[0]) && (0.0..=height).contains(&place[1]) {
            return Ok(());
        }
        let value = format!("[{} m, {} m]", place[0], place[1]);
        Err(Error::parameter("standpoint", value, &format!("a place on the map, which is {width} x {height} m")))
    }

    /// The same picture with the sea of an environment, where it has no level of its own.
    ///
    /// ```
    /// use landform_core::verb::Environment;
    /// use landform_io::export::WritePicture;
    ///
    /// let plain = WritePicture::default().in_environment(&Environment::default());
    /// assert!(plain.sea_level.is_none());
    /// ```
    #[must_use]
    pub fn in_environment(self, environment: &Environment) -> Self {
        let sea_level = environment.sea(self.sea_level).map(Length::of);
        Self { sea_level, ..self }
    }

    fn write<T: Rasterize>(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let picture = self.clone().in_environment(landscape.environment).draw(landscape.terrain)?;
        out.put(&self.path, &encode_png(&picture.pixels, picture.shape)?)
    }

    fn spectrum(&self, raster: &HeightField) -> Result<Picture> {
        let Some((_, density)) = density(raster.grid(), raster.elevation(), true) else {
            let value = format!("a raster of {}", raster.grid().shape);
            return Err(Error::parameter(
                "view",
                value,
                &format!("a square of {LEAST_WINDOW} nodes with data for a spectrum"),
            ));
        };
        let side = self.size.clamp(16, 2048) | 1;
        let values = density.log_plot(side);
        Ok(value_picture(Shape::new(side, side), &values, self.ramp.unwrap_or(Ramp::Dusk)))
    }
}

impl Export<HeightField> for WritePicture {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        self.write(landscape, out)
    }
}

impl Export<Mesh> for WritePicture {
    fn export(&self, landscape: &Landscape<'_, Mesh>, out: &mut dyn Output) -> Result<()> {
        self.write(landscape, out)
    }
}

impl Export<VoxelGrid> for WritePicture {
    fn export(&self, landscape: &Landscape<'_, VoxelGrid>, out: &mut dyn Output) -> Result<()> {
        if !matches!(self.view, ViewKind::Cutaway | ViewKind::Perspective) {
            let expected =
                "\"perspective\" or \"cutaway\" for a voxel grid; `uppermost_surface` makes a height field of it";
            return Err(Error::parameter("view", "a view of a surface", expected));
        }
        let ground = landscape.terrain;
        let (size, view) = (self.size, View::default());
        let is_outside = self.view == ViewKind::Perspective;
        let from = if self.view_from.si() == view.from && !is_outside { 2.62 } else { self.view_from.si() };
        let least_altitude = if is_outside { 0.05 } else { 0.6 };
        let block = CutawayView {
            shape: Shape::new((size * 5 / 8).max(1), size),
            from,
            tilt: self.tilt.map_or(0.62, Angle::si).clamp(0.05, 1.5),
            sun: [self.sun.si(), self.sun_altitude.si().max(least_altitude)],
            zoom: self.zoom,
        };
        if is_outside {
            if ground.solids() == 0 {
                return Err(nothing_solid());
            }
            let sea = landscape.environment.sea(self.sea_level).filter(|_| self.water);
            let picture = solid(ground, &block, sea);
            return out.put(&self.path, &encode_png(&picture.pixels, picture.shape)?);
        }
        let (mut picture, rule) = cutaway(ground, &block);
        let Bounds { low, high } = ground.bounding_box();
        let side = [0, 1, 2].map(|k| format!("{:.0}", high[k] - low[k])).join(" x ");
        picture.label(&format!("{side} m, rule in {rule} m"));
        out.put(&self.path, &encode_png(&picture.pixels, picture.shape)?)
    }
}
