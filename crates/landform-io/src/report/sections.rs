//! Numbers and plots of the measures.

use landform_core::analysis::{Chi, Metrics, PowerLaw};
use landform_core::math;

use super::card::short;
use super::page::{escape, row, table};
use super::plot::{Plot, Series, Style, linear, logarithmic, unnamed};

/// The papers behind the measures.
pub(super) const SOURCES: &[&str] = &[
    "Strahler (1952): Hypsometric (area-altitude) analysis of erosional topography, GSA Bulletin 63. doi:10.1130/0016-7606(1952)63[1117:HAAOET]2.0.CO;2",
    "Horn (1981): Hill shading and the reflectance map, Proceedings of the IEEE 69. doi:10.1109/PROC.1981.11918",
    "Flint (1974): Stream gradient as a function of order, magnitude, and discharge, Water Resources Research 10. doi:10.1029/WR010i005p00969",
    "Perron & Royden (2013): An integral approach to bedrock river profile analysis, Earth Surface Processes and Landforms 38. doi:10.1002/esp.3302",
    "Horton (1945): Erosional development of streams and their drainage basins, GSA Bulletin 56. doi:10.1130/0016-7606(1945)56[275:EDOSAT]2.0.CO;2",
    "Perron, Kirchner & Dietrich (2008): Spectral signatures of characteristic spatial scales and nonfractal structure in landscapes, Journal of Geophysical Research 113. doi:10.1029/2007JF000866",
    "Mandelbrot (1967): How long is the coast of Britain? Science 156. doi:10.1126/science.156.3775.636",
];

fn named(label: &str, style: Style, points: Vec<(f64, f64)>) -> Series {
    Series { label: label.into(), style, points }
}

fn plots(list: &[String]) -> String {
    format!("<div class=\"plots\">{}</div>", list.concat())
}

/// Elevations and hypsometry.
pub(super) fn elevations(m: &Metrics) -> String {
    let (e, h) = (&m.elevations, &m.hypsometry);
    let cell = if (e.spacing[0] / e.spacing[1] - 1.0).abs() < 1e-9 {
        format!("{:.4}", e.spacing[0])
    } else {
        format!("{:.4} x {:.4}", e.spacing[0], e.spacing[1])
    };
    let cut = m
        .sea_level
        .map(|s| format!(" The ground at or under {s} m, the sea, is left out of all but the coast."))
        .unwrap_or_default();
    let numbers = table(&[
        row("Nodes", &format!("{} x {}", e.shape[1], e.shape[0]), "columns x rows"),
        row("Distance between nodes", &cell, "m"),
        row("Without data", &format!("{:.2}", 100.0 * e.nodata_share), "%"),
        row("Area", &format!("{:.4}", e.area / 1e6), "km²"),
        row("Lowest, highest", &format!("{:.1}, {:.1}", e.min, e.max), "m"),
        row("Relief", &format!("{:.1}", e.relief), "m"),
        row("Mean, median", &format!("{:.1}, {:.1}", e.mean, e.median), "m"),
        row("Standard deviation", &format!("{:.1}", e.deviation), "m"),
        row("Hypsometric integral", &format!("{:.4}", h.integral), "(mean − min)/(max − min)"),
        row("… without the outer 0.1 %", &format!("{:.4}", h.integral_clipped), "does not hang on two nodes"),
        row("Class", h.class.name(), &h.reason),
        row(
            "Strahler's model",
            &format!("a/d {:.4}, z {:.3}", h.model.ratio, h.model.exponent),
            &format!("rms {:.4} of the relief", h.model.rms),
        ),
        row("Skew of elevations", &format!("{:.3}", h.elevation_skew), ""),
    ]);
    let curve: Vec<(f64, f64)> = h.curve.iter().enumerate().map(|(k, &z)| (k as f64 / 100.0, z)).collect();
    let model = (0..=100).map(|k| f64::from(k) / 100.0).map(|x| (x, h.model.at(x))).collect();
    let plot = Plot {
        title: "Hypsometric curve",
        x: linear("part of the area that lies higher"),
        y: linear("relative elevation"),
        series: vec![named("here", Style::Line, curve), named("Strahler's family", Style::Dashed, model)],
    };
    format!("<h2>Elevations</h2><p class=\"note\">{}</p>{}", escape(cut.trim()), plots(&[numbers, plot.svg()]))
}

/// Slopes, directions, curvature, pits and peaks.
pub(super) fn surface(m: &Metrics) -> String {
    let f = &m.form;
    let mut rows = Vec::new();
    let mut drawn = Vec::new();
    if let Some(s) = &m.surface {
        rows.extend([
            row("Slope: mean, median", &format!("{:.2}, {:.2}", s.slope_mean, s.slope_median), "degrees (Horn)"),
            row("90th, 99th percentile", &format!("{:.2}, {:.2}", s.slope_p90, s.slope_p99), "degrees"),
            row("Steepest", &format!("{:.2}", s.slope_max), "degrees"),
            row("Within 10 % of 33 degrees", &format!("{:.2}", 100.0 * s.talus_share), "% of the nodes"),
            row("Below half a degree", &format!("{:.2}", 100.0 * s.level_share), "% of the nodes"),
            row("Mean relief within 11 x 11 nodes", &format!("{:.1}", s.local_relief), "m"),
            row("Profile curvature, standard deviation", &format!("{:.2e}", s.profile_curvature), "1/m"),
            row("Spurs among slopes", &format!("{:.1}", 100.0 * s.spur_share), "%; the rest are hollows"),
        ]);
        let bars = s.slope_histogram.iter().enumerate().map(|(k, &v)| (2.0 * k as f64 + 1.0, 100.0 * v)).collect();
        drawn.push(
            Plot {
                title: "Slopes",
                x: linear("slope, degrees"),
                y: linear("% of the nodes"),
                series: vec![unnamed(Style::Bars, bars)],
            }
            .svg(),
        );
        const NAMES: [&str; 8] =
            ["north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west"];
        let most = s.aspect_rose.iter().enumerate().fold((0, 0.0), |a, (k, &v)| if v > a.1 { (k, v) } else { a });
        rows.push(row(
            "Most ground faces",
            NAMES[most.0],
            &format!("{:.1} % of the slopes (even: 12.5)", 100.0 * most.1),
        ));
    }
    rows.extend([
        row("In sinks", &format!("{:.2}", 100.0 * f.sinks), "% of the nodes, if every hollow filled"),
        row("… upside down", &format!("{:.2}", 100.0 * f.sinks_upside_down), "% of the nodes"),
        row("Pits, peaks", &format!("{:.2}, {:.2}", f.pits, f.peaks), "per 1000 nodes"),
    ]);
    drawn.insert(0, table(&rows));
    format!("<h2>Surface</h2>{}", plots(&drawn))
}

/// Rivers.
pub(super) fn drainage(m: &Metrics) -> String {
    let n = &m.network;
    let s = &n.scaling;
    let mut rows = vec![
        row("Greatest drainage area", &format!("{:.4}", n.greatest_area / 1e6), "km²"),
        row("Hack's exponent h", &short(s.hack_exponent), &format!("L ~ A^h from 20 nodes, R² {:.4}", s.hack_r2)),
        row(
            "Area exceedance β",
            &short(s.area_exponent),
            &format!("reads 0.045 high; {} up to A/100", short(s.area_exponent_short)),
        ),
        row("Length exceedance ψ", &short(s.length_exponent), "β/h in a self-similar network"),
        row("Concavity θ", &short(n.slope_area.concavity), &format!("slope against area, R² {:.4}", n.slope_area.r2)),
        row(
            "Strahler order, Shreve magnitude",
            &format!("{}, {}", n.horton.order, n.horton.magnitude),
            "channels from 100 nodes",
        ),
        row(
            "Bifurcation, length, area ratio",
            &format!("{}, {}, {}", short(n.horton.bifurcation), short(n.horton.length), short(n.horton.area)),
            "Horton's; they tell nothing apart",
        ),
    ];
    if let Some(d) = n.drainage_density {
        rows.push(row("Drainage density", &short(d), "km per km², channels from 1 km²"));
    }
    if let Some(c) = &n.chi {
        rows.push(row(
            "Steepness k_sn",
            &short(c.steepness),
            &format!("m^0.9, largest basin, R² {:.4}, trunk {:.4}", c.r2, c.r2_trunk),
        ));
        rows.push(row("Best concavity by chi", &short(c.best_concavity), ""));
    }
    let line = |points: Vec<(f64, f64)>| {
        let (slope, at, _) = math::line_fit(points.iter().copied());
        points.iter().map(|p| (p.0, at + slope * p.0)).collect::<Vec<_>>()
    };
    let bins: Vec<(f64, f64)> = n.slope_area.bins.iter().map(|b| (b.0, b.1)).collect();
    let mut drawn = vec![table(&rows)];
    drawn.push(
        Plot {
            title: "Slope against drainage area",
            x: logarithmic("drainage area, m²"),
            y: logarithmic("slope"),
            series: vec![
                unnamed(Style::Dots, bins.clone()),
                named(&format!("θ = {}", short(n.slope_area.concavity)), Style::Dashed, line(bins)),
            ],
        }
        .svg(),
    );
    if let Some(Chi { points, trunk, .. }) = &n.chi {
        let km = |p: &(f64, f64)| (p.0 / 1e3, p.1);
        drawn.push(
            Plot {
                title: "Elevation against chi, largest basin",
                x: linear("χ (θ = 0.45, A₀ = 1 km²), km"),
                y: linear("elevation, m"),
                series: vec![
                    named("tributaries", Style::Dots, points[*trunk..].iter().map(km).collect()),
                    named("trunk", Style::Line, points[..*trunk].iter().map(km).collect()),
                ],
            }
            .svg(),
        );
    }
    format!("<h2>Drainage</h2>{}", plots(&drawn))
}

/// Spectrum and variogram.
pub(super) fn roughness(m: &Metrics, picture: String) -> String {
    let v = &m.variogram;
    let logs = |list: &[(f64, f64)]| list.iter().map(|p| (math::log10(p.0), math::log10(p.1))).collect::<Vec<_>>();
    let law = |l: &PowerLaw| (format!("{:.3}", l.exponent), format!("R² {:.4}", l.r2));
    let mut rows = Vec::new();
    let mut drawn = Vec::new();
    if let Some(s) = &m.spectrum {
        let of = |name: &str, l: &PowerLaw, what: &str| row(name, &law(l).0, &format!("{what}, {}", law(l).1));
        rows.extend([
            row(
                "Window",
                &format!("{0} x {0}", s.window.side),
                "nodes: the largest square with data, plane removed, Hann taper",
            ),
            of("β of the surface, by rings", &s.surface, "2H + 2 for fractional Brownian ground"),
            of("… by bins", &s.surface_by_bins, "each scale weighs the same"),
            of("… long waves", &s.long_waves, "lower half of the bins"),
            of("… short waves", &s.short_waves, "upper half"),
            of("β of profiles", &s.profiles, "2H + 1"),
            row("H from β by rings", &format!("{:.3}", s.hurst), "(β − 2)/2"),
            row("Axes over diagonals", &format!("{:.3}", s.axes_over_diagonals), "1: no trace of the grid"),
            row("Stands out", &format!("{:.0} m", s.peak.0), &format!("{:.1} times the power law", s.peak.1)),
            row(
                "The thesis' figures of merit",
                &format!("RMS {:.3}, R² {:.3}", s.thesis_fit.rms, s.thesis_fit.r2),
                &format!(
                    "{} points, {} removed; RMS on our scale of r. They cannot see the slope: it is {:.3}",
                    s.thesis_fit.points, s.thesis_fit.removed, s.thesis_fit.exponent
                ),
            ),
        ]);
        let rings: Vec<(f64, f64)> = s.rings.iter().map(|r| (r.wavelength, r.density)).collect();
        let mut points = logs(&rings);
        let used = points.len().min(s.window.side / 4);
        let fit = math::line_fit(points.iter().take(used).skip(3).copied());
        let line = points.iter().take(used).skip(3).map(|p| (p.0, fit.1 + fit.0 * p.0)).collect();
        // Hundreds of rings lie on top of one another at the short end.
        if points.len() > 400 {
            points = logs(&s.bins.iter().map(|b| (b.wavelength, b.density)).collect::<Vec<_>>());
        }
        drawn.push(
            Plot {
                title: "Density of relief against wavelength",
                x: logarithmic("wavelength, m"),
                y: logarithmic("m² per (1/m)²"),
                series: vec![
                    unnamed(Style::Dots, points),
                    named(&format!("β = {:.2}", s.surface.exponent), Style::Dashed, line),
                ],
            }
            .svg(),
        );
    } else {
        rows.push(row("Spectrum", "–", "no square of 32 nodes a side has data"));
    }
    rows.extend([
        row(
            "H by the variogram",
            &format!("{:.3}", v.hurst),
            &format!("1 to 32 nodes; {:.3} without the plane", v.hurst_detrended),
        ),
        row("… 1 to 4, 8 to 32 nodes", &format!("{:.3}, {:.3}", v.hurst_near, v.hurst_far), ""),
        row("… along rows, columns", &format!("{:.3}, {:.3}", v.hurst_rows, v.hurst_columns), ""),
    ]);
    drawn.push(
        Plot {
            title: "Variogram",
            x: logarithmic("distance, m"),
            y: logarithmic("mean squared difference, m²"),
            series: vec![unnamed(Style::Dots, logs(&v.points)), unnamed(Style::Line, logs(&v.points))],
        }
        .svg(),
    );
    drawn.insert(0, table(&rows));
    drawn.push(picture);
    format!(
        "<h2>Roughness</h2><p class=\"note\">The slope of the spectrum tells how rough ground is. A good fit alone tells nothing: any cloud about a falling line has one.</p>{}",
        plots(&drawn)
    )
}

/// The coast.
pub(super) fn coast(m: &Metrics) -> String {
    let c = &m.coast;
    let what = if m.sea_level.is_some() || c.level == 0.0 { "Coast" } else { "Contour at the median elevation" };
    let mut rows = vec![
        row("Level", &format!("{:.2}", c.level), "m"),
        row("Length of all lines", &format!("{:.2}", c.length / 1e3), "km"),
        row("Longest line", &format!("{:.2}", c.longest / 1e3), "km"),
        row("Pieces of land, lines", &format!("{}, {}", c.islands, c.lines), ""),
        row("Largest piece", &format!("{:.4}", c.largest.first().copied().unwrap_or(0.0) / 1e6), "km²"),
        row("Land", &format!("{:.1}", 100.0 * c.land_share), "% of the map"),
    ];
    let mut series = Vec::new();
    let divider = c.divider.dimension.zip(c.divider.r2);
    let boxes = c.boxes.as_ref().map(|d| (d.dimension, d.r2));
    let points = c.boxes.as_ref().map_or(&[][..], |d| &d.points);
    for (name, found, points) in [("divider", divider, &c.divider.points[..]), ("boxes", boxes, points)] {
        if let Some((dimension, r2)) = found {
            rows.push(row(
                &format!("Dimension by {name}"),
                &format!("{dimension:.3}"),
                &format!("R² {r2:.4}; real coasts: South Africa 1.02, Britain's west 1.25, Norway 1.52"),
            ));
            let points = points.iter().map(|p| (math::log10(p.0), math::log10(p.1))).collect();
            series.push(named(name, if name == "boxes" { Style::Dots } else { Style::Line }, points));
        }
    }
    if let Some(why) = c.divider.why.as_ref().filter(|_| c.lines > 0) {
        rows.push(row("Dimension by divider", "none", why));
    }
    let plot = Plot {
        title: "Steps and boxes against their size",
        x: logarithmic("size, m"),
        y: logarithmic("number"),
        series,
    };
    format!("<h2>{what}</h2>{}", plots(&[table(&rows), plot.svg()]))
}
