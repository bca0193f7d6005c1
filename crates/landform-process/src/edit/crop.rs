//! A part of the ground.

use landform_core::grid::{Edge, Edges, Grid, Status};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::Length;
use landform_core::verb::{Context, Edit, Estimate, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Keeps a rectangle of the ground and removes the rest. Sides that are cut are open: water leaves
/// over them.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Crop {
    /// West, south, east and north side, in the coordinates of the ground. If not given, all of the
    /// ground is kept.
    pub region: Option<[Length; 4]>,
}

impl Params for Crop {
    const NAME: &'static str = "crop";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        match self.region {
            Some([west, south, east, north]) if !(west.si() < east.si() && south.si() < north.si()) => {
                let value = format!("{west}, {south}, {east}, {north}");
                Err(Error::parameter("region", value, "[west, south, east, north], each pair rising"))
            }
            _ => Ok(()),
        }
    }
}

impl Edit<HeightField> for Crop {
    fn edit(&self, terrain: &mut HeightField, _: &Context) -> Result<()> {
        let Some(region) = self.region else { return Ok(()) };
        let [west, south, east, north] = region.map(Length::si);
        let grid = terrain.grid();
        let Some([first, last]) = grid.nodes_within([[west, south], [east, north]], 0.0) else {
            let [[w, s], [e, n]] = grid.bounds();
            let value = format!("{}, {}, {}, {}", region[0], region[1], region[2], region[3]);
            return Err(Error::parameter(
                "region",
                value,
                &format!("a part of the ground, which lies at {w}, {s}, {e}, {n} m"),
            ));
        };
        let cut = grid.sides_cut(first, last);
        let edges = grid.edges.cut(cut, Edge::Open);
        let mut part = terrain.window(&grid.window(first, last)?)?;
        let chosen = part.chosen_status().map(<[Status]>::to_vec);
        // What is kept is whole from now on.
        part.set_grid(Grid { frame: None, edges, ..part.grid().clone() })?;
        if let Some(mut status) = chosen {
            // Outlets that were chosen stay, and the sides that are cut come to them.
            let (opened, shape) = (Edges::all(Edge::Closed).cut(cut, Edge::Open), part.grid().shape);
            for (i, s) in status.iter_mut().enumerate() {
                if part.elevation()[i].is_nan() {
                    *s = Status::Masked;
                } else if *s == Status::Interior && opened.open_sides_at(shape, i) > 0 {
                    *s = Status::BaseLevel;
                }
            }
            part.set_status(Some(status));
        }
        *terrain = part;
        Ok(())
    }

    fn estimate(&self, before: Estimate) -> Estimate {
        let Some([west, south, east, north]) = self.region.map(|r| r.map(Length::si)) else { return before };
        let share = |from: f64, to: f64, whole: f64| if whole > 0.0 { ((to - from) / whole).min(1.0) } else { 1.0 };
        let (x, y) = (share(west, east, before.extent[0]), share(south, north, before.extent[1]));
        let nodes = (before.nodes as f64 * x * y).ceil() as u64;
        let extent = [before.extent[0] * x, before.extent[1] * y];
        let origin = before.origin.map(|[x, y]| [west.max(x), south.max(y)]);
        Estimate { nodes, bytes: before.nodes * 20 + nodes * 60, extent, origin, ..before }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::Shape;

    fn field() -> HeightField {
        let grid = Grid::new(Shape::new(5, 6), [10.0, 10.0]).unwrap();
        HeightField::new(Grid { edges: Edges::all(Edge::Closed), ..grid }, (0..30).map(f64::from).collect()).unwrap()
    }

    #[test]
    fn a_part_keeps_its_place_and_its_heights() {
        let crop: Crop = serde_json::from_str(r#"{"region":["10 m","10 m","30 m","25 m"]}"#).unwrap();
        let mut part = field();
        crop.edit(&mut part, &Context::default()).unwrap();
        assert_eq!(part.grid().bounds(), [[10.0, 10.0], [30.0, 20.0]]);
        assert_eq!(part.elevation(), [13.0, 14.0, 15.0, 19.0, 20.0, 21.0]);
        assert!(part.grid().frame.is_none() && part.grid().edges == Edges::default() && part.chosen_status().is_none());
        let estimate = crop.estimate(Estimate { nodes: 30, extent: [50.0, 40.0], ..Estimate::default() });
        assert!((4..=8).contains(&estimate.nodes), "{estimate:?}");
    }

    #[test]
    fn outlets_that_were_chosen_stay_and_cut_sides_open() {
        let mut part = field();
        let south = (0..30).map(|i| if i >= 24 { Status::BaseLevel } else { Status::Interior }).collect();
        part.set_status(Some(south));
        let crop: Crop = serde_json::from_str(r#"{"region":["0 m","0 m","30 m","40 m"]}"#).unwrap();
        crop.edit(&mut part, &Context::default()).unwrap();
        let held = |i: usize| part.chosen_status().unwrap()[i] == Status::BaseLevel;
        let found: Vec<usize> = (0..20).filter(|&i| held(i)).collect();
        assert_eq!(found, [3, 7, 11, 15, 16, 17, 18, 19]);
    }

    #[test]
    fn what_is_no_part_is_refused() {
        let read = |text: &str| serde_json::from_str::<Crop>(text).unwrap();
        assert!(read(r#"{"region":["30 m","10 m","10 m","20 m"]}"#).check().is_err());
        let beyond = read(r#"{"region":["300 m","10 m","310 m","20 m"]}"#);
        assert!(beyond.edit(&mut field(), &Context::default()).unwrap_err().to_string().contains("which lies at"));
        let mut same = field();
        Crop::default().edit(&mut same, &Context::default()).unwrap();
        assert!(same == field());
    }
}
