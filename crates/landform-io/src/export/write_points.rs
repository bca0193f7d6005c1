//! Objects that stand on the ground, as a table.
//!
//! # Checked by
//! `tests`: places, directions and scales in each engine's coordinates; files that are read back.

use std::fmt::Write;

use landform_core::feature::{Feature, FeatureKind, Geometry, Property};
use landform_core::terrain::NodeSurface;
use landform_core::verb::{Export, Landscape, Output, Params, Reach, Source, check_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::places::{PlacePreset, rounded};

/// Writes the objects that `scatter` left, one a line: id, kind, place, direction and scale (CSV or
/// JSON), with a card (name.ext.md) that says in which coordinates.
///
/// ```
/// use landform_core::verb::Params;
/// use landform_io::export::WritePoints;
///
/// let trees = WritePoints { path: "trees.csv".into(), ..WritePoints::default() };
/// assert_eq!(trees.outputs(), ["trees.csv", "trees.csv.md"]);
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WritePoints {
    /// Path below the output folder.
    pub path: String,
    /// Kinds of objects, as `scatter` named them. If none are given, all are written.
    pub kinds: Vec<String>,
    /// Coordinates of places and directions.
    pub preset: PlacePreset,
}

impl Default for WritePoints {
    fn default() -> Self {
        Self { path: "points.csv".into(), kinds: Vec::new(), preset: PlacePreset::Landscape }
    }
}

impl Params for WritePoints {
    const NAME: &'static str = "write_points";
    const SOURCES: &'static [Source] = &[];
    const NEEDS: &'static [FeatureKind] = &[FeatureKind::Object];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(0)
    }

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone(), format!("{}.md", self.path)]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["csv", "json"])
    }
}

/// What an object is.
fn kind_of(feature: &Feature) -> &str {
    match feature.property("object") {
        Some(Property::Text(kind)) => kind,
        _ => &feature.id,
    }
}

impl WritePoints {
    /// The features whose objects are written.
    fn chosen<'a, T: NodeSurface>(&self, terrain: &'a T) -> Result<Vec<&'a Feature>> {
        let all = terrain.features().need(FeatureKind::Object, "`write_points`")?;
        if let Some(absent) = self.kinds.iter().find(|kind| !all.iter().any(|f| kind_of(f) == kind.as_str())) {
            let mut there: Vec<&str> = all.iter().map(|f| kind_of(f)).collect();
            there.dedup();
            return Err(Error::parameter("kinds", format!("\"{absent}\""), &format!("one of {}", there.join(", "))));
        }
        let is_chosen = |f: &&Feature| self.kinds.is_empty() || self.kinds.iter().any(|kind| kind == kind_of(f));
        Ok(all.into_iter().filter(is_chosen).collect())
    }

    /// One object a row: number, kind, place, direction, scale.
    fn rows<T: NodeSurface>(&self, terrain: &T, mut visit: impl FnMut(usize, &str, [f64; 3], f64, f64)) -> Result<()> {
        let mut id = 0;
        for feature in self.chosen(terrain)? {
            let points: &[[f64; 3]] = match &feature.geometry {
                Geometry::Points(points) => points,
                Geometry::Point(point) => std::slice::from_ref(point),
                _ => &[],
            };
            let (yaw, scale) = (feature.numbers("yaw_deg"), feature.numbers("scale"));
            let of =
                |values: Option<&[f64]>, k: usize, usual: f64| values.and_then(|v| v.get(k)).copied().unwrap_or(usual);
            for (k, &point) in points.iter().enumerate() {
                id += 1;
                let place = self.preset.place(terrain.bounds(), point).map(|v| rounded(v, 3));
                let yaw = rounded(self.preset.yaw(of(yaw, k, 0.0)), 2);
                visit(id, kind_of(feature), place, yaw, rounded(of(scale, k, 1.0), 3));
            }
        }
        Ok(())
    }
}

impl<T: NodeSurface> Export<T> for WritePoints {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let (mut text, mut count) = (String::new(), 0);
        if self.path.to_lowercase().ends_with(".csv") {
            text += "id,kind,x,y,z,yaw_deg,scale\n";
            self.rows(landscape.terrain, |id, kind, [x, y, z], yaw, scale| {
                count = id;
                writeln!(text, "{id},{kind},{x},{y},{z},{yaw},{scale}").ok();
            })?;
        } else {
            let title = serde_json::to_string(landscape.title).map_err(|e| Error::format("JSON", e))?;
            write!(text, "{{\"name\":{title},\"unit\":\"{}\",\"points\":[", self.preset.unit()).ok();
            self.rows(landscape.terrain, |id, kind, [x, y, z], yaw, scale| {
                count = id;
                let comma = if id > 1 { "," } else { "" };
                write!(
                    text,
                    "{comma}\n{{\"id\":{id},\"kind\":\"{kind}\",\"x\":{x},\"y\":{y},\"z\":{z},\"yaw_deg\":{yaw},\"scale\":{scale}}}"
                )
                .ok();
            })?;
            text += "\n]}\n";
        }
        let card = format!(
            "# {count} objects of {}\n\n`{}`, seed {}, written by landform {}.\n\nColumns: id from 1; kind; x, y, z: {}. \
             yaw_deg is the direction in degrees, scale a factor on the object's own size.\n",
            landscape.title,
            self.path,
            landscape.seed,
            env!("CARGO_PKG_VERSION"),
            self.preset.meaning(),
        );
        out.put(&self.path, text.as_bytes())?;
        out.put(&format!("{}.md", self.path), card.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::HeightField;
    use landform_core::verb::MemoryOutput;

    use super::*;

    /// A map from (1000, 2000) to (1100, 2060) with two trees and a rock.
    fn field() -> HeightField {
        let mut grid = Grid::new(Shape::new(7, 11), [10.0; 2]).unwrap();
        grid.origin = [1000.0, 2060.0];
        let mut field = HeightField::new(grid, vec![5.0; 77]).unwrap();
        for (kind, points, yaw) in [
            ("tree", vec![[1010.0, 2020.0, 5.0], [1090.0, 2050.5, 6.25]], vec![90.0, 0.0]),
            ("rock", vec![[1000.0, 2000.0, 5.0]], vec![45.0]),
        ] {
            let scale = vec![1.5; yaw.len()];
            let properties = [
                ("object", Property::Text(kind.into())),
                ("yaw_deg", Property::Numbers(yaw)),
                ("scale", Property::Numbers(scale)),
            ];
            let properties = properties.map(|(name, p)| (name.to_string(), p)).to_vec();
            let geometry = Geometry::Points(points);
            field.features_mut().add(Feature { id: kind.into(), kind: FeatureKind::Object, geometry, properties });
        }
        field
    }

    fn text(params: &WritePoints) -> String {
        let mut out = MemoryOutput::default();
        params.validate().unwrap();
        params.export(&Landscape::plain(&field()), &mut out).unwrap();
        assert_eq!(out.0.len(), 2);
        String::from_utf8(out.0[&params.path].clone()).unwrap()
    }

    #[test]
    fn places_and_directions_are_those_of_the_engine() {
        for (preset, tree, yaw) in [
            (PlacePreset::Landscape, [1010.0, 2020.0, 5.0], 90.0),
            (PlacePreset::Unreal, [1000.0, 4000.0, 500.0], 270.0),
            (PlacePreset::Unity, [10.0, 5.0, 20.0], 270.0),
            (PlacePreset::Godot, [10.0, 5.0, 40.0], 90.0),
        ] {
            let csv = text(&WritePoints { preset, ..WritePoints::default() });
            let [x, y, z] = tree;
            assert_eq!(csv.lines().nth(1), Some(format!("1,tree,{x},{y},{z},{yaw},1.5").as_str()), "{preset:?}");
            assert_eq!((csv.lines().next(), csv.lines().count()), (Some("id,kind,x,y,z,yaw_deg,scale"), 4));
        }
    }

    #[test]
    fn json_is_read_back_and_kinds_are_chosen() {
        let json = text(&WritePoints { path: "p.json".into(), kinds: vec!["rock".into()], ..WritePoints::default() });
        let value: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(value["points"].as_array().unwrap().len(), 1);
        assert_eq!(
            (value["points"][0]["kind"].as_str(), value["points"][0]["y"].as_f64()),
            (Some("rock"), Some(2000.0))
        );
        let absent = WritePoints { kinds: vec!["cow".into()], ..WritePoints::default() };
        let error = absent.export(&Landscape::plain(&field()), &mut MemoryOutput::default()).unwrap_err().to_string();
        assert!(error.contains("tree, rock"), "{error}");
        let bare = HeightField::new(Grid::new(Shape::new(2, 2), [1.0; 2]).unwrap(), vec![0.0; 4]).unwrap();
        assert!(WritePoints::default().export(&Landscape::plain(&bare), &mut MemoryOutput::default()).is_err());
        assert!(WritePoints { path: "p.txt".into(), ..WritePoints::default() }.validate().is_err());
    }
}
