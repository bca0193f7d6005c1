//! Fractal mountains by subdivision.

use landform_core::algo::noise::{Midpoint, Subdivision};
use landform_core::grid::{Grid, Shape};
use landform_core::units::Length;
use landform_core::verb::{Context, Params, Source};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GridParams, OnGrid};

/// Fractal ground by random midpoint displacement: a few coarse heights are refined again and again
/// with smaller random offsets.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MidpointDisplacement {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Elevation that is added everywhere.
    pub elevation: Length,
    /// How the lattice is refined.
    pub subdivision: Subdivision,
    /// Coarse heights, row by row from the north-west, all rows of the same length, at least 2 x 2,
    /// spread over the extent. Nodes of the raster lie on the refined lattice where the number of
    /// cells along each side is that of the coarse ones times a power of two. Otherwise they lie
    /// between its nodes.
    pub coarse: Vec<Vec<Length>>,
    /// Whether the coarse heights stay fixed while four_eight smooths the ground between them. With
    /// diamond_square they always stay fixed.
    pub hold: bool,
    /// Standard deviation of the first offsets; each halving of the distance makes it 2^-H times as
    /// large. With 0 only the refinement itself is seen.
    #[schemars(extend("x-min" = 0.0))]
    pub offset: Length,
    /// Hurst exponent: 1 is smooth, 0 is rough.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub hurst: f64,
}

impl Default for MidpointDisplacement {
    fn default() -> Self {
        Self {
            grid: GridParams::default(),
            elevation: Length::of(0.0),
            subdivision: Subdivision::FourEight,
            coarse: vec![vec![Length::of(0.0); 2]; 2],
            hold: false,
            offset: Length::of(400.0),
            hurst: 0.8,
        }
    }
}

impl Params for MidpointDisplacement {
    const NAME: &'static str = "midpoint_displacement";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Fournier, Fussell & Carpenter (1982)",
            title: "Computer rendering of stochastic models, Communications of the ACM 25(6)",
            doi: "10.1145/358523.358553",
        },
        Source {
            authors: "Velho & Zorin (2001)",
            title: "4-8 subdivision, Computer Aided Geometric Design 18(5)",
            doi: "10.1016/S0167-8396(01)00039-5",
        },
    ];

    fn check(&self) -> Result<()> {
        let cols = self.coarse.first().map_or(0, Vec::len);
        if self.coarse.len() < 2 || cols < 2 || self.coarse.iter().any(|r| r.len() != cols) {
            let found = format!(
                "{} rows of {:?} heights",
                self.coarse.len(),
                self.coarse.iter().map(Vec::len).collect::<Vec<_>>()
            );
            return Err(Error::parameter(
                "coarse",
                found,
                "at least two rows of at least two heights, all rows alike in length",
            ));
        }
        Ok(())
    }
}

impl MidpointDisplacement {
    /// Halvings until the lattice has at least as many nodes as the grid along both sides.
    fn levels(&self, shape: Shape) -> Result<u32> {
        let (rows, cols) = (self.coarse.len(), self.coarse[0].len());
        let enough = |level: u32| (rows - 1) << level >= shape.rows - 1 && (cols - 1) << level >= shape.cols - 1;
        let level = (0..28).find(|&l| enough(l)).unwrap_or(28);
        let nodes = (((rows - 1) as u128) << level) * (((cols - 1) as u128) << level);
        if nodes > 64 * shape.len() as u128 + 1024 {
            return Err(Error::parameter(
                "coarse",
                format!("{cols} x {rows} heights for {} x {} nodes", shape.cols, shape.rows),
                "about as many heights along each side as the extent is long",
            ));
        }
        Ok(level)
    }
}

impl OnGrid for MidpointDisplacement {
    fn grid(&self) -> &GridParams {
        &self.grid
    }

    fn elevations(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>> {
        let refinement = Midpoint {
            subdivision: self.subdivision,
            coarse: self.coarse.iter().flatten().map(|h| h.si()).collect(),
            shape: Shape::new(self.coarse.len(), self.coarse[0].len()),
            levels: self.levels(grid.shape)?,
            offset: self.offset.si(),
            hurst: self.hurst,
            hold: self.hold,
        };
        let (fine, z) = (refinement.fine_shape(), refinement.surface(context.seed));
        // The lattice spans the extent; between its nodes lie straight lines.
        let stretch = |n: usize, of: usize| if n > 1 { (of - 1) as f64 / (n - 1) as f64 } else { 0.0 };
        let (down, across) = (stretch(grid.shape.rows, fine.rows), stretch(grid.shape.cols, fine.cols));
        Ok(parallel::map(grid.len(), |i| {
            let cell = grid.shape.cell(i);
            let (r, c) = (cell.row as f64 * down, cell.col as f64 * across);
            let (r0, c0) = ((r as usize).min(fine.rows - 2), (c as usize).min(fine.cols - 2));
            let along = |row: usize| math::lerp(z[fine.index(row, c0)], z[fine.index(row, c0 + 1)], c - c0 as f64);
            self.elevation.si() + math::lerp(along(r0), along(r0 + 1), r - r0 as f64)
        }))
    }

    fn scratch(&self, nodes: u64) -> u64 {
        64 * nodes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::random::Seed;
    use landform_core::terrain::NodeSurface;
    use landform_core::verb::Generator;

    #[test]
    fn coarse_heights_are_where_they_were_put() {
        let h = |v: f64| Length::of(v);
        let params = MidpointDisplacement {
            grid: GridParams::of([160.0; 2], 10.0),
            subdivision: Subdivision::DiamondSquare,
            coarse: vec![vec![h(0.0); 3], vec![h(0.0), h(500.0), h(0.0)], vec![h(7.0); 3]],
            elevation: h(100.0),
            offset: h(0.0),
            ..MidpointDisplacement::default()
        };
        params.check().unwrap();
        let field = params.generate(&Context { seed: Seed(1), ..Context::default() }).unwrap();
        let z = field.elevation();
        assert_eq!((z[8 * 17 + 8], z[0], z[16 * 17 + 16]), (600.0, 100.0, 107.0));
        let ragged = MidpointDisplacement { coarse: vec![vec![h(0.0); 3], vec![h(0.0)]], ..params.clone() };
        assert!(ragged.check().is_err());
        let far = MidpointDisplacement { coarse: vec![vec![h(0.0); 400], vec![h(0.0); 400]], ..params };
        assert!(far.generate(&Context { seed: Seed(1), ..Context::default() }).is_err());
    }
}
