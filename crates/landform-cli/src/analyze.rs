//! `landform analyze`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::core::analysis::{Divider, dimension_by_boxes};
use landform::core::units::Length;
use landform::core::verb::{Export, Landscape};
use landform::io::export::WriteMaps;
use landform::io::files::{Folder, read_whole, write_whole};
use landform::io::import::lines;
use landform::io::report::{Analysis, report};

use crate::ground::{self, Scale};
use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Elevation file of any format, or a GeoJSON file of coasts.
    input: PathBuf,
    /// Writes the report: one HTML file that opens offline.
    #[arg(long)]
    report: Option<PathBuf>,
    /// Writes all numbers as JSON.
    #[arg(long)]
    json: Option<PathBuf>,
    /// Writes maps into this folder: pictures, GeoTIFFs, contours and rivers as GeoJSON.
    #[arg(long)]
    maps: Option<PathBuf>,
    /// Level of the sea, such as "0 m": ground at or under it is left out of all but the coast.
    #[arg(long, allow_hyphen_values = true)]
    sea_level: Option<String>,
    /// Coasts: the least step of the divider, such as "4 km". If not given, it is twice the mean
    /// distance of points.
    #[arg(long)]
    step_from: Option<String>,
    /// Coasts: the greatest step of the divider. If not given, it is a quarter of the extent.
    #[arg(long)]
    step_to: Option<String>,
    #[command(flatten)]
    scale: Scale,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let extension = args.input.extension().map(|e| e.to_string_lossy().to_lowercase());
    if matches!(extension.as_deref(), Some("geojson" | "json")) {
        return run_lines(args);
    }
    if args.step_from.is_some() || args.step_to.is_some() {
        return Err(refusal(
            "--step-from and --step-to are for files of lines",
            "a raster's coast is measured from its own cells",
        ));
    }
    if args.json.is_some() && args.json == args.report {
        return Err(refusal("--json and --report name the same file", "give them different names"));
    }
    let ground::Ground { field, notes, .. } = ground::load(&args.input, &args.scale)?;
    let sea_level = args.sea_level.as_deref().map(Length::parse).transpose()?;
    let analysis = Analysis::of(&field, sea_level.map(Length::si))?;
    for note in &notes {
        say!("note: {note}");
    }
    let below = analysis.metrics.elevations.min < 0.0 && analysis.metrics.elevations.max > 0.0;
    if below && sea_level.is_none() {
        say!("note: some ground lies below 0 m; with --sea-level \"0 m\" only the land is measured");
    }
    summary(&analysis);
    let title = ground::name(&args.input);
    let mut landscape = Landscape::plain(&field);
    landscape.title = &title;
    if let Some(path) = &args.json {
        write_whole(path, analysis.json().as_bytes())?;
        say!("{}", path.display());
    }
    if let Some(path) = &args.report {
        write_whole(path, report(&landscape, &field, &analysis)?.as_bytes())?;
        say!("{}", path.display());
    }
    if let Some(folder) = &args.maps {
        let mut out = Folder::create(folder)?;
        WriteMaps { path: ".".into(), sea_level }.export(&landscape, &mut out)?;
        say!("{}", folder.display());
    }
    Ok(ExitCode::SUCCESS)
}

fn refusal(what: &str, hint: &str) -> Failure {
    landform::core::Error::Recipe { at: None, what: what.into(), hint: Some(hint.into()) }.into()
}

/// The report card in a terminal.
fn summary(analysis: &Analysis) {
    let e = &analysis.metrics.elevations;
    say!(
        "{} x {} nodes of {:.4} x {:.4} m, {:.1} to {:.1} m, {:.2} % without data",
        e.shape[1],
        e.shape[0],
        e.spacing[0],
        e.spacing[1],
        e.min,
        e.max,
        100.0 * e.nodata_share
    );
    say!("hypsometry: {}, {}", analysis.metrics.hypsometry.class.name(), analysis.metrics.hypsometry.reason);
    say!("\n{:<37} {:>10}  {:<16}", "measure", "here", "on real ground");
    for line in &analysis.card {
        let word = match line.inside {
            Some(true) => "",
            Some(false) => "outside",
            None => "not measured",
        };
        let name = if line.decides { format!("* {}", line.name) } else { format!("  {}", line.name) };
        let range = format!("{:.2} to {:.2}", line.natural[0], line.natural[1]);
        say!("{name:<37} {:>10}  {range:<16} {word}", ground::number(line.value));
    }
    say!("\n{}. {}", analysis.verdict.title, analysis.verdict.reason);
}

fn run_lines(args: &Args) -> Result<ExitCode, Failure> {
    let length = |name: &str, text: &Option<String>| text.as_deref().map(|t| ground::positive(name, t)).transpose();
    let (from, to) =
        (length("step_from", &args.step_from)?, length("step_to", &args.step_to)?.unwrap_or(f64::INFINITY));
    if args.report.is_some() || args.maps.is_some() || args.sea_level.is_some() || args.scale.is_given() {
        return Err(refusal(
            "only --json, --step-from and --step-to can be used with a file of lines",
            "leave the other options out",
        ));
    }
    let list = lines(&read_whole(&args.input)?)?;
    let mut all = Vec::new();
    for line in &list {
        let length: f64 = line.points.windows(2).map(|p| distance(p[0], p[1])).sum();
        let least = from.unwrap_or(2.0 * length / (line.points.len() - 1) as f64);
        if least < 1e-6 * length {
            return Err(refusal(
                "--step-from is less than a millionth of the line's length",
                "the distance of the points is a fair least step",
            ));
        }
        let divider = Divider::along(&line.points, least, to);
        let boxes = dimension_by_boxes(&[&line.points], least, to);
        let text = |dimension: f64, r2: f64, points: &[(f64, f64)]| {
            let end = |point: Option<&(f64, f64)>| point.map_or(f64::NAN, |p| p.0 / 1e3);
            format!("{dimension:.4} (R² {r2:.4}, {:.3} to {:.3} km)", end(points.first()), end(points.last()))
        };
        let by_divider = match divider.dimension.zip(divider.r2) {
            Some((dimension, r2)) => text(dimension, r2, &divider.points),
            None => format!("none: {}", divider.why.as_deref().unwrap_or("too short")),
        };
        let by_boxes = boxes.as_ref().map_or("too short".into(), |d| text(d.dimension, d.r2, &d.points));
        say!("{}: {} points, {:.1} km", line.name, line.points.len(), length / 1e3);
        say!("  dimension by divider {by_divider}");
        say!("  dimension by boxes   {by_boxes}");
        all.push(serde_json::json!({ "name": line.name, "points": line.points.len(), "length_m": length, "divider": divider, "boxes": boxes }));
    }
    if let Some(path) = &args.json {
        write_whole(path, (serde_json::to_string_pretty(&all).unwrap_or_default() + "\n").as_bytes())?;
        say!("{}", path.display());
    }
    Ok(ExitCode::SUCCESS)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    landform::core::math::hypot(b[0] - a[0], b[1] - a[1])
}
