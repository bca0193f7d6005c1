//! The report: one HTML file that opens offline, in light and dark, on paper too.

mod page;
mod plot;

use base64::Engine;
use landform_core::analysis::{Hypsometry, SlopeArea, Summary, hypsometry, slope_area, summary};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::YEAR;
use landform_core::verb::{Event, Landscape, Outcome};
use landform_core::{Result, math};

use crate::format::encode_png;
use crate::render::{MapStyle, Picture, View, perspective, shaded_map};
use page::{escape, page, row, table};
use plot::{Axis, Plot};

const PICTURE_WIDTH: usize = 1100;

/// The report of a landscape. `raster` is the terrain itself, or what stands for it in pictures.
///
/// # Errors
/// What pictures cannot be drawn from.
pub fn report<T: NodeSurface>(landscape: &Landscape<'_, T>, raster: &HeightField) -> Result<String> {
    let summary = summary(landscape.terrain);
    let hypsometry = hypsometry(raster.elevation());
    let cell = summary.area / summary.nodes.max(1) as f64;
    let rivers = slope_area(landscape.terrain, 4.0 * cell);
    let view = View { width: PICTURE_WIDTH, height: PICTURE_WIDTH * 9 / 16, ..View::default() };
    let map = MapStyle { size: PICTURE_WIDTH, ..MapStyle::default() };
    let body = [
        figure(
            &perspective(raster, &view),
            "Perspective view from the south-south-west, sun in the west-north-west, no exaggeration.",
        )?,
        "<h2>Numbers</h2>".into(),
        numbers(&summary, &hypsometry, &rivers),
        "<h2>Map</h2>".into(),
        figure(&shaded_map(raster, &map)?, "Shaded relief with rivers and lakes; north is up.")?,
        "<h2>Shape</h2><div class=\"plots\">".into(),
        hypsometric_plot(&hypsometry),
        slope_area_plot(&rivers),
        "</div>".into(),
        "<h2>How it came to be</h2>".into(),
        history(landscape.history, landscape.seed),
        sources(landscape.history),
    ]
    .concat();
    Ok(page(landscape.title, &body))
}

fn figure(picture: &Picture, caption: &str) -> Result<String> {
    let png = encode_png(&picture.pixels, picture.shape)?;
    let data = base64::engine::general_purpose::STANDARD.encode(png);
    Ok(format!(
        "<figure><img width=\"{}\" height=\"{}\" alt=\"{caption}\" src=\"data:image/png;base64,{data}\"><figcaption>{caption}</figcaption></figure>",
        picture.shape.cols, picture.shape.rows
    ))
}

fn numbers(s: &Summary, h: &Hypsometry, rivers: &SlopeArea) -> String {
    let degrees = |slope: f64| math::atan(slope).to_degrees();
    table(&[
        row("Nodes", &s.nodes.to_string(), ""),
        row("Nodata", &s.nodata.to_string(), ""),
        row("Area", &format!("{:.2}", s.area / 1e6), "km²"),
        row("Lowest", &format!("{:.1}", s.min), "m"),
        row("Highest", &format!("{:.1}", s.max), "m"),
        row("Mean elevation", &format!("{:.1}", s.mean), "m"),
        row("Hypsometric integral", &format!("{:.3}", h.integral), "(mean − min)/(max − min)"),
        row("Median slope along the flow", &format!("{:.1}", degrees(s.median_slope)), "degrees"),
        row("Steepest slope along the flow", &format!("{:.1}", degrees(s.max_slope)), "degrees"),
        row("Hollows that hold water", &s.lakes.to_string(), "local minima"),
        row("Concavity of rivers", &format!("{:.2}", rivers.concavity), &format!("slope–area, R² {:.3}", rivers.r2)),
    ])
}

fn hypsometric_plot(h: &Hypsometry) -> String {
    let points = h.curve.iter().enumerate().map(|(k, &z)| (k as f64 / 100.0, z)).collect();
    Plot {
        title: "Hypsometric curve",
        x: Axis { label: "part of the area that lies higher", logarithmic: false },
        y: Axis { label: "relative elevation", logarithmic: false },
        points,
        line: true,
    }
    .svg()
}

fn slope_area_plot(rivers: &SlopeArea) -> String {
    let points = rivers.bins.iter().map(|b| (b.0, b.1)).collect();
    Plot {
        title: "Slope against drainage area",
        x: Axis { label: "drainage area, m²", logarithmic: true },
        y: Axis { label: "slope", logarithmic: true },
        points,
        line: false,
    }
    .svg()
}

fn history(events: &[Event], seed: u64) -> String {
    let mut items = String::new();
    for event in events {
        let outcome = event.outcome.as_ref().map(outcome_text).unwrap_or_default();
        items +=
            &format!("<li><b>{}</b> <code>{}</code>{outcome}</li>", escape(&event.stage), escape(&event.parameters));
    }
    format!("<p>Seed {seed}, landform {}.</p><ol>{items}</ol>", env!("CARGO_PKG_VERSION"))
}

fn outcome_text(o: &Outcome) -> String {
    let residual = o.residual.map(|r| format!(", residual {r:.3e}")).unwrap_or_default();
    let c = &o.budget.change;
    let km3 = |v: f64| format!("{:.3}", v / 1e9);
    format!(
        "<br>{:?} after {} steps, {:.4} Myr{residual}. Supplied {} km³, eroded {} km³, deposited {} km³, exported {} km³; unaccounted for: {:.1e} of what was moved.",
        o.stopped,
        o.steps,
        o.time / (1e6 * YEAR),
        km3(c.supplied),
        km3(c.eroded),
        km3(c.deposited),
        km3(c.exported),
        o.budget.imbalance()
    )
}

fn sources(events: &[Event]) -> String {
    let mut seen: Vec<&[String; 3]> = Vec::new();
    for source in events.iter().flat_map(|e| &e.sources) {
        if !seen.contains(&source) {
            seen.push(source);
        }
    }
    if seen.is_empty() {
        return String::new();
    }
    let items: String = seen
        .iter()
        .map(|[authors, title, doi]| format!("<li>{}: {}. {}</li>", escape(authors), escape(title), escape(doi)))
        .collect();
    format!("<h2>Sources</h2><ul>{items}</ul>")
}
