//! Small plots as SVG.

use std::fmt::Write;

use landform_core::math;

use super::page::escape;

const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 330.0;
const LEFT: f64 = 66.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 30.0;
const BOTTOM: f64 = 46.0;

/// An axis; a logarithmic one takes decimal logarithms and labels powers of ten.
pub(super) struct Axis {
    pub(super) label: &'static str,
    pub(super) logarithmic: bool,
}

/// An axis of plain numbers.
pub(super) fn linear(label: &'static str) -> Axis {
    Axis { label, logarithmic: false }
}

/// An axis of decimal logarithms.
pub(super) fn logarithmic(label: &'static str) -> Axis {
    Axis { label, logarithmic: true }
}

/// How points are drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// Joined.
    Line,
    /// Joined by dashes: a model.
    Dashed,
    /// Dots.
    Dots,
    /// Bars from zero.
    Bars,
}

/// Points of one kind.
pub(super) struct Series {
    pub(super) label: String,
    pub(super) style: Style,
    pub(super) points: Vec<(f64, f64)>,
}

/// Points without a line in the legend.
pub(super) fn unnamed(style: Style, points: Vec<(f64, f64)>) -> Series {
    Series { label: String::new(), style, points }
}

/// A plot.
pub(super) struct Plot {
    pub(super) title: &'static str,
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) series: Vec<Series>,
}

/// From values to pixels.
struct Frame {
    x: (f64, f64),
    y: (f64, f64),
}

impl Frame {
    fn px(&self, x: f64) -> f64 {
        LEFT + (x - self.x.0) / (self.x.1 - self.x.0) * (WIDTH - LEFT - RIGHT)
    }

    fn py(&self, y: f64) -> f64 {
        HEIGHT - BOTTOM - (y - self.y.0) / (self.y.1 - self.y.0) * (HEIGHT - TOP - BOTTOM)
    }
}

impl Plot {
    /// The plot, or nothing where there is nothing to show.
    pub(super) fn svg(&self) -> String {
        let finite = |p: &&(f64, f64)| p.0.is_finite() && p.1.is_finite();
        let all = || self.series.iter().flat_map(|s| s.points.iter()).filter(finite);
        if all().next().is_none() {
            return String::new();
        }
        let mut frame = Frame { x: bounds(all().map(|p| p.0)), y: bounds(all().map(|p| p.1)) };
        if self.series.iter().any(|s| s.style == Style::Bars) {
            frame.y.0 = 0.0;
        }
        let mut svg = format!(
            "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" role=\"img\" aria-label=\"{}\">",
            self.title
        );
        self.draw_axes(&frame, &mut svg);
        for (k, series) in self.series.iter().enumerate() {
            let points: Vec<_> = series.points.iter().filter(finite).map(|p| (frame.px(p.0), frame.py(p.1))).collect();
            draw(series.style, k % 3, &points, &frame, &mut svg);
        }
        self.draw_legend(&frame, &mut svg);
        svg + "</svg>"
    }

    fn draw_axes(&self, frame: &Frame, svg: &mut String) {
        let (bottom, right) = (HEIGHT - BOTTOM, WIDTH - RIGHT);
        for t in ticks(frame.x.0, frame.x.1, self.x.logarithmic) {
            let x = frame.px(t);
            write!(svg, "<line class=\"grid\" x1=\"{x:.1}\" y1=\"{TOP}\" x2=\"{x:.1}\" y2=\"{bottom}\"/>").ok();
            let text = label(t, &self.x);
            write!(svg, "<text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{text}</text>", bottom + 16.0).ok();
        }
        for t in ticks(frame.y.0, frame.y.1, self.y.logarithmic) {
            let y = frame.py(t);
            write!(svg, "<line class=\"grid\" x1=\"{LEFT}\" y1=\"{y:.1}\" x2=\"{right}\" y2=\"{y:.1}\"/>").ok();
            let text = label(t, &self.y);
            write!(svg, "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>", LEFT - 6.0, y + 4.0).ok();
        }
        write!(svg, "<path class=\"axis\" d=\"M{LEFT} {TOP}V{bottom}H{right}\"/>").ok();
        let (middle_x, middle_y) = ((LEFT + right) / 2.0, (TOP + bottom) / 2.0);
        write!(svg, "<text class=\"name\" x=\"{middle_x}\" y=\"18\" text-anchor=\"middle\">{}</text>", self.title).ok();
        write!(svg, "<text x=\"{middle_x}\" y=\"{}\" text-anchor=\"middle\">{}</text>", HEIGHT - 8.0, self.x.label)
            .ok();
        let turned = format!("translate(14 {middle_y}) rotate(-90)");
        write!(svg, "<text transform=\"{turned}\" text-anchor=\"middle\">{}</text>", self.y.label).ok();
    }

    /// In the upper right corner, or in the lower one where the curves rise into the upper.
    fn draw_legend(&self, frame: &Frame, svg: &mut String) {
        let named: Vec<_> = self.series.iter().enumerate().filter(|(_, s)| !s.label.is_empty()).collect();
        let right = self.series.iter().flat_map(|s| &s.points).filter(|p| p.0 > 0.4 * frame.x.0 + 0.6 * frame.x.1);
        let (mut sum, mut count) = (0.0, 0.0);
        for p in right.filter(|p| p.1.is_finite()) {
            (sum, count) = (sum + frame.py(p.1), count + 1.0);
        }
        let is_low = count > 0.0 && sum / count > 0.5 * (TOP + HEIGHT - BOTTOM);
        let top = if is_low { TOP + 14.0 } else { HEIGHT - BOTTOM + 4.0 - 16.0 * named.len() as f64 };
        let x = WIDTH - RIGHT - 8.0;
        for (line, (k, series)) in named.into_iter().enumerate() {
            let (y, k) = (top + 16.0 * line as f64, k % 3);
            match series.style {
                Style::Dots => {
                    write!(svg, "<circle class=\"mark s{k}\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"3\"/>", x - 8.0, y - 4.0)
                        .ok();
                }
                style => {
                    let class = if style == Style::Bars { "mark" } else { "line" };
                    let dash = if style == Style::Dashed { " dashed" } else { "" };
                    write!(svg, "<path class=\"{class} s{k}{dash}\" d=\"M{:.1} {:.1}h16\"/>", x - 16.0, y - 4.0).ok();
                }
            }
            write!(
                svg,
                "<text x=\"{:.1}\" y=\"{y:.1}\" text-anchor=\"end\">{}</text>",
                x - 22.0,
                escape(&series.label)
            )
            .ok();
        }
    }
}

fn draw(style: Style, k: usize, points: &[(f64, f64)], frame: &Frame, svg: &mut String) {
    match style {
        Style::Line | Style::Dashed => {
            let path: Vec<String> = points.iter().map(|p| format!("{:.1} {:.1}", p.0, p.1)).collect();
            let dash = if style == Style::Dashed { " dashed" } else { "" };
            write!(svg, "<path class=\"line s{k}{dash}\" d=\"M{}\"/>", path.join("L")).ok();
        }
        Style::Dots => {
            let radius = if points.len() > 200 { 1.3 } else { 3.0 };
            for p in points {
                write!(svg, "<circle class=\"mark s{k}\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"{radius}\"/>", p.0, p.1).ok();
            }
        }
        Style::Bars => {
            let width = points.windows(2).map(|w| w[1].0 - w[0].0).fold(f64::INFINITY, f64::min).clamp(2.0, 40.0) * 0.8;
            for p in points {
                let (x, height) = (p.0 - 0.5 * width, frame.py(0.0) - p.1);
                write!(
                    svg,
                    "<rect class=\"mark s{k}\" x=\"{x:.1}\" y=\"{:.1}\" width=\"{width:.1}\" height=\"{height:.1}\"/>",
                    p.1
                )
                .ok();
            }
        }
    }
}

fn bounds(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (lo, hi) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    if hi > lo { (lo, hi) } else { (lo - 0.5, hi + 0.5) }
}

/// About five round values within bounds; whole powers of ten on a logarithmic axis.
fn ticks(lo: f64, hi: f64, logarithmic: bool) -> Vec<f64> {
    let rough = (hi - lo) / 5.0;
    let decade = math::pow(10.0, math::log10(rough).floor());
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

/// A range as a bar with a mark for the value: the bar spans the middle half.
pub(super) fn gauge(range: [f64; 2], value: f64, inside: Option<bool>) -> String {
    const W: f64 = 150.0;
    let (lo, hi) = (0.25 * W, 0.75 * W);
    let class = match inside {
        Some(true) => "inside",
        Some(false) => "outside",
        None => return String::new(),
    };
    let x = (lo + (value - range[0]) / (range[1] - range[0]) * (hi - lo)).clamp(4.0, W - 4.0);
    format!(
        "<svg class=\"gauge\" viewBox=\"0 0 {W} 16\" width=\"{W}\" height=\"16\" aria-hidden=\"true\"><line class=\"grid\" x1=\"0\" y1=\"8\" x2=\"{W}\" y2=\"8\"/><rect class=\"span\" x=\"{lo}\" y=\"4\" width=\"{}\" height=\"8\"/><circle class=\"{class}\" cx=\"{x:.1}\" cy=\"8\" r=\"5\"/></svg>",
        hi - lo
    )
}
