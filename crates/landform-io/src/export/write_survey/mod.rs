//! A network of passages as a cave survey.

mod survex;
mod therion;

use std::fmt::Write;

use landform_core::Result;
use landform_core::feature::{Conduit, ConduitNetwork, FeatureKind, Features, Geometry, Passage};
use landform_core::terrain::{HeightField, Mesh, NodeSurface, VoxelGrid};
use landform_core::verb::{Export, Landscape, Output, Params, Source, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Writes conduits as a cave survey: stations, the legs between them, entrances, and the distances
/// from each station to the walls. The extension sets the format: svx (Survex), th (Therion).
///
/// ```
/// use landform_core::verb::Params;
/// use landform_io::export::WriteSurvey;
///
/// assert!(WriteSurvey::default().check().is_ok());
/// assert!(WriteSurvey { path: "cave.doc".into() }.check().is_err());
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteSurvey {
    /// Path below the output folder.
    pub path: String,
}

impl Default for WriteSurvey {
    fn default() -> Self {
        Self { path: "survey.svx".into() }
    }
}

impl Params for WriteSurvey {
    const NAME: &'static str = "write_survey";
    const NEEDS: &'static [FeatureKind] = &[FeatureKind::Conduit];
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(0)
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["svx", "th"])
    }
}

impl Export<HeightField> for WriteSurvey {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        let terrain = landscape.terrain;
        self.write(landscape.title, terrain.features(), terrain.epsg(), out)
    }
}

impl Export<Mesh> for WriteSurvey {
    fn export(&self, landscape: &Landscape<'_, Mesh>, out: &mut dyn Output) -> Result<()> {
        let terrain = landscape.terrain;
        self.write(landscape.title, terrain.features(), terrain.epsg(), out)
    }
}

impl Export<VoxelGrid> for WriteSurvey {
    fn export(&self, landscape: &Landscape<'_, VoxelGrid>, out: &mut dyn Output) -> Result<()> {
        let terrain = landscape.terrain;
        self.write(landscape.title, terrain.features(), terrain.plan().georeference.epsg, out)
    }
}

impl WriteSurvey {
    fn write(&self, title: &str, features: &Features, epsg: Option<u16>, out: &mut dyn Output) -> Result<()> {
        features.need(FeatureKind::Conduit, &format!("`{}`", Self::NAME))?;
        let survey = Survey::of(title, features, epsg);
        let is_therion = self.path.to_lowercase().ends_with(".th");
        let text = if is_therion { therion::text(&survey) } else { survex::text(&survey) };
        out.put(&self.path, text.as_bytes())
    }
}

/// Words in which formats differ.
struct Words {
    /// Before a command, and before a row of numbers.
    command: &'static str,
    row: &'static str,
    /// What the distances to the walls are called.
    walls: &'static str,
    /// An entrance: a station (from 1), and what it is.
    entrance: fn(u32, &str) -> String,
}

/// A survey as both formats tell it. Stations are numbered from 1 and lie on whole millimetres, so
/// that legs add up.
struct Survey<'a> {
    title: &'a str,
    epsg: Option<u16>,
    /// Places of stations, mm.
    stations: Vec<[i64; 3]>,
    legs: Vec<[u32; 2]>,
    /// A station of each part that hangs together.
    fixed: Vec<u32>,
    /// Stations at the surface, and what they are.
    entrances: Vec<(u32, &'static str)>,
    /// Stations along each passage with the distances to the walls.
    passages: Vec<Vec<(u32, Passage)>>,
}

impl<'a> Survey<'a> {
    fn of(title: &'a str, features: &Features, epsg: Option<u16>) -> Self {
        let network = ConduitNetwork::of(features);
        let legs = network.edges();
        let along = |c: &Conduit| c.nodes.iter().copied().zip(c.passages.iter().copied()).collect::<Vec<_>>();
        Self {
            title,
            epsg,
            fixed: (0..).zip(network.parts()).filter(|(node, part)| node == part).map(|pair| pair.0).collect(),
            entrances: entrances(&network, features),
            passages: network.conduits.iter().map(along).collect(),
            stations: network.nodes.iter().map(|place| place.map(|v| (v * 1000.0).round() as i64)).collect(),
            legs,
        }
    }

    /// The title without what would end it.
    fn plain_title(&self) -> String {
        self.title.replace(['"', '\n', '\r'], " ")
    }

    /// Fixed stations, entrances, legs and walls, a line each, in the words of a format.
    fn centreline(&self, words: &Words) -> String {
        let Words { command, row, walls: dimensions, entrance } = words;
        let mut text = String::new();
        // Writing to a string does not fail.
        let mut line = |start: &str, rest: &str| {
            let _ = writeln!(text, "{start}{rest}");
        };
        for &station in &self.fixed {
            line(command, &format!("fix {} {}", station + 1, self.place(station).join(" ")));
        }
        for (station, kind) in &self.entrances {
            line(command, &entrance(station + 1, kind));
        }
        line(command, "data cartesian from to easting northing altitude");
        for &leg in &self.legs {
            line(row, &format!("{} {} {}", leg[0] + 1, leg[1] + 1, self.leg(leg).join(" ")));
        }
        for passage in &self.passages {
            line(command, &format!("data {dimensions} station left right up down"));
            passage.iter().for_each(|(station, p)| line(row, &format!("{} {}", station + 1, walls(*p))));
        }
        text
    }

    fn place(&self, station: u32) -> [String; 3] {
        self.stations[station as usize].map(metres)
    }

    /// From a station to another.
    fn leg(&self, [from, to]: [u32; 2]) -> [String; 3] {
        let [a, b] = [from, to].map(|s| self.stations[s as usize]);
        [0, 1, 2].map(|k| metres(b[k] - a[k]))
    }
}

/// Millimetres as metres.
fn metres(mm: i64) -> String {
    let sign = if mm < 0 { "-" } else { "" };
    format!("{sign}{}.{:03}", mm.abs() / 1000, mm.abs() % 1000)
}

/// Distances to the walls in the order left, right, up, down.
fn walls(passage: Passage) -> String {
    let of = |v: f64| format!("{v:.2}");
    [passage.left, passage.right, passage.up, passage.down].map(of).join(" ")
}

/// Stations at places where water or people enter or leave.
fn entrances(network: &ConduitNetwork, features: &Features) -> Vec<(u32, &'static str)> {
    let kinds = [FeatureKind::Sinkhole, FeatureKind::Spring, FeatureKind::Entrance];
    let points = features.iter().filter(|f| kinds.contains(&f.kind)).filter_map(|f| match f.geometry {
        Geometry::Point(place) => Some((place, f.kind.word())),
        _ => None,
    });
    let station = |place: [f64; 3]| network.nodes.iter().position(|n| *n == place);
    let mut found: Vec<_> = points.filter_map(|(place, word)| Some((station(place)? as u32, word))).collect();
    found.sort_by_key(|entrance| entrance.0);
    found.dedup_by_key(|entrance| entrance.0);
    found
}

#[cfg(test)]
mod tests {
    use landform_core::feature::Feature;
    use landform_core::grid::{Grid, Shape};
    use landform_core::verb::MemoryOutput;

    use super::*;

    /// A fork from a sinkhole and a piece apart, 20 m under the ground.
    fn ground() -> HeightField {
        let mut ground = HeightField::new(Grid::new(Shape::new(3, 3), [50.0; 2]).unwrap(), vec![60.0; 9]).unwrap();
        let nodes =
            vec![[0.0, 0.0, 60.0], [10.25, -3.5, 48.0], [20.0, 9.0, 41.5], [30.0, 0.0, 44.0], [70.0, 70.0, 30.0]];
        let nodes: Vec<_> = nodes.into_iter().chain([[80.0, 70.0, 30.0]]).collect();
        let network = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3], [4, 5]], |n| Passage {
            left: f64::from(n),
            ..Passage::round(1.5)
        });
        let sink = Feature {
            id: "1".into(),
            kind: FeatureKind::Sinkhole,
            geometry: Geometry::Point([0.0, 0.0, 60.0]),
            properties: Vec::new(),
        };
        *ground.features_mut() = network.features().into_iter().chain([sink]).collect();
        ground
    }

    fn written(path: &str) -> String {
        let (ground, mut out) = (ground(), MemoryOutput::default());
        WriteSurvey { path: path.into() }.export(&Landscape::plain(&ground), &mut out).unwrap();
        String::from_utf8(out.0[path].clone()).unwrap()
    }

    #[test]
    fn a_survex_file_holds_stations_legs_walls_and_entrances() {
        let text = written("a.svx");
        for line in [
            "*fix 1 0.000 0.000 60.000",
            "*fix 5 70.000 70.000 30.000",
            "*entrance 1 ; sinkhole",
            "*data cartesian from to easting northing altitude",
            "1 2 10.250 -3.500 -12.000",
            "2 4 19.750 3.500 -4.000",
            "*data passage station left right up down",
            "2 1.00 1.50 1.50 1.50",
        ] {
            assert!(text.lines().any(|l| l == line), "{line} is not in\n{text}");
        }
        assert_eq!(text.lines().filter(|l| l.starts_with("*data passage")).count(), 4);
    }

    #[test]
    fn a_therion_file_holds_the_same() {
        let text = written("a.th");
        for line in ["    fix 5 70.000 70.000 30.000", "    1 2 10.250 -3.500 -12.000", "  endcentreline", "endsurvey"]
        {
            assert!(text.lines().any(|l| l == line), "{line} is not in\n{text}");
        }
    }

    #[test]
    fn ground_without_conduits_and_other_endings_are_refused() {
        let plain = HeightField::new(Grid::new(Shape::new(2, 2), [1.0; 2]).unwrap(), vec![0.0; 4]).unwrap();
        let error = WriteSurvey::default().export(&Landscape::plain(&plain), &mut MemoryOutput::default()).unwrap_err();
        assert!(error.to_string().contains("no conduits") && error.hint().is_some(), "{error}");
        assert!(WriteSurvey { path: "a.txt".into() }.check().is_err());
    }
}
