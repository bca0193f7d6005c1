//! Rivers, lakes and basins as a vector file.

use std::borrow::Cow;

use landform_core::analysis::{Basin, Drainage, Lake, Polygon, RiverReach, Width, basins, lakes, rivers};
use landform_core::units::{Area, Length, Rate};
use landform_core::verb::{Export, Landscape, Output, Params, Source, relative_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value as Json, json};

use super::Drawable;
use super::geojson::{Digits, collection, feature};

/// Writes rivers as lines that only run downhill (x, y and the water's elevation), lakes and basins as polygons, with their
/// properties: GeoJSON in the landscape's own metres.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteFeatures {
    /// Path below the output folder.
    pub path: String,
    /// Whether rivers are written.
    pub rivers: bool,
    /// Whether lakes are written.
    pub lakes: bool,
    /// Whether basins are written.
    pub basins: bool,
    /// Least drainage area of a river and of a basin; a two-thousandth of the map if not given.
    #[schemars(extend("x-above" = 0.0))]
    pub least_area: Option<Area>,
    /// Least depth of a lake, where it is deepest.
    #[schemars(extend("x-min" = 0.0))]
    pub least_depth: Length,
    /// Level of the sea, at which rivers end; at the landscape's own outlets if not given.
    pub sea_level: Option<Length>,
    /// Rainfall for discharge, where the landscape has no field of it; all of it runs off.
    #[schemars(extend("x-min" = 0.0))]
    pub rainfall: Rate,
    /// Width of a river that carries 1 m3/s, m, where the depth of the water is not known.
    #[schemars(extend("x-above" = 0.0))]
    pub width_coefficient: f64,
    /// Power of the discharge with which width grows.
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub width_exponent: f64,
}

impl Default for WriteFeatures {
    fn default() -> Self {
        let width = Width::default();
        Self {
            path: "features.geojson".into(),
            rivers: true,
            lakes: true,
            basins: true,
            least_area: None,
            least_depth: Length::of(1.0),
            sea_level: None,
            rainfall: Rate::of(1_000.0),
            width_coefficient: width.coefficient,
            width_exponent: width.exponent,
        }
    }
}

impl Params for WriteFeatures {
    const NAME: &'static str = "write_features";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Strahler (1957)",
            title: "Quantitative analysis of watershed geomorphology, Eos 38(6)",
            doi: "10.1029/TR038i006p00913",
        },
        Source {
            authors: "Moody & Troutman (2002)",
            title: "Characterization of the spatial variability of channel morphology, Earth Surface Processes and Landforms 27",
            doi: "10.1002/esp.403",
        },
    ];

    fn check(&self) -> Result<()> {
        relative_path(&self.path)?;
        let known = [".geojson", ".json"].iter().any(|e| self.path.to_lowercase().ends_with(e));
        if known {
            Ok(())
        } else {
            Err(Error::parameter("path", format!("\"{}\"", self.path), "a name that ends with .geojson"))
        }
    }
}

impl<T: Drawable> Export<T> for WriteFeatures {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let terrain = landscape.terrain;
        let mut features = Vec::new();
        let [lo, hi] = terrain.bounds();
        let longer = (hi[0] - lo[0]).max(hi[1] - lo[1]);
        let side = |k: usize| if hi[k] > lo[k] { hi[k] - lo[k] } else { longer / terrain.elevation().len() as f64 };
        let map = (side(0) * side(1)).max(f64::MIN_POSITIVE);
        let digits = Digits::of((map / terrain.elevation().len() as f64).sqrt());
        let least = self.least_area.map_or(map / 2_000.0, Area::si);
        let (sea, rain) = (self.sea_level.map(Length::si), self.rainfall.si());
        if self.rivers {
            let drainage = Drainage::of(terrain, sea, rain);
            let width = Width { coefficient: self.width_coefficient, exponent: self.width_exponent };
            features.extend(rivers(terrain, &drainage, least, width).iter().map(|r| river(r, digits)));
        }
        if self.lakes || self.basins {
            let raster: Cow<'_, _> = terrain.raster()?;
            let drainage = Drainage::of(&*raster, sea, rain);
            if self.lakes {
                let least_area = 4.0 * raster.grid.cell_area();
                let found = lakes(&raster, &drainage, self.least_depth.si(), least_area);
                features.extend(found.iter().enumerate().map(|(k, l)| lake(k, l, digits)));
            }
            if self.basins {
                features.extend(basins(&raster, &drainage, least).iter().enumerate().map(|(k, b)| basin(k, b, digits)));
            }
        }
        out.put(&self.path, collection(landscape.title, terrain.epsg(), features)?.as_bytes())
    }
}

/// Four digits.
fn short(v: f64) -> f64 {
    format!("{v:.3e}").parse().unwrap_or(v)
}

fn river(r: &RiverReach, digits: Digits) -> Json {
    let id = |(river, reach): (u32, u32)| format!("{river}.{reach}");
    let points: Vec<_> = r.points.iter().map(|p| digits.all(*p)).collect();
    let (above, below) = (points[0][2], points[points.len() - 1][2]);
    let properties = json!({
        "kind": "river",
        "id": id((r.river, r.reach)),
        "river": r.river,
        "reach": r.reach,
        "flows_to": r.to.map(id),
        "ends": match (r.to, r.leaves) { (Some(_), _) => "in a river", (None, true) => "at an outlet", _ => "in a hollow" },
        "order": r.order,
        "drainage_area_m2": short(r.area),
        "discharge_m3_s": short(r.discharge),
        "width_m": short(r.width),
        "width_above_m": short(r.width_above),
        "depth_m": short(r.depth),
        "length_m": short(r.length),
        "elevation_above_m": above,
        "elevation_below_m": below,
    });
    feature("LineString", json!(points), properties)
}

fn rings(polygon: &Polygon, digits: Digits) -> Json {
    json!(polygon.iter().map(|ring| ring.iter().map(|p| digits.all(*p)).collect()).collect::<Vec<Vec<_>>>())
}

fn lake(k: usize, l: &Lake, digits: Digits) -> Json {
    let properties = json!({
        "kind": "lake",
        "id": format!("lake {}", k + 1),
        "level_m": digits.round(l.level),
        "depth_m": digits.round(l.depth),
        "mean_depth_m": digits.round(l.volume / l.area),
        "area_m2": short(l.area),
        "volume_m3": short(l.volume),
        "outlet": l.outlet.map(|p| digits.all(p)),
        "discharge_m3_s": short(l.discharge),
    });
    feature("Polygon", rings(&l.shore, digits), properties)
}

fn basin(k: usize, b: &Basin, digits: Digits) -> Json {
    let [least, mean, greatest] = digits.all(b.elevation);
    let properties = json!({
        "kind": "basin",
        "id": format!("basin {}", k + 1),
        "area_m2": short(b.area),
        "outlet": digits.all(b.outlet),
        "lowest_m": least,
        "mean_m": mean,
        "highest_m": greatest,
        "hypsometric_integral": short(b.hypsometric_integral),
    });
    feature("MultiPolygon", json!(b.outline.iter().map(|p| rings(p, digits)).collect::<Vec<_>>()), properties)
}
