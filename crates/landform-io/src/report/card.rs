//! The report card.

use landform_core::analysis::CardLine;

use super::Analysis;
use super::page::escape;
use super::plot::gauge;

/// Verdict and lines.
pub(super) fn section(analysis: &Analysis) -> String {
    let lines: String = analysis.card.iter().map(line).collect();
    format!(
        "<h2>Report card</h2><p class=\"verdict\"><b>{}.</b> {}</p>\
         <div class=\"scroll\"><table class=\"card\"><thead><tr><th>Measure</th><th>Here</th><th>On real ground</th><th></th><th>What it means</th></tr></thead><tbody>{lines}</tbody></table></div>\
         <p class=\"note\">Bars span the natural range. Measures marked ◆ tell eroded ground from noise and make the verdict; the others are for reading. Ranges: least and greatest value over real elevation models with cells of 10 m to 200 m; a small sample, no law.</p>",
        escape(&analysis.verdict.title),
        escape(&analysis.verdict.reason),
    )
}

fn line(l: &CardLine) -> String {
    let (word, class) = match l.inside {
        Some(true) => ("inside", "inside"),
        Some(false) => ("outside", "outside"),
        None => ("not measured", "none"),
    };
    let mark = if l.decides { " ◆" } else { "" };
    let value = if l.value.is_finite() { short(l.value) } else { "–".into() };
    format!(
        "<tr><td>{}{mark}</td><td class=\"n\">{value}</td><td class=\"n\">{} – {}<br><span class=\"note\">{}</span></td><td>{}<span class=\"{class}\">{word}</span></td><td>{}</td></tr>",
        escape(&l.name),
        short(l.natural[0]),
        short(l.natural[1]),
        escape(&l.source),
        gauge(l.natural, l.value, l.inside),
        escape(&l.meaning)
    )
}

/// Three digits or so.
pub(super) fn short(v: f64) -> String {
    let digits = match v.abs() {
        0.0 => 0,
        a if a < 0.01 => 4,
        a if a < 10.0 => 3,
        a if a < 100.0 => 1,
        _ => 0,
    };
    let text = format!("{v:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
}
