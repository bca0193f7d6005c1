//! The history of a landscape, and the papers behind it.

use landform_core::units::YEAR;
use landform_core::verb::{Event, Outcome};

use super::page::escape;

/// The stages in turn; nothing for ground from a file alone.
pub(super) fn section(events: &[Event], seed: u64) -> String {
    if events.is_empty() {
        return String::new();
    }
    let mut items = String::new();
    for event in events {
        let outcome = event.outcome.as_ref().map(outcome_text).unwrap_or_default();
        items +=
            &format!("<li><b>{}</b> <code>{}</code>{outcome}</li>", escape(&event.stage), escape(&event.parameters));
    }
    format!("<h2>How it came to be</h2><p>Seed {seed}, landform {}.</p><ol>{items}</ol>", env!("CARGO_PKG_VERSION"))
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

/// The papers behind the stages, then those behind the measures.
pub(super) fn sources(events: &[Event], measures: &[&str]) -> String {
    let mut seen: Vec<&[String; 3]> = Vec::new();
    for source in events.iter().flat_map(|e| &e.sources) {
        if !seen.contains(&source) {
            seen.push(source);
        }
    }
    let items: String = seen
        .iter()
        .map(|[authors, title, doi]| format!("<li>{}: {}. {}</li>", escape(authors), escape(title), escape(doi)))
        .chain(measures.iter().map(|s| format!("<li>{}</li>", escape(s))))
        .collect();
    format!("<h2>Sources</h2><ul class=\"sources\">{items}</ul>")
}
