//! Rivers as a table: their long profiles, χ and steepness.

use std::fmt::Write;

use landform_core::analysis::{Drainage, ProfileSearch, carved, channel_area, river_profiles};
use landform_core::terrain::NodeSurface;
use landform_core::units::{Area, Length};
use landform_core::verb::{Export, Landscape, Output, Params, Source, check_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Writes long profiles of rivers as a table (CSV), a node a row, each river from its mouth up:
/// river, the river it joins, order, place, elevation, elevation with depressions cut through,
/// drainage area, distance along the flow, chi and steepness k_sn.
///
/// ```
/// use landform_core::verb::Params;
/// use landform_io::export::WriteProfiles;
///
/// assert_eq!(WriteProfiles::default().outputs(), ["profiles.csv"]);
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteProfiles {
    /// Path below the output folder.
    pub path: String,
    /// Least drainage area of a channel. If not given, it is 1 km2, or less on small ground.
    #[schemars(extend("x-above" = 0.0))]
    pub least_area: Option<Area>,
    /// Concavity theta, by which chi weighs area and k_sn counts: its unit is m^(2 theta).
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub concavity: f64,
    /// Reference area A0 of chi: chi is the integral of (A0/A)^theta along the flow, in metres.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1e18))]
    pub reference_area: Area,
    /// Length of river, half up and half down, over which k_sn is fitted. If not given, it is 500
    /// m, or ten cells where that is more.
    #[schemars(extend("x-above" = 0.0))]
    pub window: Option<Length>,
    /// The greatest rivers only, this many. If not given, all.
    #[schemars(extend("x-min" = 1))]
    pub rivers: Option<usize>,
}

impl Default for WriteProfiles {
    fn default() -> Self {
        Self {
            path: "profiles.csv".into(),
            least_area: None,
            concavity: 0.45,
            reference_area: Area::of(1e6),
            window: None,
            rivers: None,
        }
    }
}

impl Params for WriteProfiles {
    const NAME: &'static str = "write_profiles";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Perron & Royden (2013)",
        title: "An integral approach to bedrock river profile analysis, Earth Surface Processes and Landforms 38",
        doi: "10.1002/esp.3302",
    }];

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["csv"])?;
        if !self.concavity.is_finite() {
            return Err(Error::parameter("concavity", self.concavity, "a finite number, such as 0.45"));
        }
        Ok(())
    }
}

/// The head of the table.
const HEAD: &str = "river,into,order,x_m,y_m,elevation_m,carved_m,drainage_area_m2,distance_m,chi_m,ksn\n";

impl<T: NodeSurface> Export<T> for WriteProfiles {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let terrain = landscape.terrain;
        let z = terrain.elevation();
        let drainage = Drainage::with_open_holes(terrain);
        let carved = carved(&drainage, z);
        let greatest = drainage.area.iter().copied().fold(0.0, f64::max);
        let node = drainage.area.iter().copied().filter(|a| *a > 0.0).fold(f64::INFINITY, f64::min);
        let least_area = self.least_area.map_or_else(|| channel_area(greatest, node), Area::si);
        let window = self.window.map_or_else(|| 500.0_f64.max(10.0 * node.sqrt()), Length::si);
        let (concavity, reference_area) = (self.concavity, self.reference_area.si());
        let search = ProfileSearch { least_area, concavity, reference_area, window };
        let rivers = river_profiles(&drainage, &carved, &search);
        if rivers.is_empty() {
            let expected = format!("less than {greatest:.0} m2, the greatest drainage area");
            return Err(Error::parameter("least_area", format!("{least_area:.0} m2"), &expected));
        }
        let mut text = String::from(HEAD);
        for river in rivers.iter().take(self.rivers.unwrap_or(usize::MAX)) {
            let into = river.into.map_or_else(String::new, |into| into.to_string());
            for n in &river.nodes {
                let i = n.node as usize;
                let [x, y] = terrain.position(i);
                let steepness = if n.steepness.is_nan() { String::new() } else { n.steepness.to_string() };
                writeln!(
                    text,
                    "{},{into},{},{x},{y},{},{},{},{},{},{steepness}",
                    river.river, n.order, z[i], carved[i], drainage.area[i], n.distance, n.chi
                )
                .ok();
            }
        }
        out.put(&self.path, text.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Edge, Edges, Grid, Shape};
    use landform_core::terrain::HeightField;
    use landform_core::verb::MemoryOutput;

    use super::*;

    #[test]
    fn a_table_holds_what_its_head_says() {
        let mut grid = Grid::new(Shape::new(40, 30), [50.0, 50.0]).unwrap();
        grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
        let valley = |i: usize| (40 - i / 30) as f64 + ((i % 30) as f64 - 12.0).abs();
        let field = HeightField::new(grid.clone(), (0..1200).map(valley).collect()).unwrap();
        let table = |stage: &WriteProfiles| {
            stage.validate().unwrap();
            let mut out = MemoryOutput::default();
            stage.export(&Landscape::plain(&field), &mut out).map(|()| out.0["profiles.csv"].clone())
        };
        let text = String::from_utf8(table(&WriteProfiles::default()).unwrap()).unwrap();
        let mut lines = text.lines();
        let columns = lines.next().unwrap().split(',').count();
        let rows: Vec<Vec<&str>> = lines.map(|l| l.split(',').collect()).collect();
        assert!(rows.iter().all(|row| row.len() == columns));
        // The first row is the mouth of the greatest river: all the land drains through it.
        let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
        assert_eq!((rows[0][0], rows[0][1]), ("1", ""));
        assert!((number(0, 3) - grid.x(12)).abs() < 1e-9 && (number(0, 4) - grid.y(39)).abs() < 1e-9);
        assert_eq!((number(0, 8), number(0, 9)), (0.0, 0.0));
        assert!((number(1, 8) - 50.0).abs() < 1e-9);
        let few = WriteProfiles { rivers: Some(1), ..WriteProfiles::default() };
        let few = String::from_utf8(table(&few).unwrap()).unwrap();
        assert!(few.lines().skip(1).all(|l| l.starts_with("1,")) && text.starts_with(&few));
        let none = WriteProfiles { least_area: Some(Area::of(1e12)), ..WriteProfiles::default() };
        assert_eq!(table(&none).unwrap_err().parameter_name(), Some("least_area"));
        for concavity in [-0.1, 2.1, f64::NAN] {
            assert!(WriteProfiles { concavity, ..WriteProfiles::default() }.validate().is_err());
        }
    }
}
