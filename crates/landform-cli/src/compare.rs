//! `landform compare`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::core::Error;
use landform::core::grid::Grid;
use landform::core::terrain::{HeightField, Interpolation, resample};
use landform::core::units::Length;
use landform::io::files::write_whole;
use landform::io::format::encode_png;
use landform::io::report::compare_reports;

use crate::ground::{self, Ground, Scale};
use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// The landscape before.
    a: PathBuf,
    /// The landscape after. If its raster is another one of the same place, it is resampled to A's.
    b: PathBuf,
    /// Writes the comparison: one HTML file that opens offline.
    #[arg(long)]
    report: Option<PathBuf>,
    /// Writes all numbers as JSON.
    #[arg(long)]
    json: Option<PathBuf>,
    /// Writes the map of differences (.png).
    #[arg(long)]
    map: Option<PathBuf>,
    /// Level of the sea: ground at or under it is left out of what is measured of each.
    #[arg(long, allow_hyphen_values = true)]
    sea_level: Option<String>,
    #[command(flatten)]
    scale: Scale,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let sea_level = args.sea_level.as_deref().map(Length::parse).transpose()?.map(Length::si);
    if let Some(map) = &args.map
        && map.extension().is_none_or(|e| !e.eq_ignore_ascii_case("png"))
    {
        return Err(Error::extension("map", &map.display().to_string(), &["png"]).into());
    }
    let (a, b) = (ground::load(&args.a, &args.scale)?, ground::load(&args.b, &args.scale)?);
    for (name, ground) in [("A", &a), ("B", &b)] {
        for note in &ground.notes {
            say!("note: {name}: {note}");
        }
    }
    let (a, b) = onto(a, b, args.scale.is_given())?;
    let names = [ground::name(&args.a), ground::name(&args.b)];
    let found = compare_reports([&names[0], &names[1]], &a, &b, sea_level)?;
    let c = &found.comparison;
    say!("{} nodes with data in both, B - A:", c.nodes);
    say!("  root mean square {:.4} m, mean {:.4} m, mean amount {:.4} m", c.rmse, c.mean, c.mean_amount);
    say!(
        "  greatest cut {:.3} m, greatest raise {:.3} m, {:.2} % unchanged",
        c.greatest_cut,
        c.greatest_raise,
        100.0 * c.unchanged
    );
    say!("  gone {:.6} km3, added {:.6} km3, net {:.6} km3", c.eroded / 1e9, c.deposited / 1e9, c.net / 1e9);
    say!("\n{:<37} {:>10} {:>10}  {}", "measure", "A", "B", "on real ground");
    for (x, y) in found.a.card.iter().zip(&found.b.card) {
        let value = |v: f64, inside: Option<bool>| {
            format!("{}{}", ground::number(v), if inside == Some(false) { "!" } else { " " })
        };
        say!(
            "{:<37} {:>11} {:>11} {:.2} to {:.2}",
            x.name,
            value(x.value, x.inside),
            value(y.value, y.inside),
            x.natural[0],
            x.natural[1]
        );
    }
    say!("\nA: {}. B: {}.", found.a.verdict.title, found.b.verdict.title);
    if let Some(path) = &args.json {
        write_whole(path, (serde_json::to_string_pretty(&found).unwrap_or_default() + "\n").as_bytes())?;
        say!("{}", path.display());
    }
    if let Some(path) = &args.report {
        write_whole(path, found.html.as_bytes())?;
        say!("{}", path.display());
    }
    if let Some(path) = &args.map {
        write_whole(path, &encode_png(&found.map.pixels, found.map.shape)?)?;
        say!("{}", path.display());
    }
    Ok(ExitCode::SUCCESS)
}

/// B on A's raster, where they lie in the same place.
fn onto(a: Ground, b: Ground, scaled: bool) -> landform::core::Result<(HeightField, HeightField)> {
    let (ga, gb) = (&a.grid, &b.grid);
    let cells = |k: usize| (ga.origin[k] - gb.origin[k]).abs() / ga.spacing[k];
    let same =
        ga.shape == gb.shape && (0..2).all(|k| (ga.spacing[k] / gb.spacing[k] - 1.0).abs() < 1e-6 && cells(k) < 0.01);
    // A file that names no system is taken at its coordinates.
    let systems = ga.georeference.epsg.zip(gb.georeference.epsg);
    let other_system = systems.is_some_and(|(a, b)| a != b);
    if same && !other_system {
        return Ok((a.field, b.field));
    }
    let place = |g: &Grid| {
        let epsg = g.georeference.epsg.map_or("no coordinate system".into(), |e| format!("EPSG:{e}"));
        format!("{epsg}, {} from ({}, {})", g.shape, g.origin[0], g.origin[1])
    };
    let apart = |hint: &str| Err(Error::parameter("b", place(gb), &format!("the place of A, {} ({hint})", place(ga))));
    if scaled {
        return if ga.shape == gb.shape {
            Ok((a.field, b.field))
        } else {
            apart("the same number of rows and columns")
        };
    }
    if other_system {
        return apart("warp one of them first");
    }
    let overlap = (0..2).all(|k| {
        let range = |g: &Grid| {
            let (o, e) = (g.origin[k], g.extent()[k]);
            if k == 0 { (o, o + e) } else { (o - e, o) }
        };
        let ((al, ah), (bl, bh)) = (range(ga), range(gb));
        ah.min(bh) - al.max(bl) > 0.1 * (ah - al)
    });
    if !overlap || a.field.grid().georeference != ga.georeference {
        return apart("they hardly overlap, or are in degrees: warp them to one raster");
    }
    say!("note: B was brought to A's raster: {}", place(gb));
    let b = resample(&b.field, a.field.grid(), Interpolation::Linear)?;
    Ok((a.field, b))
}
