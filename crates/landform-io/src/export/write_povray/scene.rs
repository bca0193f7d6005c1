//! The text of a scene.

use landform_core::grid::Grid;
use landform_core::math;
use landform_core::terrain::HeightField;

use super::heights::Heights;
use crate::render::ground::{
    CUT, DEEP, FOREST, HEATH, HEATH_BEGINS, MEADOW, ROCK, ROCK_BEGINS, SAND, SKY, SNOW, SNOW_ENDS, is_desert, low_land,
    snow_line,
};
use crate::render::{BlockView, View};

/// What the colours of the ground follow.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    /// Least elevation, m.
    pub(super) low: f64,
    /// Greatest elevation, m.
    pub(super) high: f64,
    is_desert: bool,
}

impl Ground {
    pub(super) fn of(field: &HeightField, (low, high): (f64, f64)) -> Self {
        Self { low, high, is_desert: is_desert(field) }
    }
}

/// All that a scene says.
pub(super) struct Scene<'a> {
    pub(super) title: &'a str,
    pub(super) seed: u64,
    pub(super) path: &'a str,
    pub(super) ground_file: &'a str,
    pub(super) lakes_file: Option<&'a str>,
    pub(super) grid: &'a Grid,
    pub(super) heights: Heights,
    pub(super) ground: Ground,
    /// Level of the sea, m, where there is one.
    pub(super) sea: Option<f64>,
    pub(super) block: &'a BlockView,
    pub(super) view: &'a View,
    /// Nodes without data.
    pub(super) nodata: usize,
}

impl Scene<'_> {
    pub(super) fn text(&self) -> String {
        let parts = [self.head(), self.light(), self.colours(), self.land(), self.water()];
        parts.iter().filter(|part| !part.is_empty()).cloned().collect::<Vec<_>>().join("\n")
    }

    fn head(&self) -> String {
        let ([w, h], Heights { foot, step }) = (self.grid.extent(), self.heights);
        let [east, north] = self.grid.origin;
        let plain: String = self.title.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let file = name(self.path);
        let nodata = match self.nodata {
            0 => String::new(),
            n => format!("// {n} nodes without data lie at the least elevation.\n"),
        };
        format!(
            "// {plain}, seed {}, written by landform {}.\n\
             // Render it in its own folder: povray +I{file} +W1600 +H900 +A0.2\n\
             // Unit: metre. x is east, y is up, z is north; <0, 0, 0> is elevation 0 at the corner of\n\
             // the least easting and northing. The first row of a file of heights is the north side,\n\
             // at z = Length; its first column is the west side, at x = 0.\n\
             // The first node of the landscape, in the north-west, is at {east}, {north}.\n{nodata}\
             #version 3.7;\n\
             global_settings {{ assumed_gamma 1 }}\n\n\
             #declare Width = {w}; // m, east\n\
             #declare Length = {h}; // m, north\n\
             #declare Foot = {foot}; // m, height of step 0\n\
             #declare Step = {step}; // m, height of a step of the 16-bit heights\n\
             #declare Exaggeration = {}; // factor on heights\n",
            self.seed,
            env!("CARGO_PKG_VERSION"),
            self.view.exaggeration,
        )
    }

    fn light(&self) -> String {
        let View { sun, sun_altitude, .. } = *self.view;
        let BlockView { camera, forward, angle, .. } = self.block;
        let [w, h] = self.grid.extent();
        let far = 10.0 * (w + h);
        let across = math::cos(sun_altitude);
        let direction = [math::sin(sun) * across, math::cos(sun) * across, math::sin(sun_altitude)];
        let ahead = [0, 1, 2].map(|k| camera[k] + forward[k] * (w + h));
        let [zenith, horizon] = SKY.map(colour);
        format!(
            "camera {{\n  location {}\n  right x * image_width / image_height\n  angle {:.6} // from left to right\n  \
             look_at {}\n}}\n\
             #declare Sun = {}; // towards it\n\
             light_source {{ Sun * {far} rgb <1.9, 1.71, 1.43> parallel point_at 0 }}\n\
             // The sky's own light comes from above and throws no shadow.\n\
             light_source {{ y * {far} rgb <0.25, 0.31, 0.41> parallel point_at 0 shadowless }}\n\
             sky_sphere {{\n  pigment {{\n    function {{ max(0, min(0.999, (y + 0.35) / 0.8)) }}\n    \
             color_map {{ [0 {horizon} * 0.85] [1 {zenith} * 0.85] }}\n  }}\n}}\n",
            vector(*camera),
            angle.to_degrees(),
            vector(ahead),
            vector(direction),
        )
    }

    /// Colours by height and slope, as those of landform's own pictures.
    fn colours(&self) -> String {
        let Ground { low, high, is_desert } = self.ground;
        let factor = self.view.exaggeration;
        let base = low_land(low, high, self.sea.unwrap_or(0.0));
        let relief = (high - base).max(1e-6);
        let [w, h] = self.grid.extent();
        let size = w.max(h);
        let [cut, _] = CUT.map(colour);
        let patches = |[a, b]: [u32; 2], scale: f64| {
            format!("bozo color_map {{ [0.2 {}] [0.8 {}] }} scale {}", colour(a), colour(b), size / scale)
        };
        let wood = format!(
            "bozo turbulence 0.6 color_map {{ [0.25 {}] [0.5 {}] [0.62 {}] [0.9 {}] }} scale {}",
            colour(MEADOW[0]),
            colour(MEADOW[1]),
            colour(FOREST[1]),
            colour(FOREST[0]),
            size / 40.0,
        );
        let [meadow, heath] = if is_desert { [colour(SAND), colour(SAND)] } else { [wood, patches(HEATH, 24.0)] };
        let line = snow_line(high - base);
        let snow = [("Heath", line - 0.02), ("Snow", line + 0.1)];
        let entries = [("Meadow", HEATH_BEGINS[0]), ("Heath", HEATH_BEGINS[1])].into_iter().chain(snow);
        let map: String = entries.filter(|e| e.1 < 1.0).map(|(name, part)| format!(" [{part:.4} {name}]")).collect();
        // The pattern `slope` is 1 on level ground, 1/2 on a wall.
        let level = |slope: f64| 1.0 - math::atan(slope * factor) / std::f64::consts::PI;
        let under = |name: &str, pigment: &str, slopes: [f64; 2]| {
            let [gentle, steep] = slopes.map(level);
            let map = format!("[{steep:.6} Rock] [{gentle:.6} {pigment}]");
            format!("#declare {name} = pigment {{ slope {{ y }} pigment_map {{ {map} }} }}\n")
        };
        format!(
            "#declare Rock = pigment {{ {} }}\n{}{}{}\
             #declare GroundTexture = texture {{\n  pigment {{\n    \
             function {{ max(0, min(0.999, (y - {}) / {})) }} // part of the relief\n    \
             pigment_map {{{map} }}\n  }}\n  finish {{ ambient 0.2 diffuse 0.8 }}\n}}\n\
             #declare WallTexture = texture {{ pigment {{ {cut} }} finish {{ ambient 0.45 diffuse 0.5 }} }}\n",
            patches(ROCK, 24.0),
            under("Meadow", &meadow, ROCK_BEGINS),
            under("Heath", &heath, ROCK_BEGINS),
            under("Snow", &colour(SNOW), SNOW_ENDS),
            base * factor,
            relief * factor,
        )
    }

    fn land(&self) -> String {
        format!(
            "#declare InMetres = transform {{\n  scale <Width, 65536 * Step, Length>\n  translate y * Foot\n  \
             scale <1, Exaggeration, 1>\n}}\n\
             // A box, cut off by the ground.\n\
             #declare Edge = 0.000001 * (Width + Length);\n\
             intersection {{\n  height_field {{\n    png {} smooth\n    transform InMetres\n    \
             texture {{ GroundTexture }}\n  }}\n  box {{\n    <Edge, Exaggeration * Foot, Edge>\n    \
             <Width - Edge, Exaggeration * (Foot + 65537 * Step), Length - Edge>\n    texture {{ WallTexture }}\n  }}\n}}\n",
            quoted(name(self.ground_file)),
        )
    }

    fn water(&self) -> String {
        if self.sea.is_none() && self.lakes_file.is_none() {
            return String::new();
        }
        let mut text = format!(
            "#declare WaterTexture = texture {{\n  pigment {{ {} transmit 0.1 }}\n  \
             finish {{ ambient 0.2 diffuse 0.8 reflection {{ 0.03, 0.6 falloff 4 }} }}\n}}\n",
            colour(DEEP)
        );
        if let Some(level) = self.sea {
            text += &format!(
                "#declare SeaLevel = {level}; // m\n\
                 box {{\n  <2 * Edge, Exaggeration * Foot, 2 * Edge>\n  \
                 <Width - 2 * Edge, Exaggeration * SeaLevel, Length - 2 * Edge>\n  texture {{ WaterTexture }}\n}}\n"
            );
        }
        if let Some(file) = self.lakes_file {
            text += &format!(
                "// Lakes: a surface that lies at the foot, cut away, where there are none.\n\
                 height_field {{\n  png {} smooth water_level 0.5 / 65536\n  transform InMetres\n  \
                 texture {{ WaterTexture }}\n}}\n",
                quoted(name(file)),
            );
        }
        text
    }
}

/// A place or direction (x east, y north, z up) in the axes of the scene, in which y is up.
fn vector([east, north, up]: [f64; 3]) -> String {
    format!("<{east:.6}, {up:.6}, {north:.6}>")
}

/// A colour in the words of POV-Ray.
fn colour(code: u32) -> String {
    let [r, g, b] = [16, 8, 0].map(|shift| f64::from(code >> shift & 0xff) / 255.0);
    format!("srgb <{r:.4}, {g:.4}, {b:.4}>")
}

/// The last part of a path.
fn name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
