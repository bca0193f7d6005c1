//! Rivers and roads as splines.
//!
//! # Model
//! A spline has a width and a depth at each of its points. Along a reach of a river discharge
//! grows evenly from its upper end to its lower one, and width and depth with it: w ∝ Q^0.5, d ∝
//! Q^0.39. A river's points are nodes of the ground, moved to the mean (1, 2, 1) of three, by less
//! than half a cell, so that its corners are less sharp; it still runs downhill only.
//!
//! # Sources
//! Moody & Troutman (2002) for width and depth.
//!
//! # Checked by
//! `tests`: within half a cell of the river, downhill, widths at the ends; both files read back.

use std::fmt::Write;

use landform_core::analysis::{FeatureSearch, find_features};
use landform_core::feature::{Feature, FeatureKind, Geometry};
use landform_core::terrain::Rasterize;
use landform_core::units::{Area, Length, Rate};
use landform_core::verb::{Export, FeatureWord, Landscape, Output, Params, Source, check_path};
use landform_core::{Error, Result, math};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::places::{PlacePreset, rounded, single};

/// Writes rivers and roads as splines with a width and a depth at every point (JSON or CSV), with a
/// card (name.ext.md) that says in which coordinates. Features that the landscape already has are
/// written; rivers and coasts are found if it has none.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::HeightField;
/// use landform_core::verb::{Export, Landscape, MemoryOutput};
/// use landform_io::export::WriteSplines;
///
/// let ramp = (0..400).map(|i| f64::from(i % 20)).collect();
/// let ground = HeightField::new(Grid::new(Shape::new(20, 20), [10.0, 10.0])?, ramp)?;
/// let mut out = MemoryOutput::default();
/// WriteSplines::default().export(&Landscape::plain(&ground), &mut out)?;
/// assert!(String::from_utf8_lossy(&out.0["splines.json"]).contains("\"kind\":\"river\""));
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteSplines {
    /// Path below the output folder.
    pub path: String,
    /// Kinds of features: "rivers", "paths", "coasts", "contours".
    pub features: Vec<FeatureWord>,
    /// Coordinates of places.
    pub preset: PlacePreset,
    /// Least drainage area of a river. If not given, it is a two-thousandth of the map.
    #[schemars(extend("x-above" = 0.0))]
    pub least_area: Option<Area>,
    /// Sea level, at which rivers end. If not given, it is the environment's.
    pub sea_level: Option<Length>,
}

impl Default for WriteSplines {
    fn default() -> Self {
        Self {
            path: "splines.json".into(),
            features: vec![FeatureWord::Rivers],
            preset: PlacePreset::Landscape,
            least_area: None,
            sea_level: None,
        }
    }
}

/// Kinds that are lines.
const LINES: &[FeatureKind] = &[FeatureKind::River, FeatureKind::Path, FeatureKind::Coast, FeatureKind::Contour];

impl Params for WriteSplines {
    const NAME: &'static str = "write_splines";
    const SOURCES: &'static [Source] = FeatureSearch::SOURCES;

    fn bytes_a_node(&self) -> Option<u64> {
        Some(80)
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone(), format!("{}.md", self.path)]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["json", "csv"])?;
        let words = || LINES.iter().map(|kind| format!("\"{}s\"", kind.word())).collect::<Vec<_>>().join(", ");
        if self.features.is_empty() {
            return Err(Error::parameter("features", "[]", &format!("some of {}", words())));
        }
        match self.features.iter().find(|word| !LINES.contains(&word.kind())) {
            Some(word) => {
                let given = format!("\"{}s\"", word.kind().word());
                Err(Error::parameter("features", given, &format!("features that are lines: {}", words())))
            }
            None => Ok(()),
        }
    }
}

/// A line with a width and a depth at each point, m.
struct Spline<'a> {
    feature: &'a Feature,
    points: Vec<[f64; 3]>,
    width: Vec<f64>,
    depth: Vec<f64>,
}

impl<'a> Spline<'a> {
    /// `cell` is the distance of nodes, m.
    fn of(feature: &'a Feature, cell: f64) -> Self {
        let number = |name: &str| feature.number(name).unwrap_or(0.0);
        let points: Vec<[f64; 3]> = match &feature.geometry {
            Geometry::Line(line) if feature.kind == FeatureKind::River => eased(line, cell),
            Geometry::Line(line) => line.clone(),
            Geometry::FlatLine(line) => line.iter().map(|p| [p[0], p[1], number("level_m")]).collect(),
            _ => Vec::new(),
        };
        if feature.kind != FeatureKind::River {
            let width = vec![number("width_m"); points.len()];
            let depth = vec![0.0; points.len()];
            return Self { feature, points, width, depth };
        }
        let (above, below, deep) = (number("width_above_m"), number("width_m"), number("depth_m"));
        let at = along(&points);
        let whole = at.last().copied().unwrap_or(0.0);
        // The part of the lower end's discharge, by w ∝ Q^0.5.
        let start = if below > 0.0 { (above / below).min(1.0) } else { 0.0 };
        let part = |at: f64| if whole > 0.0 { math::lerp(start * start, 1.0, at / whole) } else { 1.0 };
        let width = at.iter().map(|&at| below * part(at).sqrt()).collect();
        let depth = at.iter().map(|&at| deep * math::pow(part(at), 0.39)).collect();
        Self { feature, points, width, depth }
    }
}

/// Distances from the start of a line, m.
fn along(points: &[[f64; 3]]) -> Vec<f64> {
    let steps = points.windows(2).map(|w| math::hypot(w[1][0] - w[0][0], w[1][1] - w[0][1]));
    let sums = steps.scan(0.0, |sum, step| {
        *sum += step;
        Some(*sum)
    });
    points.first().map(|_| 0.0).into_iter().chain(sums).collect()
}

/// The farthest that a point of a river is moved, in cells.
const MOST_MOVED: f64 = 0.45;

/// Means of three points, none farther from its place than a part of a cell; ends stay.
fn eased(line: &[[f64; 3]], cell: f64) -> Vec<[f64; 3]> {
    let middle = |w: &[[f64; 3]]| {
        let shift: [f64; 3] = std::array::from_fn(|k| 0.25 * (w[0][k] + w[2][k] - 2.0 * w[1][k]));
        let far = math::hypot(shift[0], shift[1]);
        let less = if far > MOST_MOVED * cell { MOST_MOVED * cell / far } else { 1.0 };
        std::array::from_fn(|k| w[1][k] + less * shift[k])
    };
    let inner = line.windows(3).map(middle);
    line.first().copied().into_iter().chain(inner).chain(line.last().copied().filter(|_| line.len() > 1)).collect()
}

impl<T: Rasterize> Export<T> for WriteSplines {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let terrain = landscape.terrain;
        let known = terrain.features();
        let kinds: Vec<FeatureKind> = self.features.iter().map(|w| w.kind()).collect();
        let is_absent = |kind: &FeatureKind| known.of(*kind).next().is_none();
        let (mut absent, mut left) = (Vec::new(), Vec::new());
        kinds.iter().copied().filter(is_absent).for_each(|kind| {
            let findable = [FeatureKind::River, FeatureKind::Coast].contains(&kind);
            if findable { &mut absent } else { &mut left }.push(kind);
        });
        if let Some(kind) = left.first() {
            known.need(*kind, "`write_splines`")?;
        }
        let rain = landscape.environment.uniform_rain().map_or(FeatureSearch::DEFAULT_RAIN, Rate::si);
        let search = FeatureSearch {
            kinds: absent,
            least_area: self.least_area.map(Area::si),
            sea_level: landscape.environment.sea(self.sea_level),
            rainfall: rain,
            ..FeatureSearch::of(FeatureKind::River)
        };
        let found = find_features(terrain, &search)?;
        let [sw, ne] = terrain.bounds();
        let cell = ((ne[0] - sw[0]) * (ne[1] - sw[1]) / terrain.elevation().len() as f64).sqrt();
        let of = |kind: &FeatureKind| {
            known.of(*kind).chain(found.of(*kind)).map(|f| Spline::of(f, cell)).collect::<Vec<_>>()
        };
        let mut splines: Vec<Spline> = kinds.iter().flat_map(of).filter(|s| !s.points.is_empty()).collect();
        for spline in &mut splines {
            let points = spline.points.iter().map(|p| self.preset.place([sw, ne], *p).map(|v| rounded(v, 3)));
            spline.points = points.collect();
            for values in [&mut spline.width, &mut spline.depth] {
                values.iter_mut().for_each(|v| *v = rounded(self.preset.length(*v), 3));
            }
        }
        let is_csv = self.path.to_lowercase().ends_with(".csv");
        let text = if is_csv { csv(&splines) } else { self.json(&splines, landscape.title)? };
        out.put(&self.path, text.as_bytes())?;
        out.put(&format!("{}.md", self.path), self.card(&splines, landscape.title, landscape.seed).as_bytes())
    }
}

fn csv(splines: &[Spline]) -> String {
    let mut text = String::from("spline,kind,id,point,x,y,z,width,depth\n");
    for (k, s) in splines.iter().enumerate() {
        let (kind, id) = (s.feature.kind.word(), &s.feature.id);
        for (j, [x, y, z]) in s.points.iter().enumerate() {
            writeln!(text, "{},{kind},{id},{},{x},{y},{z},{},{}", k + 1, j + 1, s.width[j], s.depth[j]).ok();
        }
    }
    text
}

impl WriteSplines {
    fn json(&self, splines: &[Spline], title: &str) -> Result<String> {
        let one = |s: &Spline| {
            let singles = s.feature.properties.iter().filter_map(|(name, p)| Some((name.clone(), single(p)?)));
            let properties: serde_json::Map<_, _> = singles.collect();
            let closed = s.points.len() > 2 && s.points.first() == s.points.last();
            json!({
                "kind": s.feature.kind.word(), "id": s.feature.id, "closed": closed, "points": s.points,
                "width": s.width, "depth": s.depth, "properties": properties,
            })
        };
        let all = json!({ "name": title, "unit": self.preset.unit(), "splines": splines.iter().map(one).collect::<Vec<_>>() });
        let text = serde_json::to_string(&all).map_err(|e| Error::format("JSON", e))?;
        // One spline a line: small differences stay small.
        Ok(text.replace("{\"closed\"", "\n{\"closed\"") + "\n")
    }

    fn card(&self, splines: &[Spline], title: &str, seed: u64) -> String {
        format!(
            "# {} splines of {title}\n\n`{}`, seed {seed}, written by landform {}.\n\nPlaces: {}. Every point has a width and \
             a depth ({}). Rivers run from their upper end down; z is the surface of the water, and a river that flows into \
             another ends at a point of it (flows_to). Roads have the height of their surface, and depth 0. Make a closed \
             spline of those that say so.\n",
            splines.len(),
            self.path,
            env!("CARGO_PKG_VERSION"),
            self.preset.meaning(),
            self.preset.unit(),
        )
    }
}

#[cfg(test)]
mod tests {
    use landform_core::feature::Property;
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::{HeightField, NodeSurface};
    use landform_core::verb::MemoryOutput;

    use super::*;

    /// A valley that winds to the south.
    fn valley() -> HeightField {
        let grid = Grid::new(Shape::new(80, 60), [10.0; 2]).unwrap();
        let z = (0..grid.len()).map(|i| grid.position(i)).map(|[x, y]| {
            let middle = 300.0 + 120.0 * math::sin(y / 90.0);
            0.05 * y + 0.2 * (x - middle).abs()
        });
        HeightField::new(grid.clone(), z.collect()).unwrap()
    }

    fn splines(params: &WriteSplines, field: &HeightField) -> String {
        params.validate().unwrap();
        let mut out = MemoryOutput::default();
        params.export(&Landscape::plain(field), &mut out).unwrap();
        assert_eq!(out.0.len(), 2);
        String::from_utf8(out.0[&params.path].clone()).unwrap()
    }

    #[test]
    fn splines_lie_within_half_a_cell_of_the_river_and_run_downhill() {
        let field = valley();
        let search = FeatureSearch::of(FeatureKind::River);
        let found = find_features(&field, &search).unwrap();
        let json: serde_json::Value = serde_json::from_str(&splines(&WriteSplines::default(), &field)).unwrap();
        let written = json["splines"].as_array().unwrap();
        assert_eq!(written.len(), found.iter().count());
        for (spline, river) in written.iter().zip(found.iter()) {
            let Geometry::Line(line) = &river.geometry else { panic!() };
            let points: Vec<[f64; 3]> = serde_json::from_value(spline["points"].clone()).unwrap();
            assert_eq!(points.len(), line.len());
            for (a, b) in points.iter().zip(line) {
                assert!(math::hypot(a[0] - b[0], a[1] - b[1]) <= 5.0, "{a:?} {b:?}");
            }
            assert!(points.windows(2).all(|w| w[1][2] <= w[0][2] + 1e-3));
            let numbers =
                |name: &str| spline[name].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect::<Vec<_>>();
            let (width, depth) = (numbers("width"), numbers("depth"));
            assert!(width.windows(2).all(|w| w[1] >= w[0]) && depth.windows(2).all(|w| w[1] >= w[0]));
            let Some(Property::Number(below)) = river.property("width_m") else { panic!() };
            assert!((width[width.len() - 1] - below).abs() < 2e-3 && depth[depth.len() - 1] > 0.0);
        }
    }

    #[test]
    fn roads_are_written_with_their_width_and_csv_has_a_row_a_point() {
        let mut field = valley();
        let properties = vec![("width_m".to_string(), Property::Number(8.0))];
        let geometry = Geometry::Line(vec![[0.0, 100.0, 9.0], [50.0, 100.0, 10.0], [90.0, 140.0, 11.0]]);
        field.features_mut().add(Feature { id: "path 1".into(), kind: FeatureKind::Path, geometry, properties });
        let features = vec![FeatureWord::Paths];
        let csv = splines(&WriteSplines { path: "s.csv".into(), features, ..WriteSplines::default() }, &field);
        let rows: Vec<&str> = csv.lines().collect();
        assert_eq!(rows[0], "spline,kind,id,point,x,y,z,width,depth");
        assert_eq!((rows.len(), rows[2]), (4, "1,path,path 1,2,50,100,10,8,0"));
        let unreal =
            WriteSplines { features: vec![FeatureWord::Paths], preset: PlacePreset::Unreal, ..WriteSplines::default() };
        let json: serde_json::Value = serde_json::from_str(&splines(&unreal, &field)).unwrap();
        // 790 m from the north edge, in cm.
        assert_eq!(json["splines"][0]["points"][0], json!([0.0, 69_000.0, 900.0]));
        assert_eq!((json["unit"].as_str(), json["splines"][0]["width"][0].as_f64()), (Some("cm"), Some(800.0)));
    }

    #[test]
    fn what_is_no_line_is_refused_and_absent_roads_are_told() {
        let of = |word| WriteSplines { features: vec![word], ..WriteSplines::default() };
        assert!(of(FeatureWord::Lakes).validate().unwrap_err().to_string().contains("rivers"));
        assert!(WriteSplines { features: Vec::new(), ..WriteSplines::default() }.validate().is_err());
        let error =
            of(FeatureWord::Paths).export(&Landscape::plain(&valley()), &mut MemoryOutput::default()).unwrap_err();
        assert!(error.hint().is_some_and(|hint| hint.contains("carve_path")), "{error}");
        let flat = HeightField::new(Grid::new(Shape::new(1, 1), [5.0; 2]).unwrap(), vec![1.0]).unwrap();
        assert!(WriteSplines::default().export(&Landscape::plain(&flat), &mut MemoryOutput::default()).is_ok());
    }
}
