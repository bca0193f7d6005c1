//! The peers' tasks, one line of JSON each, so that both run in turns:
//! `cargo run --release -p xtask -- peers TASK`.
//!
//! Tasks: A = depressions, D8 and drainage area of an elevation file; B = stream power on an n × n
//! raster; C = stream power on a mesh of n nodes; mesh = Delaunay and areas of n sites; steady = C
//! to a steady state (1e-15), from coarse to fine.

use std::path::PathBuf;
use std::time::Instant;

use landform::core::algo::flow::{Flow, node_areas};
use landform::core::algo::sampling::{poisson_disk, spacing_for_count};
use landform::core::grid::{Domain, Edges, Grid, Shape, Status};
use landform::core::parallel::with_threads;
use landform::core::random::Seed;
use landform::core::sim::{Every, Simulation, Stop};
use landform::core::terrain::{HeightField, Layer, Mesh, NodeSurface};
use landform::core::units::{Erodibility, Rate, YEAR};
use landform::core::{Error, Result};
use landform::io::format::load_raster;
use landform::process::stream_power::StreamPower;
use landform::process::uplift::Uplift;
use serde_json::{Value, json};

/// What to run.
struct Args {
    /// A, B, C, mesh or steady.
    task: String,
    /// Elevation file of task A.
    file: Option<PathBuf>,
    /// Side (A without a file, B) or nodes (C, mesh).
    n: usize,
    /// Steps of B and C.
    steps: u64,
    /// Threads.
    threads: usize,
}

impl Args {
    fn read(args: &[String]) -> Option<Self> {
        let mut read = Self { task: args.first()?.clone(), file: None, n: 1024, steps: 100, threads: 1 };
        for pair in args[1..].chunks(2) {
            let [key, value] = pair else { return None };
            match key.as_str() {
                "--file" => read.file = Some(value.into()),
                "--n" => read.n = value.parse().ok()?,
                "--steps" => read.steps = value.parse().ok()?,
                "--threads" => read.threads = value.parse().ok()?,
                _ => return None,
            }
        }
        Some(read)
    }
}

pub(crate) fn run(args: &[String]) -> bool {
    let Some(args) = Args::read(args) else {
        println!("peers A|B|C|mesh|steady [--file F] [--n N] [--steps N] [--threads N]");
        return false;
    };
    let result = with_threads(args.threads, || match args.task.as_str() {
        "A" => flow(&args),
        "B" => raster(&args),
        "C" => mesh(&args),
        "mesh" => delaunay(&args),
        "steady" => steady(&args),
        other => Err(Error::parameter("task", other, "A, B, C, mesh or steady")),
    });
    match result.and_then(|r| r) {
        Ok(line) => println!("{line}"),
        Err(e) => println!("{e}"),
    }
    true
}

/// CPU seconds of this process so far, from the kernel's clock ticks (1/100 s).
fn cpu() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    let ticks = |k: usize| fields.get(k).and_then(|f| f.parse::<f64>().ok()).unwrap_or(0.0);
    (ticks(11) + ticks(12)) / 100.0
}

fn peak_mb() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).unwrap_or_default();
    line.split_whitespace().nth(1).and_then(|k| k.parse::<f64>().ok()).unwrap_or(0.0) / 1024.0
}

fn line(task: &str, size: usize, threads: usize, seconds: f64, cpu: f64, more: Value) -> Value {
    let mut line = json!({ "peer": "landform", "version": env!("CARGO_PKG_VERSION"), "task": task, "size": size,
        "threads": threads, "seconds": seconds, "cpu": cpu, "peak_rss_mb": peak_mb() });
    if let (Value::Object(line), Value::Object(more)) = (&mut line, more) {
        line.extend(more);
    }
    line
}

fn flow(args: &Args) -> Result<Value> {
    let field = match &args.file {
        Some(path) => load_raster(path)?,
        None => rough(args.n)?,
    };
    let base = peak_mb();
    let (start, before) = (Instant::now(), cpu());
    let domain = field.domain();
    let mut area = node_areas(&*domain);
    let mut flow = Flow::new();
    flow.route(&*domain, field.elevation(), &mut area);
    let (seconds, used) = (start.elapsed().as_secs_f64(), cpu() - before);
    let peak = peak_mb();
    let again = Instant::now();
    let mut second = node_areas(&*domain);
    flow.route(&*domain, field.elevation(), &mut second);
    let again = again.elapsed().as_secs_f64();
    let cells = field.grid().len() as f64;
    let total = cells * field.grid().cell_area();
    let border: f64 = (0..area.len()).filter(|&i| flow.receivers()[i] as usize == i).map(|i| area[i]).sum();
    let greatest = area.iter().copied().fold(0.0, f64::max);
    let more = json!({ "note": "basin graph, carve, f64", "pits": flow.lakes(), "second_seconds": again,
        "bytes_per_cell": (peak - base) * 1_048_576.0 / cells, "check_border": border / total, "check_max": greatest / total });
    Ok(line("A", field.grid().shape.cols, args.threads, seconds, used, more))
}

fn rough(n: usize) -> Result<HeightField> {
    let grid = Grid::new(Shape::new(n, n), [100.0, 100.0])?;
    let z = (0..grid.len()).map(|i| Seed(7).uniform(i as u64)).collect();
    HeightField::new(grid, z)
}

fn evolve<T: NodeSurface>(
    terrain: T,
    uplift: f64,
    erodibility: f64,
    dt: f64,
    steps: u64,
) -> Result<(T, Vec<f64>, f64)> {
    let rivers = StreamPower {
        erodibility: Some(Erodibility::of(erodibility).into()),
        limiting_slope: Some(0.0),
        ..StreamPower::default()
    };
    let mut last = Instant::now();
    let mut times = Vec::new();
    let before = cpu();
    let mut simulation = Simulation::new(terrain)
        .process(Uplift { rate: Rate::of(uplift).into() })?
        .process(rivers)?
        .dt(dt * YEAR)
        .until(Stop::steps(steps))
        .observe(Every::Steps(1), |_| {
            times.push(last.elapsed().as_secs_f64());
            last = Instant::now();
            Ok(std::ops::ControlFlow::Continue(()))
        });
    simulation.run()?;
    let terrain = simulation.into_terrain();
    Ok((terrain, times, cpu() - before))
}

fn statistics(times: &[f64]) -> Value {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    let mean = |t: &[f64]| t.iter().sum::<f64>() / t.len().max(1) as f64;
    json!({ "sec_per_step": mean(times), "sec_per_step_median": sorted[sorted.len() / 2], "first10": mean(&times[..times.len().min(10)]),
        "last10": mean(&times[times.len().saturating_sub(10)..]) })
}

fn raster(args: &Args) -> Result<Value> {
    let (terrain, times, used) = evolve(rough(args.n)?, 1.0, 1e-5, 1e4, args.steps.max(1))?;
    let z = terrain.elevation();
    let mut more = statistics(&times);
    more["z_mean"] = (z.iter().sum::<f64>() / z.len() as f64).into();
    Ok(line("B", args.n, args.threads, times.iter().sum(), used, more))
}

fn rough_mesh(n: usize) -> Result<Mesh> {
    let size = [32_768.0; 2];
    let sites = poisson_disk(size, spacing_for_count(size, n), Seed(7))?;
    let mut terrain = Mesh::delaunay(&sites, Edges::default())?;
    let domain = terrain.domain();
    terrain.change(Layer::Bedrock, |z| {
        for (i, z) in z.iter_mut().enumerate() {
            *z = if domain.status()[i] == Status::Interior { 0.01 * Seed(8).uniform(i as u64) } else { 0.0 };
        }
    });
    Ok(terrain)
}

fn steady(args: &Args) -> Result<Value> {
    let begun = Instant::now();
    let mesh = rough_mesh(args.n)?;
    let meshed = begun.elapsed().as_secs_f64();
    let (nodes, before, start) = (mesh.elevation().len(), cpu(), Instant::now());
    let rivers = StreamPower {
        erodibility: Some(Erodibility::of(5.6e-7).into()),
        limiting_slope: Some(0.0),
        ..StreamPower::default()
    };
    let mut simulation = Simulation::new(mesh)
        .process(Uplift { rate: Rate::of(0.4).into() })?
        .process(rivers)?
        .dt(1e9 * YEAR)
        .until(Stop::steady(1e-15).or_steps(1_000))
        .refine(8);
    let outcome = simulation.run()?;
    let more = json!({ "mesh_seconds": meshed, "steps": outcome.steps, "residual": outcome.residual,
        "stopped": format!("{:?}", outcome.stopped) });
    Ok(line("steady", nodes, args.threads, start.elapsed().as_secs_f64(), cpu() - before, more))
}

fn mesh(args: &Args) -> Result<Value> {
    let terrain = rough_mesh(args.n)?;
    let (terrain, times, used) = evolve(terrain, 0.4, 5.6e-7, 250_000.0, args.steps.max(1))?;
    let z = terrain.elevation();
    let mut more = statistics(&times);
    more["z_max"] = z.iter().copied().fold(0.0, f64::max).into();
    Ok(line("C", z.len(), args.threads, times.iter().sum(), used, more))
}

fn delaunay(args: &Args) -> Result<Value> {
    let size = [32_768.0; 2];
    let start = Instant::now();
    let sites = poisson_disk(size, spacing_for_count(size, args.n), Seed(7))?;
    let sampling = start.elapsed().as_secs_f64();
    let (start, before) = (Instant::now(), cpu());
    let mesh = Mesh::delaunay(&sites, Edges::default())?;
    let (seconds, used) = (start.elapsed().as_secs_f64(), cpu() - before);
    let more = json!({ "sampling_seconds": sampling, "area_error": mesh.area() / (size[0] * size[1]) - 1.0 });
    Ok(line("mesh", sites.len(), args.threads, seconds, used, more))
}
