//! The frame of the page.

const STYLE: &str = "
:root{color-scheme:light dark;--ink:#22262a;--paper:#fbfaf8;--faint:#8a8f94;--line:#dcd9d3;--accent:#2f67a1;--second:#b4552d;--good:#2e7048;--bad:#b23a2c}
@media (prefers-color-scheme:dark){:root{--ink:#e3e1dc;--paper:#1b1d20;--faint:#8f949a;--line:#3a3d41;--accent:#7fb0de;--second:#e0936a;--good:#7fc79b;--bad:#ee8a7c}}
@media print{:root{--ink:#000;--paper:#fff;--faint:#555;--line:#ccc}figure,svg{break-inside:avoid}}
body{font:16px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:1100px;margin:2rem auto;padding:0 1rem}
h1{font-size:1.7rem;margin:0 0 1rem}h2{font-size:1.15rem;margin:2rem 0 .6rem}
figure{margin:0 0 1rem}img{max-width:100%;height:auto;border-radius:4px}figcaption{color:var(--faint);font-size:.85rem}
table{border-collapse:collapse}td{padding:.2rem 1.2rem .2rem 0;border-bottom:1px solid var(--line)}
td:nth-child(2){text-align:right;font-variant-numeric:tabular-nums}td:nth-child(3){color:var(--faint)}
code{font-size:.8rem;color:var(--faint);overflow-wrap:anywhere}.plots{display:flex;flex-wrap:wrap;gap:1.5rem}
svg text{fill:var(--ink);font:12px system-ui,sans-serif;paint-order:stroke;stroke:var(--paper);stroke-width:3px}svg .axis{stroke:var(--faint);fill:none}svg .grid{stroke:var(--line)}
svg .name{font-weight:600}svg .mark{fill:var(--accent)}svg .line{stroke:var(--accent);stroke-width:2;fill:none}
svg .mark.s1{fill:var(--second)}svg .line.s1{stroke:var(--second)}svg .mark.s2{fill:var(--faint)}svg .line.s2{stroke:var(--faint)}
svg .dashed{stroke-dasharray:6 4}svg{max-width:100%;height:auto}.plots>*{flex:0 1 auto}.plots figure{max-width:520px}.plots>table{flex:1 1 420px;max-width:580px;align-self:flex-start}.plots>svg{align-self:flex-start}.plots td:nth-child(2){white-space:nowrap}
.scroll{overflow-x:auto}.card th{text-align:left;padding:.2rem 1.2rem .2rem 0;border-bottom:2px solid var(--line);font-size:.85rem}
.card td{vertical-align:top}.card td:nth-child(2){text-align:left}.card td:nth-child(3){color:inherit}.n{font-variant-numeric:tabular-nums;white-space:nowrap}
.note{color:var(--faint);font-size:.85rem}.verdict{font-size:1.1rem;border-left:4px solid var(--accent);padding:.2rem 0 .2rem .8rem}
.gauge{vertical-align:middle;margin-right:.5rem}.gauge .span{fill:var(--line)}.gauge .inside{fill:var(--good)}.gauge .outside{fill:var(--bad)}
span.inside,.card td.inside{color:var(--good)}span.outside,.card td.outside{color:var(--bad);font-weight:600}span.none{color:var(--faint)}.sources{font-size:.85rem}";

pub(super) fn page(title: &str, body: &str) -> String {
    let title = escape(title);
    format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\
         <title>{title}</title><style>{STYLE}</style></head><body><h1>{title}</h1>{body}</body></html>\n"
    )
}

pub(super) fn table(rows: &[String]) -> String {
    format!("<table>{}</table>", rows.concat())
}

pub(super) fn row(name: &str, value: &str, unit: &str) -> String {
    // What could not be measured.
    let known = |text: &str| escape(&text.replace("NaN", "–"));
    format!("<tr><td>{}</td><td>{}</td><td>{}</td></tr>", escape(name), known(value), known(unit))
}

pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
