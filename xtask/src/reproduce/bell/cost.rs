//! What a run costs: tables B.1 to B.3 and figures 5.25 to 5.32.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use landform::core::verb::MemoryOutput;
use landform::core::{Error, Result};
use landform::io::files::write_whole;
use landform::recipe::{Options, Override, Recipe};

use super::{column, find, power, sweep};

/// Nodes and seconds: table B.1.
const VERTICES: &[(usize, f64)] = &[
    (1018, 0.4431),
    (2032, 1.1508),
    (5040, 3.3412),
    (10035, 7.7410),
    (20031, 19.4900),
    (30014, 37.4151),
    (40014, 59.5623),
    (49986, 85.6297),
    (59934, 122.8690),
    (69849, 150.2990),
    (79808, 192.5560),
    (89870, 237.0460),
    (99927, 294.3030),
];
/// Side (m) and seconds: table B.2.
const SIDES: &[(f64, f64)] = &[
    (2048.0, 157.836),
    (4096.0, 91.0184),
    (8192.0, 48.6948),
    (16384.0, 35.4402),
    (32768.0, 36.4467),
    (65536.0, 38.5874),
    (131_072.0, 41.338),
];
/// Nodes, bytes and allocations: table B.3.
const MEMORY: &[(usize, u64, u64)] = &[
    (500, 33_462_903, 387_667),
    (1000, 36_425_015, 450_258),
    (1500, 46_554_519, 503_986),
    (2000, 48_662_059, 552_120),
    (2500, 51_636_259, 597_143),
    (3000, 53_573_035, 629_768),
    (3500, 55_868_207, 680_015),
    (4000, 57_514_099, 714_355),
    (4500, 76_192_635, 762_669),
    (5000, 77_449_311, 789_694),
    (5500, 79_175_155, 823_576),
    (6000, 81_481_551, 863_441),
];
/// The thesis' clock: steps of 250 kyr, until nothing moves much. It does not say how much; ours is
/// a thousandth of the uplift at every node.
const ITS_CLOCK: &str = "evolve.clock={ dt = \"250 kyr\", until = \"steady\", tolerance = 1e-3, iterations = 2000 }";

pub(super) fn vertices(root: &Path, _: &Path) -> Result<String> {
    let mut text = String::from(
        "## Table B.1, figure 5.25: time by nodes\n\n\
         Seconds on the wall of this machine, one run at a time, mesh included; the thesis' on an Intel Core i7 of 2.8 GHz, without. \
         First in its steps of 250 kyr, until no node moves by more than a thousandth of the uplift (its own criterion is not \
         given); then from coarse to fine, until it is steady to 1e-12 of the relief.\n\n\
         | nodes | thesis, s | ours in its steps, s | steps | coarse to fine, s | steps on the finest level |\n|---|---|---|---|---|---|\n",
    );
    let mut ours = Vec::new();
    for (nodes, seconds) in VERTICES {
        let size = format!("stream_graph.nodes={nodes}");
        let row = sweep(root, "many_nodes", 1, &[], &[size.clone(), ITS_CLOCK.into()])?.remove(0);
        let fine = sweep(root, "many_nodes", 1, &[], &[size])?.remove(0);
        let steps = |row: &landform::recipe::Row| row.outcome.map_or(0, |o| o.steps);
        let (own, finest) = (steps(&row), steps(&fine));
        let _ =
            writeln!(text, "| {nodes} | {seconds:.2} | {:.3} | {own} | {:.3} | {finest} |", row.seconds, fine.seconds);
        ours.push((*nodes as f64, row.seconds / own as f64));
    }
    let grows = |table: &[(f64, f64)]| power(table.iter().copied().filter(|r| r.0 > 20_000.0));
    let theirs: Vec<(f64, f64)> = VERTICES.iter().map(|&(n, s)| (n as f64, s)).collect();
    let _ = writeln!(
        text,
        "\nThe thesis calls its cost quadratic. From 20,031 nodes on its own seconds grow with the power {:.2}; a step of ours with {:.2}.\n",
        grows(&theirs),
        grows(&ours),
    );
    Ok(text)
}

pub(super) fn extents(root: &Path, _: &Path) -> Result<String> {
    let mut text = String::from(
        "## Table B.2, figure 5.30: time by extent\n\n\
         The thesis does not say for how many nodes; its seconds at 32,768 m are those of 30,014, which we take.\n\n\
         | side, m | thesis, s | ours in its steps, s | steps | highest point, m |\n|---|---|---|---|---|\n",
    );
    for (side, seconds) in SIDES {
        let fixed = [
            "stream_graph.nodes=30014".into(),
            format!("stream_graph.size=[\"{side} m\", \"{side} m\"]"),
            ITS_CLOCK.into(),
        ];
        let row = sweep(root, "many_nodes", 1, &[], &fixed)?.remove(0);
        let steps = row.outcome.map_or(0, |o| o.steps);
        let _ = writeln!(text, "| {side} | {seconds:.1} | {:.3} | {steps} | {:.0} |", row.seconds, row.summary.max);
    }
    Ok(text
        + "\nThe trends are opposite: there small ground takes longest, here it is steady first, because its slopes all reach the talus \
           angle. A lake costs the thesis' listing the more the more lakes there are, and, since children are moved after the receiver's \
           old elevation, lakes on small ground last; that would explain it, and is not proved.\n\n")
}

/// Lakes and seconds of every step of a run of so many nodes.
fn steps_of(root: &Path, nodes: usize) -> Result<(Vec<f64>, Vec<f64>)> {
    let text =
        find("convergence")?.text.replace(", animation = \"growth.gif\", steps = 15", ", seconds = true, steps = 1");
    let overrides = [Override::parse(&format!("stream_graph.nodes={nodes}"))?];
    let mut out = MemoryOutput::default();
    let gallery = root.join("crates/landform/gallery");
    Recipe::parse(&text, "convergence", &gallery, &overrides)?.run(&mut out, &Options::default())?;
    let csv = String::from_utf8_lossy(&out.0["steps.csv"]).into_owned();
    let seconds = column(&csv, "seconds");
    let each = seconds.windows(2).map(|w| w[1] - w[0]).collect();
    Ok((column(&csv, "lakes").into_iter().skip(1).collect(), each))
}

pub(super) fn iterations(root: &Path, folder: &Path) -> Result<String> {
    let mut text = String::from(
        "## Figures 5.26 to 5.29: what a step takes, and its lakes\n\n![](steps.svg)\n\n\
         Steps of 250 kyr; the first, which includes the mesh, is left out. The thesis does not say for which numbers of nodes.\n\n\
         | nodes | lakes after steps 2, 5, 10, 20 | first step without | step 2, ms | median of the last 100, ms |\n|---|---|---|---|---|\n",
    );
    let mut panels = Vec::new();
    for nodes in [10_000, 20_000, 100_000] {
        let (lakes, seconds) = steps_of(root, nodes)?;
        let without = lakes.iter().position(|l| *l == 0.0).map_or("none".into(), |k| (k + 2).to_string());
        let mut last: Vec<f64> = seconds[seconds.len() - 100..].to_vec();
        last.sort_by(f64::total_cmp);
        let _ = writeln!(
            text,
            "| {nodes} | {:.0}, {:.0}, {:.0}, {:.0} | {without} | {:.2} | {:.2} |",
            lakes[0],
            lakes[3],
            lakes[8],
            lakes[18],
            1e3 * seconds[0],
            1e3 * last[50],
        );
        panels.push((nodes, lakes, seconds));
    }
    write_whole(&folder.join("steps.svg"), panels_svg(&panels).as_bytes())?;
    Ok(text
        + "\nAs in the thesis a step takes longer while there are lakes. Its time grows as the square of their number there; here a step \
           with thousands of lakes takes a few times one with none.\n\n")
}

/// Three panels: seconds of every step, its lakes, and one against the other.
fn panels_svg(runs: &[(usize, Vec<f64>, Vec<f64>)]) -> String {
    const COLOURS: [&str; 3] = ["#1b6ca8", "#c0562f", "#3c7d3a"];
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"960\" height=\"330\" font-family=\"sans-serif\" font-size=\"12\">\
         <rect width=\"960\" height=\"330\" fill=\"white\"/>\n",
    );
    let numbered = |values: &[f64]| values.iter().enumerate().map(|(k, &v)| ((k + 2) as f64, v)).collect::<Vec<_>>();
    type Points<'a> = &'a dyn Fn(usize) -> Vec<(f64, f64)>;
    let panels: [(&str, &str, Points); 3] = [
        ("step", "ms a step", &|k| numbered(&runs[k].2.iter().map(|s| 1e3 * s).collect::<Vec<_>>())),
        ("step", "lakes", &|k| numbered(&runs[k].1)),
        ("lakes", "ms a step", &|k| runs[k].1.iter().zip(&runs[k].2).map(|(&l, s)| (l, 1e3 * s)).collect()),
    ];
    for (p, (x_label, y_label, points)) in panels.into_iter().enumerate() {
        let left = 60.0 + 315.0 * p as f64;
        let of = |f: &dyn Fn(&(f64, f64)) -> f64| (0..runs.len()).flat_map(points).map(|q| f(&q)).fold(1.0, f64::max);
        let (right, top) = if p < 2 { (60.0, of(&|q| q.1)) } else { (of(&|q| q.0), of(&|q| q.1)) };
        let at = |(x, y): (f64, f64)| (left + 230.0 * (x / right).min(1.0), 280.0 - 230.0 * y / top);
        let _ = writeln!(
            svg,
            "<path d=\"M{left} 50V280H{}\" fill=\"none\" stroke=\"#555\"/><text x=\"{left}\" y=\"40\">{y_label}, to {top:.0}</text>\
             <text x=\"{}\" y=\"300\" text-anchor=\"end\">{x_label}, to {right:.0}</text>",
            left + 230.0,
            left + 230.0,
        );
        for (k, run) in runs.iter().enumerate() {
            for (x, y) in points(k).into_iter().filter(|q| q.0 <= right).map(at) {
                let _ = write!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2\" fill=\"{}\"/>", COLOURS[k]);
            }
            if p == 0 {
                let _ = write!(
                    svg,
                    "<text x=\"{}\" y=\"{}\" fill=\"{}\">{} nodes</text>",
                    left + 130.0,
                    70 + 16 * k,
                    COLOURS[k],
                    run.0
                );
            }
            svg.push('\n');
        }
    }
    svg + "</svg>\n"
}

/// Allocations and bytes of a run, as valgrind counts them.
fn heap(program: &Path, recipe: &Path, nodes: usize) -> Result<(u64, u64)> {
    let run = Command::new("valgrind")
        .arg(program)
        .args(["run", "--quiet", "--no-cache", "--threads", "1", "--set"])
        .arg(format!("stream_graph.nodes={nodes}"))
        .args(["--set", "evolve.clock={ dt = \"250 kyr\", until = \"steady\", tolerance = 1e-3, iterations = 200 }"])
        .arg(recipe)
        .arg("-o")
        .arg(std::env::temp_dir().join("landform-memory"))
        .output()
        .map_err(|e| Error::io("run valgrind on", program, e))?;
    let log = String::from_utf8_lossy(&run.stderr).into_owned();
    let usage = log.lines().find_map(|l| l.split("total heap usage:").nth(1)).unwrap_or_default().replace(',', "");
    let words: Vec<&str> = usage.split_whitespace().collect();
    let number = |word: &str| words.windows(2).find(|w| w[1] == word)?[0].parse::<u64>().ok();
    match (number("allocs"), number("bytes")) {
        (Some(allocations), Some(bytes)) => Ok((allocations, bytes)),
        _ => Err(Error::parameter("valgrind", log, "a line of total heap usage")),
    }
}

pub(super) fn memory(root: &Path, _: &Path) -> Result<String> {
    let built = Command::new("cargo").args(["build", "--release", "--quiet", "-p", "landform-cli"]).status();
    if !built.is_ok_and(|s| s.success()) {
        return Err(Error::parameter("landform-cli", "that does not build", "one that does"));
    }
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), Into::into);
    let recipe = std::env::temp_dir().join("landform-memory.toml");
    let lines = find("convergence")?.text.lines().filter(|l| !l.starts_with("watch"));
    let unwatched = lines.fold(String::new(), |text, line| text + line + "\n");
    write_whole(&recipe, unwatched.as_bytes())?;
    let mut text = String::from(
        "## Table B.3, figures 5.31, 5.32: memory\n\n\
         Valgrind's *total heap usage*, as in the thesis: the sum of all that is ever allocated, for up to 200 steps of 250 kyr, program included.\n\n\
         | nodes | thesis, bytes | ours, bytes | thesis, allocations | ours, allocations |\n|---|---|---|---|---|\n",
    );
    let mut ours = Vec::new();
    for &(nodes, bytes, allocations) in MEMORY {
        let (own_allocations, own_bytes) = heap(&target.join("release/landform"), &recipe, nodes)?;
        let _ = writeln!(text, "| {nodes} | {bytes} | {own_bytes} | {allocations} | {own_allocations} |");
        ours.push((nodes as f64, own_bytes as f64));
    }
    let line = |points: &[(f64, f64)]| landform::core::math::line_fit(points.iter().copied());
    let theirs: Vec<(f64, f64)> = MEMORY.iter().map(|r| (r.0 as f64, r.1 as f64)).collect();
    let ((own, _, own_r2), (its, _, its_r2)) = (line(&ours), line(&theirs));
    let _ = writeln!(
        text,
        "\nBoth grow in proportion to the nodes: {own:.0} bytes a node (R2 {own_r2:.3}) beside {its:.0} (R2 {its_r2:.3}).\n"
    );
    Ok(text)
}
