use super::*;
use std::path::Path;

const NOISE: &str = r#"
seed = 7
[[stage]]
use = "noise"
grid = { size = ["640 m", "640 m"], cell_size = "20 m" }
elevation = "0 m"
amplitude = "100 m"
wavelength = "400 m"
[[stage]]
use = "measure_hypsometry"
"#;

fn fit(over: &[&str], column: &str, aim: Aim, runs: usize) -> Fit {
    let over = over.iter().map(|text| Span::parse(text).unwrap()).collect();
    Fit { over, column: column.into(), aim, runs, seed: None }
}

fn run(fit: &Fit) -> Result<Fitted> {
    let load = |set: &[Override]| Recipe::parse(NOISE, "noise", Path::new("."), set);
    fit.run(load, None, &CancelToken::default(), |_, _, _| {})
}

#[test]
fn bisection_finds_a_known_root() {
    // Slopes grow in proportion to the amplitude.
    let at = |amplitude: &str| {
        let one = fit(&[&format!("noise.amplitude={amplitude} m..1000 m")], "median_slope", Aim::Least, 1);
        run(&one).unwrap().value.unwrap()
    };
    let target = at("100");
    let fit = fit(&["noise.amplitude=40 m..310 m"], "median_slope", Aim::Target(target), 30);
    let found = run(&fit).unwrap();
    assert!(found.is_reached && found.rows.len() < 16, "{} runs", found.rows.len());
    let row = &found.rows[found.best.unwrap()];
    let amplitude: f64 = row.values[0].trim_end_matches(" m").parse().unwrap();
    assert!((amplitude - 100.0).abs() < 0.3, "{amplitude}");
    assert!(found.failure.is_none());
    assert_eq!(found.set.unwrap(), format!("--set \"noise.amplitude={amplitude} m\""));
    let again = run(&fit).unwrap();
    assert_eq!(again.table, found.table);
}

#[test]
fn a_hump_is_climbed_by_golden_sections() {
    let mut places = Vec::new();
    let mut probe = |at: &[f64]| {
        places.push(at[0]);
        (places.len() <= 30).then(|| -(at[0] - 0.62) * (at[0] - 0.62))
    };
    search::search(1, Aim::Most, &mut probe);
    assert!((places[29] - 0.62).abs() < 1e-3, "{places:?}");
}

#[test]
fn a_target_between_inner_places_is_found_though_both_ends_lie_above() {
    let (mut best, mut count) = (f64::INFINITY, 0);
    let mut probe = |at: &[f64]| {
        let value = 4.0 * (at[0] - 0.5) * (at[0] - 0.5);
        best = best.min((value - 0.1).abs());
        count += 1;
        (count <= 40).then_some(value)
    };
    search::search(1, Aim::Target(0.1), &mut probe);
    assert!(best < 1e-4, "{best}");
}

#[test]
fn two_to_four_keys_close_in_on_the_least() {
    for axes in 2..=4 {
        let (mut least, mut count) = (f64::INFINITY, 0);
        let mut probe = |at: &[f64]| {
            let value: f64 = at.iter().enumerate().map(|(k, v)| v - 0.3 - 0.1 * k as f64).map(|d| d * d).sum();
            least = least.min(value);
            count += 1;
            (count <= 60 * axes).then_some(value)
        };
        search::search(axes, Aim::Least, &mut probe);
        assert!(least < 1e-4, "{axes} keys: {least}");
    }
}

#[test]
fn two_keys_improve() {
    let over = ["noise.amplitude=20 m..500 m", "noise.hurst=0.3..1"];
    let first = fit(&over, "max_slope", Aim::Target(1.0), 3);
    let more = Fit { runs: 40, ..first.clone() };
    let misfit = |fit: &Fit| (run(fit).unwrap().value.unwrap() - 1.0).abs();
    let (before, after) = (misfit(&first), misfit(&more));
    assert!(after < 0.25 * before && after < 0.02, "{before} to {after}");
}

#[test]
fn whole_numbers_stay_whole() {
    let fit = fit(&["noise.octaves=1..6"], "median_slope", Aim::Most, 12);
    let found = run(&fit).unwrap();
    assert!(found.failure.is_none() && found.rows.len() <= 6, "{}", found.table);
}

#[test]
fn a_number_that_is_null_in_some_runs_is_a_column() {
    let recipe = NOISE.replace("640 m", "2560 m") + "[[stage]]\nuse = \"measure_coast\"\n";
    let load = |set: &[Override]| Recipe::parse(&recipe, "noise", Path::new("."), set);
    // The sea alone, but for the last place.
    let mut fit = fit(&["noise.elevation=-2000 m..0 m"], "measure_coast.boxes.dimension", Aim::Most, 6);
    let found = fit.run(load, None, &CancelToken::default(), |_, _, _| {}).unwrap();
    assert!(found.value.is_some_and(|d| d > 0.9), "{:?}", found.value);
    fit.column = "measure_coast.divider.dimension".into();
    let none = fit.run(load, None, &CancelToken::default(), |_, _, _| {}).unwrap();
    assert!(none.failure.unwrap().to_string().contains("no number"));
    assert!(!none.table.contains("divider.dimension"));
}

#[test]
fn what_cannot_be_is_told() {
    let told = |fit: &Fit| run(fit).unwrap_err().to_string();
    let amplitude = ["noise.amplitude=40 m..300 m"];
    let error = told(&fit(&amplitude, "median_slop", Aim::Least, 5));
    assert!(error.contains("`median_slope`?"), "{error}");
    assert!(told(&fit(&["noise.amplitud=1 m..2 m"], "lakes", Aim::Least, 5)).contains("amplitud"));
    assert!(told(&fit(&["noise.hurst=0.5..3"], "lakes", Aim::Least, 5)).contains("hurst"));
    assert!(told(&fit(&[amplitude[0], amplitude[0]], "lakes", Aim::Least, 5)).contains("twice"));
    assert!(told(&fit(&[], "lakes", Aim::Least, 5)).contains("1 to 4 keys"));
    assert!(told(&fit(&amplitude, "lakes", Aim::Least, 0)).contains("runs"));
    assert!(told(&fit(&amplitude, "lakes", Aim::Target(f64::NAN), 5)).contains("target"));
    let far = fit(&amplitude, "median_slope", Aim::Target(50.0), 8);
    let found = run(&far).unwrap();
    let verdict = found.failure.unwrap();
    assert!(!found.is_reached && verdict.to_string().contains("nearest is"), "{verdict}");
    assert_eq!(found.rows[found.best.unwrap()].values, ["300 m"]);
    let never = fit(&amplitude, "steps", Aim::Most, 4);
    assert!(run(&never).unwrap().failure.unwrap().to_string().contains("no number"));
}
