//! Small plots as SVG.

use std::fmt::Write;

const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 320.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 30.0;
const BOTTOM: f64 = 46.0;

/// An axis; a logarithmic one takes decimal logarithms and labels powers of ten.
pub(super) struct Axis {
    pub(super) label: &'static str,
    pub(super) logarithmic: bool,
}

/// Points, joined or not.
pub(super) struct Plot {
    pub(super) title: &'static str,
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) points: Vec<(f64, f64)>,
    pub(super) line: bool,
}

impl Plot {
    pub(super) fn svg(&self) -> String {
        let points: Vec<_> = self.points.iter().filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
        if points.is_empty() {
            return String::new();
        }
        let (x0, x1) = bounds(points.iter().map(|p| p.0));
        let (y0, y1) = bounds(points.iter().map(|p| p.1));
        let px = |x: f64| LEFT + (x - x0) / (x1 - x0) * (WIDTH - LEFT - RIGHT);
        let py = |y: f64| HEIGHT - BOTTOM - (y - y0) / (y1 - y0) * (HEIGHT - TOP - BOTTOM);
        let mut svg = format!("<svg width=\"{WIDTH}\" height=\"{HEIGHT}\" role=\"img\" aria-label=\"{}\">", self.title);
        let (bottom, right) = (HEIGHT - BOTTOM, WIDTH - RIGHT);
        for t in ticks(x0, x1, self.x.logarithmic) {
            let x = px(t);
            write!(svg, "<line class=\"grid\" x1=\"{x:.1}\" y1=\"{TOP}\" x2=\"{x:.1}\" y2=\"{bottom}\"/>").ok();
            write!(
                svg,
                "<text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                bottom + 16.0,
                label(t, &self.x)
            )
            .ok();
        }
        for t in ticks(y0, y1, self.y.logarithmic) {
            let y = py(t);
            write!(svg, "<line class=\"grid\" x1=\"{LEFT}\" y1=\"{y:.1}\" x2=\"{right}\" y2=\"{y:.1}\"/>").ok();
            write!(
                svg,
                "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                LEFT - 6.0,
                y + 4.0,
                label(t, &self.y)
            )
            .ok();
        }
        write!(svg, "<path class=\"axis\" d=\"M{LEFT} {TOP}V{bottom}H{right}\"/>").ok();
        let (middle_x, middle_y) = ((LEFT + right) / 2.0, (TOP + bottom) / 2.0);
        write!(svg, "<text x=\"{middle_x}\" y=\"18\" text-anchor=\"middle\">{}</text>", self.title).ok();
        write!(svg, "<text x=\"{middle_x}\" y=\"{}\" text-anchor=\"middle\">{}</text>", HEIGHT - 8.0, self.x.label)
            .ok();
        write!(
            svg,
            "<text transform=\"translate(14 {middle_y}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            self.y.label
        )
        .ok();
        if self.line {
            let path: Vec<String> = points.iter().map(|p| format!("{:.1} {:.1}", px(p.0), py(p.1))).collect();
            write!(svg, "<path class=\"line\" d=\"M{}\"/>", path.join("L")).ok();
        } else {
            for p in points {
                write!(svg, "<circle class=\"mark\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"3\"/>", px(p.0), py(p.1)).ok();
            }
        }
        svg + "</svg>"
    }
}

fn bounds(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (lo, hi) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    if hi > lo { (lo, hi) } else { (lo - 0.5, hi + 0.5) }
}

/// About five round values within bounds; whole powers of ten on a logarithmic axis.
fn ticks(lo: f64, hi: f64, logarithmic: bool) -> Vec<f64> {
    let rough = (hi - lo) / 5.0;
    let decade = landform_core::math::pow(10.0, landform_core::math::log10(rough).floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|k| k * decade).find(|s| *s >= rough).unwrap_or(rough);
    let step = if logarithmic { step.max(1.0).round() } else { step };
    let first = (lo / step - 1e-9).ceil() as i64;
    (first..).map(|k| k as f64 * step).take_while(|t| *t <= hi + 1e-9 * step).collect()
}

fn label(t: f64, axis: &Axis) -> String {
    if axis.logarithmic {
        format!("10<tspan dy=\"-5\" font-size=\"9\">{t:.0}</tspan>")
    } else {
        format!("{}", (t * 1e6).round() / 1e6)
    }
}
