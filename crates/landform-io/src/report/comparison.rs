//! Two landscapes side by side.

use landform_core::Result;
use landform_core::analysis::{Comparison, compare};
use landform_core::math;
use landform_core::terrain::{HeightField, NodeSurface};
use serde::Serialize;

use super::Analysis;
use super::card::short;
use super::page::{escape, page, row, table};
use super::pictures::{figure, shrunk};
use super::plot::{Plot, Series, Style, linear, logarithmic};
use crate::render::{MapStyle, Picture, difference_map, shaded_map};

/// Result of a comparison.
#[derive(Debug, Serialize)]
pub struct ComparisonReport {
    /// How B differs from A.
    pub comparison: Comparison,
    /// A's measures.
    pub a: Analysis,
    /// B's measures.
    pub b: Analysis,
    /// The page.
    #[serde(skip)]
    pub html: String,
    /// B − A as a map.
    #[serde(skip)]
    pub map: Picture,
}

/// Compares two rasters (m) that lie node on node.
///
/// # Errors
/// As [`compare`] and [`Analysis::of`].
pub fn compare_reports(
    names: [&str; 2],
    a: &HeightField,
    b: &HeightField,
    sea_level: Option<f64>,
) -> Result<ComparisonReport> {
    let (comparison, difference) = compare(a, b)?;
    let measured = [Analysis::of(a, sea_level)?, Analysis::of(b, sea_level)?];
    let shown = HeightField::new(b.grid().clone(), b.elevation().to_vec())?;
    let map = {
        let mut carrier = shown;
        carrier.fields.insert_values("difference", landform_core::field::Values::F64(difference))?;
        let small = shrunk(&carrier)?;
        let values = small.real("difference", "the comparison")?;
        difference_map(&small, &values, 1100)?
    };
    let pair = |field: &HeightField, name: &str| -> Result<String> {
        let small = shrunk(field)?;
        figure(&shaded_map(&small, &MapStyle { size: 530, ..MapStyle::default() })?, &escape(name))
    };
    let title = format!("{} against {}", names[1], names[0]);
    let body = [
        format!("<p>A is {}; B is {}. Differences are B − A.</p>", escape(names[0]), escape(names[1])),
        "<div class=\"plots\">".into(),
        pair(a, &format!("A: {}", names[0]))?,
        pair(b, &format!("B: {}", names[1]))?,
        "</div><h2>Difference</h2>".into(),
        figure(&map, "B − A over B's relief: blue is lower in B, red higher, grey unchanged.")?,
        numbers(&comparison),
        "<h2>Before and after</h2><div class=\"plots\">".into(),
        curves(names, &measured),
        "</div><h2>Report cards</h2>".into(),
        cards(&measured),
    ]
    .concat();
    let [a, b] = measured;
    Ok(ComparisonReport { comparison, a, b, html: page(&title, &body), map })
}

fn numbers(c: &Comparison) -> String {
    let km3 = |v: f64| format!("{:.6}", v / 1e9);
    table(&[
        row("Nodes with data in both", &c.nodes.to_string(), &format!("{:.4} km²", c.area / 1e6)),
        row("Root mean square difference", &short(c.rmse), "m"),
        row("Mean difference, mean amount", &format!("{}, {}", short(c.mean), short(c.mean_amount)), "m"),
        row("Greatest cut, greatest raise", &format!("{}, {}", short(c.greatest_cut), short(c.greatest_raise)), "m"),
        row("Gone (eroded)", &km3(c.eroded), "km³"),
        row("Added (deposited, uplifted)", &km3(c.deposited), "km³"),
        row("Net", &km3(c.net), "km³"),
        row("Unchanged", &format!("{:.2}", 100.0 * c.unchanged), "% of the nodes"),
        row("Correlation of elevations", &format!("{:.6}", c.correlation), ""),
    ])
}

fn curves(names: [&str; 2], measured: &[Analysis; 2]) -> String {
    let log = |p: (f64, f64)| (math::log10(p.0), math::log10(p.1));
    let both = |f: &dyn Fn(&Analysis) -> Vec<(f64, f64)>| -> Vec<Series> {
        let series = |k: usize| Series {
            label: format!("{}: {}", ["A", "B"][k], names[k]),
            style: if k == 0 { Style::Dashed } else { Style::Line },
            points: f(&measured[k]),
        };
        vec![series(0), series(1)]
    };
    let plot = |title, x, y, series| Plot { title, x, y, series }.svg();
    [
        plot(
            "Hypsometric curves",
            linear("part of the area that lies higher"),
            linear("relative elevation"),
            both(&|m| m.metrics.hypsometry.curve.iter().enumerate().map(|(k, &z)| (k as f64 / 100.0, z)).collect()),
        ),
        plot(
            "Density of relief",
            logarithmic("wavelength, m"),
            logarithmic("m² per (1/m)²"),
            both(&|m| {
                m.metrics.spectrum.iter().flat_map(|s| s.bins.iter().map(|b| log((b.wavelength, b.density)))).collect()
            }),
        ),
        plot(
            "Slopes",
            linear("slope, degrees"),
            linear("% of the nodes"),
            both(&|m| {
                let bars = m.metrics.surface.iter().flat_map(|s| s.slope_histogram.iter().enumerate());
                bars.map(|(k, v)| (2.0 * k as f64 + 1.0, 100.0 * v)).collect()
            }),
        ),
        plot(
            "Slope against drainage area",
            logarithmic("drainage area, m²"),
            logarithmic("slope"),
            both(&|m| m.metrics.network.slope_area.bins.iter().map(|b| (b.0, b.1)).collect()),
        ),
        plot(
            "Variograms",
            logarithmic("distance, m"),
            logarithmic("mean squared difference, m²"),
            both(&|m| m.metrics.variogram.points.iter().copied().map(log).collect()),
        ),
    ]
    .concat()
}

fn cards([a, b]: &[Analysis; 2]) -> String {
    let verdicts = format!(
        "<p class=\"verdict\">A: <b>{}.</b> B: <b>{}.</b></p>",
        escape(&a.verdict.title),
        escape(&b.verdict.title)
    );
    let cell = |value: f64, inside: Option<bool>| match inside {
        Some(true) => format!("<td class=\"n inside\">{}</td>", short(value)),
        Some(false) => format!("<td class=\"n outside\">{}</td>", short(value)),
        None => "<td class=\"n\">–</td>".into(),
    };
    let lines: String = a
        .card
        .iter()
        .zip(&b.card)
        .map(|(x, y)| {
            format!(
                "<tr><td>{}</td>{}{}<td class=\"n\">{} – {}</td></tr>",
                escape(&x.name),
                cell(x.value, x.inside),
                cell(y.value, y.inside),
                short(x.natural[0]),
                short(x.natural[1])
            )
        })
        .collect();
    format!(
        "{verdicts}<div class=\"scroll\"><table class=\"card\"><thead><tr><th>Measure</th><th>A</th><th>B</th><th>On real ground</th></tr></thead><tbody>{lines}</tbody></table></div>"
    )
}
