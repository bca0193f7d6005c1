//! Rivers of two theses: their figures, how transports gather water, and how long the theses' runs
//! take.

use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use landform::core::field::names;
use landform::core::verb::MemoryOutput;
use landform::core::{Error, Result};
use landform::recipe::{AnyTerrain, Options, Outputs, Ran, Recipe};

use super::self_organised::{Figure, Page, nothing};

pub(super) const PYTEL_RIVERS: Page = Page {
    folder: "docs/pytel",
    file: "rivers.md",
    head: "# Pytel's thesis, sections 4.3, 4.4 and A.2: rivers and two-stage terrains, reproduced

Written by `cargo xtask reproduce pytel-rivers`. Cells are 10 m wide unless a recipe says otherwise (the thesis gives no unit). Weights are those of tables 4.6 and 4.7; what the thesis does not give (the scale of f, its
time step, initial ground) was chosen by looking, see the docs of `channel_erosion`. Water moves all its way within a round here, by one neighbour there. Seconds of recipes include their pictures and measures, on one thread; table
4.9 at the end is without.

",
    figures: &[
        Figure { title: "Figure 4.12 (a): rain on folds", recipe: "drained_folds", pictures: &["before", "after", "map"], measures: &["before_hypsometry", "after_hypsometry", ""], what: "w = 1, 2, 0.5, 10, 3, 1.5. Troughs are worn into wide floors, the larger ones with a river that leaves over the nearest side; a lake still stands. The thesis has rivers that cut through the folds, and a curve that is not significantly altered: w_0 acts in every round, and the unit of f is not given there." },
        Figure { title: "Figures 4.12 (b), 4.18 and 4.19: four transports", recipe: "four_transports", pictures: &["columns_runs", "average_runs", "weighted_average_runs", "pipes_runs"], measures: &[], what: "Water of one spring without erosion, logarithm of the discharge. Numbers are in the table below." },
        Figure { title: "The same with erosion", recipe: "four_transports", pictures: &["columns_cuts", "average_cuts", "weighted_average_cuts", "pipes_cuts"], measures: &[], what: "w = 2, 1, 1, 10, 3, 0 (figure 4.12 b)." },
        Figure { title: "Figure 4.12 (c): around an obstacle", recipe: "around_an_obstacle", pictures: &["before", "river", "map"], measures: &["before_hypsometry", "after_hypsometry", ""], what: "w = 2.5, 1.5, 0.5, 5, 3, 0.5. Flow parts at the hill and meets again near the lower border; the eastern arm takes most; the hypsometric curve stays." },
        Figure { title: "Figure 4.13: rain on fractional Brownian motion", recipe: "rain_on_fbm", pictures: &["before", "after", "map"], measures: &["before_spectrum+before_hypsometry", "after_spectrum+after_hypsometry", ""], what: "The hypsometric curve stays, as the thesis says, and so do waves longer than some 600 m, within a fifth. Valleys add up to three times the power between 100 and 400 m (the exponent of long waves is fitted down to 227 m), and channels smooth what is shorter." },
        Figure { title: "Figure 4.14: capture", recipe: "capture", pictures: &["river", "discharge"], measures: &[], what: "The recipe also writes the sequence as capture.gif." },
        Figure { title: "Figure 4.14: a lake breaks through", recipe: "a_lake_breaks_through", pictures: &["after"], measures: &[], what: "The recipe also writes the sequence as lake.gif." },
        Figure { title: "Figure 4.15 and table 4.7: two modes", recipe: "modes_of_valleys", pictures: &["diffusion", "advection", "diffusion_map", "advection_map"], measures: &["diffusion_hypsometry", "advection_hypsometry", "", ""], what: "Smoothing wins (a) or cutting wins (b); smoothing is everywhere (Eq. 4.6). The thesis gives no unit of flow: it is 1/300 of the map's water in (a), 1/50 000 in (b)." },
        Figure { title: "Figure 4.16: between level sets", recipe: "between_level_sets", pictures: &["nearest", "hermite", "variational"], measures: &["nearest_surface+nearest_hypsometry+nearest_spectrum", "hermite_surface+hermite_hypsometry+hermite_spectrum", "variational_surface+variational_hypsometry+variational_spectrum"], what: "The thesis' relaxation takes away 43.67 % of the bending energy of its second row; ours goes on to the least that the level sets allow, from the second column to the third. By eye the first two are alike." },
        Figure { title: "Figure 4.17: two stages", recipe: "two_stage_rivers", pictures: &["stage_one", "rivers", "map"], measures: &["", "hypsometry+spectrum", ""], what: "Fronts from painted lines; then rivers, and lakes that broke through in the east." },
        Figure { title: "Figure 4.20: rain on a hill of sand", recipe: "sand_hill", pictures: &["hill"], measures: &[], what: "Cells of 25 cm." },
        Figure { title: "Figure 4.25: ground at the threshold of erosion", recipe: "threshold_basin", pictures: &["ends", "ends_area", "overflows", "overflows_area"], measures: &["ends", "", "overflows", ""], what: "Rodriguez-Iturbe & Rinaldo on fractional Brownian motion: most large rivers end in depressions, as in the thesis, or depressions overflow." },
        Figure { title: "Its limit: networks of least energy", recipe: "optimal_network", pictures: &["network", "area"], measures: &["network", ""], what: "In the nature of rivers β is about 0.43 and h 0.57." },
        Figure { title: "Poster of 2013, and appendix A.2: a confluence", recipe: "confluence", pictures: &["confluence", "map"], measures: &[], what: "Water is a surface over the ground; rivers widen as they meet." },
        Figure { title: "Beyond the thesis: fans", recipe: "alluvial_fans", pictures: &["fans", "laid", "map"], measures: &[], what: "With `graded_slope` what is cut is carried and laid down. The second picture shows how much was laid down (green to white) or worn away (blue): most at the two mouths." },
        Figure { title: "Beyond the thesis: rivers fill a lake", recipe: "delta", pictures: &["view", "laid", "map"], measures: &[], what: "Standing water takes the load. The second picture shows how much was laid down (green to white) or worn away (blue)." },
    ],
    tail: tables,
};

pub(super) const KOH_STREAMS: Page = Page {
    folder: "docs/koh",
    file: "streams.md",
    head: "# Koh's thesis, section 5.1: streams by an automaton, reproduced

Written by `cargo xtask reproduce koh-streams`. The thesis has pictures and no numbers; its ground is diamond-square noise, as here. Every cell begins with a drop, each drop goes to the lowest neighbour, takes a little of the
ground along, and is swallowed in pits; a drop that would go back and forth between two cells is swallowed too.

",
    figures: &[
        Figure { title: "Figures 1, 2 and 9 to 11: ground, one pass, ten", recipe: "koh_streams", pictures: &["start", "one", "many"], measures: &[], what: "Gullies run together in trees; more passes deepen them." },
        Figure { title: "Figures 12 and 13: the softness map", recipe: "koh_streams", pictures: &["face", "visits"], measures: &[], what: "How deep level, rough ground was worn: a face with a smile, where it is soft. Beside it the drops that crossed each cell." },
    ],
    tail: nothing,
};

fn tables() -> Result<String> {
    Ok(format!("{}\n{}", transports()?, seconds()?))
}

/// A slope of 128 x 256 cells with noise on it; rain on all of it.
fn slope(transport: &str, rounds: u32, [cols, rows]: [u32; 2], more: &str) -> String {
    format!(
        "seed = 5\n[[stage]]\nuse = \"surface\"\nsize = [\"{cols}0 m\", \"{rows}0 m\"]\ncell_size = \"10 m\"\n\
         elevation = {{ formula = \"0.2*y\", unit = \"m\" }}\n\
         [[stage]]\nuse = \"blend\"\nlayer = {{ use = \"spectral_fbm\", deviation = \"3 m\", hurst = 0.5 }}\n\
         [[stage]]\nuse = \"channel_erosion\"\ntransport = \"{transport}\"\niterations = {rounds}\noutlets = [\"south\"]\n{more}"
    )
}

fn run(text: &str) -> Result<(Arc<AnyTerrain>, f64)> {
    let recipe = Recipe::parse(text, "a run", Path::new("."), &[])?;
    let begun = Instant::now();
    let quiet = Options { outputs: Outputs::Nothing, ..Options::default() };
    let Ran::ToTheEnd(terrain, _) = recipe.run(&mut MemoryOutput::default(), &quiet)? else {
        return Err(Error::Empty { what: "the run".into() });
    };
    Ok((terrain, begun.elapsed().as_secs_f64()))
}

/// How unevenly each row's flow is shared among its nodes: Gini's coefficient, in the mean of rows.
fn gini(flow: &[f64], cols: usize) -> f64 {
    let rows: Vec<f64> = flow
        .chunks(cols)
        .filter_map(|row| {
            let mut q = row.to_vec();
            q.sort_by(f64::total_cmp);
            let total: f64 = q.iter().sum();
            let ranked: f64 = q.iter().enumerate().map(|(k, v)| (2.0 * (k as f64 + 1.0) - cols as f64 - 1.0) * v).sum();
            (total > 0.0).then(|| ranked / (cols as f64 * total))
        })
        .collect();
    rows.iter().sum::<f64>() / rows.len() as f64
}

fn transports() -> Result<String> {
    let mut text = String::from(
        "## How transports gather water\n\nRain on a rough slope of 128 x 256 cells, no erosion. Gini's coefficient of the flow along a row: 0 if all nodes have the same, 1 if one has all. \
         Rounds: 1, pipes 40 of 20 steps. \
         Area maps, which move no water, gather most; of the transports that move it columns do, as in the thesis. Pipes come next: their thin sheet of a short storm runs in every groove.\n\n| transport | Gini | largest share of a row's flow |\n|---|---|---|\n",
    );
    let still = "avalanche_weight = 0.0\nflow_weight = 0.0\ndiffusion_weight = 0.0\nadvection_weight = 0.0\nbase_weight = 0.0\n";
    for transport in ["columns", "area_map", "weighted_average", "average", "pipes"] {
        let rounds = if transport == "pipes" { 40 } else { 1 };
        let (terrain, _) = run(&slope(transport, rounds, [128, 256], still))?;
        let AnyTerrain::HeightField(field) = &*terrain else { continue };
        let flow = field.fields.get(&names::DISCHARGE, "the flow")?;
        let cols = field.grid().shape.cols;
        let shares: Vec<f64> = flow
            .chunks(cols)
            .map(|row| row.iter().copied().fold(0.0, f64::max) / row.iter().sum::<f64>().max(1e-30))
            .collect();
        let share = shares.iter().sum::<f64>() / shares.len() as f64;
        writeln!(text, "| {transport} | {:.3} | {:.1} % |", gini(flow, cols), 100.0 * share).ok();
    }
    Ok(text)
}

fn seconds() -> Result<String> {
    let mut text = String::from(
        "## Table 4.9: seconds\n\nAs many rounds as the thesis' figures had, of the default weights on the same slope, and both stages; with the making of the ground, without pictures, on all cores of the machine that wrote the page, one run.\n\n\
         | run | grid | rounds | thesis | here |\n|---|---|---|---|---|\n",
    );
    for (what, rounds, theirs) in
        [("4.12 (a)", 300, "4 m 27 s"), ("4.12 (b)", 450, "8 m 6 s"), ("4.12 (c)", 450, "7 m 27 s")]
    {
        let (_, took) = run(&slope("columns", rounds, [128, 256], ""))?;
        writeln!(text, "| {what} | 128 x 256 | {rounds} | {theirs} | {took:.2} s |").ok();
    }
    for (what, rounds, theirs) in
        [("4.17 (first)", 50, "2 m 0 s + 3 m 51 s"), ("4.17 (third)", 150, "2 m 36 s + 8 m 13 s")]
    {
        let two = format!(
            "seed = 5\n[[stage]]\nuse = \"front_terrain\"\nmask = {{ formula = \"abs(x - 1280) < 30\" }}\nsize = [\"2560 m\", \"2560 m\"]\n\
             cell_size = \"10 m\"\n[[stage]]\nuse = \"channel_erosion\"\niterations = {rounds}\n"
        );
        let (_, took) = run(&two)?;
        writeln!(text, "| {what} | 256 x 256 | {rounds} | {theirs} | {took:.2} s |").ok();
    }
    Ok(text)
}
