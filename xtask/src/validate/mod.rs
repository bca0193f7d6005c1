//! Convergence studies and statistics, longer than tests may be.

mod card;
mod karst;
mod landslides;

use std::path::Path;
use std::process::Command;

use landform::core::grid::{Edge, Edges, Grid, Shape};
use landform::core::sim::{Simulation, Stop};
use landform::core::terrain::{HeightField, NodeSurface};
use landform::core::units::{Erodibility, KYR, MYR, Rate};
use landform::core::{Result, math};
use landform::process::stream_power::StreamPower;
use landform::process::uplift::Uplift;

const U: f64 = 1e-3;
const K: f64 = 1e-5;

/// Prints the tables, and tries what the tests try a little of at length. With "card" only the
/// card's verdicts are printed, on fakes and on crops of a folder's elevation files.
pub(crate) fn run(args: &[String]) -> bool {
    if args.first().is_some_and(|a| a == "card") {
        let done = card::study(args.get(1).map(Path::new));
        return done.inspect_err(|e| eprintln!("error: {e}")).is_ok();
    }
    let studies: [fn() -> Result<()>; 5] =
        [profile, time_step, karst::networks, landslides::sizes, || card::study(None)];
    match studies.iter().try_for_each(|study| study()) {
        Ok(()) => {
            at_length("LANDFORM_HOSTILE", "2000", &["landform", "--test", "hostile"])
                & at_length("LANDFORM_KILLS", "200", &["landform-cli", "--test", "faults", "killed_at_any_moment"])
        }
        Err(e) => {
            eprintln!("error: {e}");
            false
        }
    }
}

/// Runs a test with a variable that makes it long.
fn at_length(variable: &str, value: &str, test: &[&str]) -> bool {
    println!("{variable}={value}");
    let args = ["test", "--quiet", "--package"];
    Command::new("cargo")
        .args(args)
        .args(test)
        .args(["--", "--nocapture"])
        .env(variable, value)
        .status()
        .is_ok_and(|s| s.success())
}

fn river(cells: usize, cell: f64) -> Result<HeightField> {
    let mut grid = Grid::new(Shape::new(1, cells + 1), [cell, cell])?;
    grid.edges = Edges { west: Edge::Open, ..Edges::all(Edge::Closed) };
    HeightField::new(grid, (0..=cells).map(|i| 0.01 * i as f64).collect())
}

fn evolve(start: HeightField, m: f64, dt: f64, stop: Stop) -> Result<Vec<f64>> {
    let rivers = StreamPower {
        erodibility: Some(Erodibility::of(K).into()),
        area_exponent: m,
        limiting_slope: Some(0.0),
        ..StreamPower::default()
    };
    let mut simulation =
        Simulation::new(start).process(Uplift { rate: Rate::of(1e3 * U).into() })?.process(rivers)?.dt(dt).until(stop);
    simulation.run()?;
    Ok(simulation.terrain().elevation().to_vec())
}

/// SP4 with A = w (L − x): elevation of the head of a single river against theory.
fn profile() -> Result<()> {
    println!("Steady river of 10 km, m = 0.45: error of the head's elevation, halving the cell");
    println!("{:>8} {:>12} {:>8}", "cells", "error", "order");
    let mut last: Option<f64> = None;
    for cells in [50usize, 100, 200, 400, 800] {
        let cell = 10_000.0 / cells as f64;
        let z = evolve(river(cells, cell)?, 0.45, 10.0 * MYR, Stop::steady(1e-12).or_steps(50))?;
        let (length, e) = (10_000.0 + 0.5 * cell, 0.55);
        // The area of a cell is cell², the river's width one cell: compare per unit width.
        let width = math::pow(cell, 0.45);
        let head = U / K / width * (math::pow(length, e) - math::pow(0.5 * cell, e)) / e;
        let error = (z[cells] / head - 1.0).abs();
        let order = last.map_or(f64::NAN, |l: f64| math::log2(l / error));
        println!("{cells:>8} {error:>12.5} {order:>8.2}");
        last = Some(error);
    }
    Ok(())
}

/// SP9: error in time on one river, halving the step, against a run with steps of 1 kyr.
fn time_step() -> Result<()> {
    println!("\nTransient river after 1 Myr: greatest difference to a run with steps of 0.5 kyr, halving the step");
    println!("{:>8} {:>12} {:>8}", "dt kyr", "metres", "order");
    let at = |dt: f64| evolve(river(100, 100.0)?, 0.5, dt * KYR, Stop::time(MYR));
    let fine = at(0.5)?;
    let mut last: Option<f64> = None;
    for dt in [64.0, 32.0, 16.0, 8.0] {
        let error = at(dt)?.iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let order = last.map_or(f64::NAN, |l: f64| math::log2(l / error));
        println!("{dt:>8} {error:>12.4} {order:>8.2}");
        last = Some(error);
    }
    Ok(())
}
