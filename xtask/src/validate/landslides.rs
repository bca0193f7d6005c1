//! Sizes of landslides on a steady range.

use landform::core::grid::{Grid, Shape};
use landform::core::random::Seed;
use landform::core::sim::Model;
use landform::core::terrain::{HeightField, NodeSurface, Rasterize};
use landform::core::units::{Angle, Erodibility, KYR, Rate};
use landform::core::{Result, math, parallel};
use landform::process::hillslope::Landslides;
use landform::process::stream_power::StreamPower;
use landform::process::uplift::Uplift;

/// Prints the exponent of the density of slides' areas, which nature has at 2.1 to 2.7 (Hovius et
/// al. 1997; Malamud et al. 2004), for rocks of different strength and cells of different size.
pub(super) fn sizes() -> Result<()> {
    println!("\nAreas of landslides on a steady range, density ~ area^-exponent above x_min (Clauset et al. 2009)");
    println!(
        "{:>6} {:>6} {:>9} {:>7} {:>8} {:>8} {:>8} {:>6} {:>8}",
        "cell m", "C kPa", "angle deg", "slides", "exponent", "x_min m2", "in tail", "KS", "largest"
    );
    for (cell, cohesion, friction) in
        [(10.0, 1e4, 25.0), (20.0, 1e4, 25.0), (10.0, 4e4, 25.0), (10.0, 1e4, 20.0), (10.0, 1e4, 33.0)]
    {
        let areas = areas(256, cell, cohesion, friction)?;
        let tail = Tail::of(&areas, cell * cell);
        let largest = areas.iter().copied().fold(0.0, f64::max);
        println!(
            "{cell:>6} {:>6} {friction:>9} {:>7} {:>8.2} {:>8} {:>8} {:>6.3} {largest:>8}",
            cohesion / 1e3,
            areas.len(),
            tail.exponent,
            tail.least,
            tail.count,
            tail.distance,
        );
    }
    Ok(())
}

/// Areas of all slides of 150 steps on a range that was steady before.
fn areas(nodes: usize, cell: f64, cohesion: f64, friction: f64) -> Result<Vec<f64>> {
    let grid = Grid::new(Shape::new(nodes, nodes), [cell; 2])?;
    let rough = parallel::map(grid.len(), |i| Seed(5).uniform(i as u64));
    let start = HeightField::new(grid, rough)?;
    let start = start.jittered(Seed(5)).unwrap_or(start);
    let rivers = StreamPower {
        erodibility: Some(Erodibility::of(2e-5).into()),
        limiting_slope: Some(0.0),
        ..StreamPower::default()
    };
    let slides = Landslides { cohesion, friction_angle: Some(Angle::of(friction).into()), ..Landslides::default() };
    let mut model = Model::new(start).dt(KYR).seed(Seed(5));
    model.add(Uplift { rate: Rate::of(2.0).into() })?;
    model.add(rivers)?;
    model.add(slides)?;
    model.advance_steps(300)?;
    let mut all = Vec::new();
    for _ in 0..150 {
        model.advance_steps(1)?;
        model.finish()?;
        all.extend(in_step(&model.terrain().real("landslide_area", "validate")?, cell * cell));
    }
    Ok(all)
}

/// Areas of the slides of a step: every slide's nodes hold its area.
fn in_step(field: &[f64], cell: f64) -> Vec<f64> {
    let mut held: Vec<f64> = field.iter().copied().filter(|a| *a > 0.0).collect();
    held.sort_by(f64::total_cmp);
    let runs = held.chunk_by(|a, b| a == b);
    runs.flat_map(|run| vec![run[0]; (run.len() as f64 * cell / run[0]).round().max(1.0) as usize]).collect()
}

/// A power law that values follow above the least of them.
struct Tail {
    exponent: f64,
    least: f64,
    count: usize,
    /// Kolmogorov's distance.
    distance: f64,
}

impl Tail {
    /// The least value is that which makes the distance least; values are multiples of `unit`.
    fn of(values: &[f64], unit: f64) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let mut best = Self { exponent: f64::NAN, least: f64::NAN, count: 0, distance: f64::INFINITY };
        let mut first = 0;
        // Fewer than a hundred say little.
        while first + 100 < sorted.len() {
            let tail = &sorted[first..];
            // Half a unit less, since values are whole.
            let least = tail[0] - 0.5 * unit;
            let sum: f64 = tail.iter().map(|x| math::log(x / least)).sum();
            let exponent = 1.0 + tail.len() as f64 / sum;
            let n = tail.len() as f64;
            let far = |k: usize| {
                let share = 1.0 - math::pow((tail[k] + 0.5 * unit) / least, 1.0 - exponent);
                let upto = tail.partition_point(|x| *x <= tail[k]) as f64 / n;
                (share - upto).abs()
            };
            let distance = (0..tail.len()).step_by(1 + tail.len() / 2000).map(far).fold(0.0, f64::max);
            if distance < best.distance {
                best = Self { exponent, least: tail[0], count: tail.len(), distance };
            }
            first += tail.partition_point(|x| *x <= tail[0]);
        }
        best
    }
}
