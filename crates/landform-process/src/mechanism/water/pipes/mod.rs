//! Water in time steps: columns joined by pipes.
//!
//! # Model
//! Between neighbours runs a pipe as wide as a cell and as high as the water stands over the higher
//! of their beds. Water in it is accelerated by the difference of levels and slowed by friction and
//! by the momentum that it carries along. No column loses more than it has.
//!
//! # Method
//! Explicit: fluxes on faces, then the part of them that the columns can give, then columns. The
//! step is at most 0.4 of the time that a wave needs across a cell. Friction is implicit, by the
//! whole speed, so that steady flow runs down the fall line at Manning's speed. Strips of
//! rows run in parallel, and in a strip one row after another with a window of its neighbours, so
//! that fields are read and written once a step; rows at the sides of strips are computed twice in
//! the same way, so the water that leaves one column enters the next.
//!
//! # Sources
//! O'Brien & Hodgins (1995) and Mei, Decaudin & Hu (2007) for pipes with scaled outflow (listing
//! 4.3 of Pytel 2015); Bates, Horritt & Fewtrell (2010) for the height of the pipe and implicit
//! friction; Stelling & Duinmeijer (2003) for the momentum that the flow carries between columns,
//! without which a dam break runs at a fourth of its speed.

mod face;
mod strip;

use landform_core::grid::RasterDomain;
use landform_core::parallel;
use serde::{Deserialize, Serialize};

use self::face::Kind;
use self::strip::{After, Before};
use super::{Ledger, Supply};

const GRAVITY: f64 = 9.81;
/// Part of the time that a wave needs across a cell.
const COURANT: f64 = 0.4;
/// Water thinner than this does not run, m.
const THIN: f64 = 1e-6;
/// Fewest rows of a strip.
const STRIP: usize = 16;

/// Water in pipes between the nodes of a raster; nothing crosses its sides but where they are base
/// level.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Pipes {
    /// Speed in the pipes to the east and to the south of every node, m/s.
    east: Vec<f64>,
    south: Vec<f64>,
    /// The greatest of them.
    fastest: f64,
    /// Manning's roughness, s/m^(1/3).
    roughness: f64,
    spacing: [f64; 2],
    #[serde(skip)]
    scratch: Scratch,
}

#[derive(Clone, Debug, Default)]
struct Scratch {
    /// Speeds and water after the step.
    east: Vec<f64>,
    south: Vec<f64>,
    water: Vec<f64>,
    /// Volume that has crossed to the east and to the south since the sums were begun, m³, and the
    /// time, s.
    crossed_east: Vec<f64>,
    crossed_south: Vec<f64>,
    time: f64,
    /// A row of zeros.
    nothing: Vec<f64>,
}

impl Pipes {
    /// Still water over cells of `spacing` metres, with Manning's roughness in s/m^(1/3).
    pub fn new(nodes: usize, spacing: [f64; 2], roughness: f64) -> Self {
        let still = vec![0.0; nodes];
        Self { east: still.clone(), south: still, fastest: 0.0, roughness, spacing, scratch: Scratch::default() }
    }

    /// Longest stable step, s: dt <= 0.4 dx / (|u| + sqrt(g w)).
    pub fn max_step(&self, water: &[f64]) -> f64 {
        let deepest = parallel::max(water.len(), |i| water[i]).max(THIN);
        COURANT * self.spacing[0].min(self.spacing[1]) / (self.fastest + (GRAVITY * deepest).sqrt())
    }

    /// Begins to sum what crosses.
    pub fn begin_sums(&mut self) {
        for sums in [&mut self.scratch.crossed_east, &mut self.scratch.crossed_south] {
            sums.clear();
            sums.resize(self.east.len(), 0.0);
        }
        self.scratch.time = 0.0;
    }

    /// Mean net discharge through each node since sums were begun, m³/s: water that sloshes to and
    /// fro does not count.
    pub fn net_discharge(&self, domain: &RasterDomain) -> Vec<f64> {
        let cols = domain.shape().cols;
        let Scratch { crossed_east, crossed_south, time, .. } = &self.scratch;
        // Along an axis: the flow through the node; where water enters from both sides, or leaves
        // to both, the difference.
        let through = |a: f64, b: f64| if a * b >= 0.0 { a.abs().max(b.abs()) } else { 0.5 * (a + b).abs() };
        parallel::map(crossed_east.len(), |i| {
            let west = if i % cols > 0 { crossed_east[i - 1] } else { 0.0 };
            let north = if i >= cols { crossed_south[i - cols] } else { 0.0 };
            (through(west, crossed_east[i]) + through(north, crossed_south[i])) / time
        })
    }

    /// Volume that flowed from a node to its neighbours in the east, south, west and north since
    /// sums were begun, m³; negative where it flowed to the node.
    pub fn volume_out(&self, domain: &RasterDomain, node: usize) -> impl Iterator<Item = (usize, f64)> {
        let (Scratch { crossed_east: east, crossed_south: south, .. }, shape) = (&self.scratch, domain.shape());
        let (row, col) = (node / shape.cols, node % shape.cols);
        let to_east = (col + 1 < shape.cols).then(|| (node + 1, east[node]));
        let to_south = (row + 1 < shape.rows).then(|| (node + shape.cols, south[node]));
        let to_west = (col > 0).then(|| (node - 1, -east[node - 1]));
        let to_north = (row > 0).then(|| (node - shape.cols, -south[node - shape.cols]));
        [to_east, to_south, to_west, to_north].into_iter().flatten()
    }

    /// One step of `dt` seconds. The supply is the water that enters and leaves in a second; `ends`
    /// are the nodes where water leaves.
    pub fn step(
        &mut self,
        domain: &RasterDomain,
        ground: &[f64],
        (supply, ends): (&Supply, &[u32]),
        dt: f64,
        water: &mut Vec<f64>,
    ) -> Ledger {
        let mut ledger = Ledger { entered: supply.total * dt, ..Ledger::default() };
        let dries = supply.evaporation * dt;
        if dries > 0.0 {
            ledger.evaporated = parallel::sum(water.len(), |i| (water[i] + supply.depth[i] * dt).min(dries));
        }
        self.flow(domain, ground, (supply, dries), dt, water);
        for &end in ends {
            ledger.left += std::mem::take(&mut water[end as usize]);
        }
        ledger
    }

    fn flow(
        &mut self,
        domain: &RasterDomain,
        ground: &[f64],
        (supply, dries): (&Supply, f64),
        dt: f64,
        water: &mut Vec<f64>,
    ) {
        let shape = domain.shape();
        let [dx, dy] = self.spacing;
        let scratch = &mut self.scratch;
        scratch.prepare(water.len(), shape.cols);
        let before = Before {
            rows: shape.rows,
            cols: shape.cols,
            ground,
            water,
            supply: supply.depth,
            dries,
            dt,
            area: dx * dy,
            east: &self.east,
            south: &self.south,
            eastward: Kind::new(dx, dy, dt, self.roughness),
            southward: Kind::new(dy, dx, dt, self.roughness),
            nothing: &scratch.nothing,
        };
        let written = [
            &mut scratch.east[..],
            &mut scratch.south[..],
            &mut scratch.water[..],
            &mut scratch.crossed_east[..],
            &mut scratch.crossed_south[..],
        ];
        // The division of rows among threads does not change the result.
        let strip = shape.rows.div_ceil(2 * parallel::threads()).max(STRIP);
        let speeds = parallel::map_pieces_mut(written, strip * shape.cols, |first, rows| {
            let [east, south, water, crossed_east, crossed_south] = rows;
            let mut after = After { east, south, water, crossed_east, crossed_south };
            strip::step(&before, first / shape.cols, &mut after)
        });
        self.fastest = speeds.into_iter().fold(0.0, f64::max);
        scratch.time += dt;
        std::mem::swap(&mut scratch.east, &mut self.east);
        std::mem::swap(&mut scratch.south, &mut self.south);
        std::mem::swap(&mut scratch.water, water);
    }
}

impl Scratch {
    fn prepare(&mut self, nodes: usize, cols: usize) {
        let Self { east, south, water, crossed_east, crossed_south, nothing, .. } = self;
        for field in [east, south, water, crossed_east, crossed_south] {
            field.resize(nodes, 0.0);
        }
        nothing.resize(cols, 0.0);
    }
}
