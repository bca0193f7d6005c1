use landform_core::grid::{Edge, Edges, Grid, Shape};
use landform_core::parallel::with_threads;
use landform_core::sim::{Model, Simulation, Stop};
use landform_core::terrain::Terrain;
use landform_core::units::Length;
use landform_core::verb::{Budget, Params};
use serde_json::json;

use super::*;
use crate::streams::StreamAutomaton;

fn read(json: &serde_json::Value) -> Automaton {
    let automaton: Automaton = serde_json::from_value(json.clone()).unwrap();
    automaton.validate().unwrap_or_else(|e| panic!("{e}"));
    automaton
}

fn ground(n: usize, edges: Edges, height: impl Fn(usize, usize) -> f64) -> HeightField {
    let mut grid = Grid::new(Shape::new(n, n), [10.0; 2]).unwrap();
    grid.edges = edges;
    HeightField::new(grid, (0..n * n).map(|i| height(i / n, i % n)).collect()).unwrap()
}

fn rough(n: usize) -> HeightField {
    ground(n, Edges::default(), |r, c| 4.0 * r as f64 + 12.0 * Seed(6).uniform((r * n + c) as u64))
}

fn run(terrain: HeightField, json: &serde_json::Value) -> (HeightField, Budget) {
    let automaton = read(json);
    let rounds = automaton.own_clock().unwrap().rounds;
    let mut sim =
        Simulation::new(terrain).process(automaton).unwrap().dt(YEAR).until(Stop::steps(rounds)).seed(Seed(3));
    let outcome = sim.run().unwrap();
    (sim.into_terrain(), outcome.budget)
}

fn life(start: &str, edges: Edges, steps: u64) -> Vec<f64> {
    let rules = json!([{ "set": "alive", "to": "(sum_around(alive) == 3) + alive*(sum_around(alive) == 2)" }]);
    let json = json!({ "states": { "alive": start }, "effects": [{ "steps": steps, "rules": rules }] });
    run(ground(8, edges, |_, _| 0.0), &json).0.real("alive", "a test").unwrap()
}

/// Rows and columns of living cells; cells are 10 m wide and row 0 is at y = 70 m.
fn alive(cells: &[f64]) -> Vec<(usize, usize)> {
    (0..64).filter(|&i| cells[i] == 1.0).map(|i| (i / 8, i % 8)).collect()
}

#[test]
fn a_blinker_blinks_and_a_glider_comes_back() {
    let blinker = "(y == 40)*(x >= 20)*(x <= 40)";
    assert_eq!(alive(&life(blinker, Edges::default(), 1)), [(2, 3), (3, 3), (4, 3)]);
    assert_eq!(alive(&life(blinker, Edges::default(), 2)), [(3, 2), (3, 3), (3, 4)]);
    let glider = "(y == 70)*(x == 10) + (y == 60)*(x == 20) + (y == 50)*(x <= 20)";
    let torus = Edges::all(Edge::Periodic);
    assert_eq!(alive(&life(glider, torus, 4)), [(1, 2), (2, 3), (3, 1), (3, 2), (3, 3)]);
    assert_eq!(life(glider, torus, 32), life(glider, torus, 64), "eight cells along the diagonal is once around");
    assert_eq!(alive(&life(glider, torus, 32)), [(0, 1), (1, 2), (2, 0), (2, 1), (2, 2)]);
}

/// Koh's rules: the land is flooded, water takes height where it leaves, pits absorb it.
fn koh(unit: f64, counted: bool) -> serde_json::Value {
    let most = if counted { "water" } else { "min(water, 1)" };
    json!({
        "states": { "water": "inside", "cut": 0 },
        "constants": { "unit": unit },
        "effects": [{ "steps": 5000, "until": "still", "rules": [
            { "set": "cut", "to": "min(unit*water, 0.5*drop())*inside" },
            { "set": "water", "to": "if(drop() > 0, water, 0)" },
            { "move": "water", "amount": "water", "to": "lowest" },
            { "set": "water", "to": format!("{most}*inside") },
            { "set": "height", "to": "height - cut" },
        ] }],
    })
}

#[test]
fn the_rules_of_the_stream_automaton_give_its_ground() {
    for counted in [false, true] {
        let (mine, budget) = run(rough(48), &koh(0.25, counted));
        let theirs = StreamAutomaton { unit: Length::of(0.25), counted, ..StreamAutomaton::default() };
        let mut sim = Simulation::new(rough(48)).process(theirs).unwrap().dt(YEAR).until(Stop::steps(1));
        let outcome = sim.run().unwrap();
        assert!(mine.elevation() == sim.terrain().elevation(), "to the bit, counted {counted}");
        assert!(mine.elevation() != rough(48).elevation());
        let [a, b] = [budget.change.exported, outcome.budget.change.exported];
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
        assert!(budget.imbalance() < 1e-9 && budget.sediment_imbalance() < 1e-9);
        assert!(mine.real("water", "a test").unwrap().iter().all(|w| *w == 0.0), "it ends when all is absorbed");
    }
}

#[test]
fn a_heap_comes_to_its_angle_and_keeps_its_volume() {
    let heap =
        ground(61, Edges::default(), |r, c| if r.abs_diff(30) <= 3 && c.abs_diff(30) <= 3 { 300.0 } else { 0.0 });
    let before = heap.volume();
    for to in ["steepest", "lower"] {
        let rules = json!([{ "move": "height", "amount": "max(0, slope() - repose)*cell_size/8", "to": to }]);
        let json = json!({ "constants": { "repose": 0.65 }, "effects": [{ "steps": 6000, "until": "still", "rules": rules }] });
        let (heap, budget) = run(heap.clone(), &json);
        assert!((heap.volume() / before - 1.0).abs() < 1e-12, "{to}");
        assert!(budget.change.exported == 0.0 && budget.change.eroded > 0.0 && budget.imbalance() < 1e-12);
        assert!((budget.change.eroded / budget.change.deposited - 1.0).abs() < 1e-12);
        let around = read(&json).ready(&heap).unwrap().1;
        let steepest = |i: usize| around.steepest(heap.elevation(), i).map_or(0.0, |(_, slope)| slope);
        let most = (0..61 * 61).map(steepest).fold(0.0, f64::max);
        assert!((0.6..0.651).contains(&most), "{to}: {most}");
    }
}

#[test]
fn what_moves_is_not_lost_but_over_open_sides() {
    for (edges, kept) in
        [(Edges::all(Edge::Periodic), true), (Edges::all(Edge::Closed), true), (Edges::default(), false)]
    {
        for to in [json!("lower"), json!([-1, 2])] {
            let json = json!({
                "states": { "water": "1 + u" }, "radius": 2,
                "effects": [
                    { "steps": 30, "rules": [{ "move": "water", "amount": "0.3*water + random()", "to": to, }] },
                    { "steps": 5, "together": true, "rules": [
                        { "move": "water", "amount": "water", "to": [1, 0] },
                        { "move": "water", "amount": "9*water", "to": [0, 1] },
                    ] },
                ],
            });
            let start = ground(20, edges, |r, c| Seed(2).uniform((r * 20 + c) as u64));
            let before: f64 = (0..400).map(|i| 1.0 + (i % 20) as f64 / 19.0).sum();
            let water = run(start, &json).0.real("water", "a test").unwrap();
            let after: f64 = water.iter().sum();
            assert!(water.iter().all(|w| *w >= 0.0), "{to}");
            assert!(((after / before - 1.0).abs() < 1e-12) == kept, "{edges:?} {to}: {before} {after}");
        }
    }
}

#[test]
fn ground_that_reaches_held_nodes_is_exported() {
    let rules = json!([
        { "move": "height", "amount": "0.2*drop()", "to": "lower" },
        { "set": "height", "to": "height + 0.1 - 0.2*(random() < 0.5)" },
    ]);
    let (after, budget) = run(rough(30), &json!({ "effects": [{ "steps": 50, "rules": rules }] }));
    let change = budget.change;
    assert!(change.exported > 0.0 && change.supplied > 0.0 && change.deposited > 0.0);
    assert!(budget.imbalance() < 1e-9 && budget.sediment_imbalance() < 1e-9);
    assert!((0..30).all(|i| after.elevation()[i] == rough(30).elevation()[i]), "the border is held");
}

#[test]
fn rules_read_what_the_one_before_left_or_the_start() {
    let both = |together: bool| {
        let rules = json!([{ "set": "a", "to": "b" }, { "set": "b", "to": "a" }]);
        let effects = json!([{ "steps": 1, "together": together, "rules": rules }]);
        let terrain = run(
            ground(4, Edges::default(), |_, _| 0.0),
            &json!({ "states": { "a": 1, "b": "a + 1" }, "effects": effects }),
        )
        .0;
        ["a", "b"].map(|name| terrain.real(name, "a test").unwrap()[5])
    };
    assert_eq!((both(false), both(true)), ([2.0, 2.0], [2.0, 1.0]));
}

#[test]
fn words_of_neighbours_mean_what_they_say() {
    // Heights 0 to 8, from the north-west; east of x = 20 there is nothing.
    let value = |text: &str, i: usize| {
        let json = json!({ "states": { "a": 0 }, "effects": [{ "steps": 3, "rules": [{ "set": "a", "to": text }] }] });
        run(ground(3, Edges::default(), |r, c| (3 * r + c) as f64), &json).0.real("a", "a test").unwrap()[i]
    };
    for (text, i, expected) in [
        ("sum_around(height)", 4, 32.0),
        ("mean_around(height)", 0, (1.0 + 3.0 + 4.0) / 3.0),
        ("min_around(height)", 4, 0.0),
        ("max_around(-height)", 8, -4.0),
        ("count_around(height > 5)", 4, 3.0),
        ("count_around(1)", 2, 3.0),
        ("at_lowest(2*height)", 4, 0.0),
        ("at_lowest(height, -height)", 4, 8.0),
        ("at(height, 1, 0)", 4, 5.0),
        ("at(height, 0, 1)", 4, 1.0),
        ("at(height, 9e99, 0)", 4, 4.0),
        ("drop()", 4, 4.0),
        ("drop(-height)", 4, 4.0),
        ("slope()", 4, 0.3),
        ("step", 4, 2.0),
        ("inside", 4, 1.0),
        ("inside", 3, 0.0),
        ("z + cell_size", 4, 14.0),
        ("sum_around(sum_around(1))", 4, 4.0 * 3.0 + 4.0 * 5.0),
    ] {
        let found = value(text, i);
        assert!((found - expected).abs() < 1e-12, "{text}: {found}, not {expected}");
    }
    let drawn: Vec<f64> = (0..9).map(|i| value("random() - random()", i)).collect();
    assert!(drawn.iter().all(|d| *d != 0.0 && d.abs() < 1.0) && drawn[0] != drawn[1]);
}

#[test]
fn threads_change_nothing() {
    let json = json!({
        "states": { "wet": "noise(40) > 0" },
        "effects": [{ "steps": 8, "rules": [
            { "set": "wet", "to": "0.5*mean_around(wet) + random()" },
            { "move": "height", "amount": "wet*drop()/4", "to": "lower", "over": "height + wet" },
        ] }],
    });
    let [one, two] = [1, 2].map(|threads| with_threads(threads, || run(rough(150), &json).0).unwrap());
    assert!(one == two);
}

#[test]
fn a_run_that_is_edited_goes_on_with_its_states() {
    let automaton = read(&json!({
        "states": { "age": 0, "old": { "field": "before" } },
        "effects": [
            { "steps": 9, "until": "still", "rules": [{ "set": "old", "to": "min(old + 1, 2)" }] },
            { "steps": 4, "rules": [{ "set": "age", "to": "age + 1 + old*random()" }] },
        ],
    }));
    let run = |edits: bool| {
        let mut terrain = rough(9);
        terrain.fields_mut().insert_values("before", Values::U8(vec![1; 81])).unwrap();
        let mut model = Model::new(terrain);
        model.add(automaton.clone()).unwrap();
        let mut model = model.dt(YEAR).seed(Seed(8));
        for _ in 0..7 {
            model.advance_steps(1).unwrap();
            if edits {
                model.edit(|_| {}).unwrap();
            }
        }
        ["age", "old"].map(|name| model.terrain().real(name, "a test").unwrap())
    };
    let [age, old] = run(false);
    assert!(old.iter().all(|v| *v == 2.0) && age.iter().all(|v| (4.0..12.0).contains(v)), "{age:?}");
    assert!(run(true) == [age, old]);
    assert_eq!(automaton.leaves(), ["age", "old"]);
    let again: State = serde_json::from_str(&serde_json::to_string(&automaton.after(11, Seed(1))).unwrap()).unwrap();
    assert_eq!((again.iteration, again.effect, again.step), (0, 1, 2));
}

#[test]
fn nodata_is_nobodys_neighbour() {
    let grid = Grid::new(Shape::new(5, 5), [10.0; 2]).unwrap();
    let z = (0..25).map(|i| if i == 12 { f64::NAN } else { 1.0 + i as f64 }).collect();
    let rules = json!([{ "set": "count", "to": "count_around(1) + at(0*height, 1, 0)" }, { "move": "height", "amount": "0.1*drop()", "to": "lower" }]);
    let json = json!({ "states": { "count": 0 }, "effects": [{ "steps": 4, "rules": rules }] });
    let (after, budget) = run(HeightField::new(grid, z).unwrap(), &json);
    let count = after.real("count", "a test").unwrap();
    assert_eq!((count[11], count[0]), (7.0, 3.0));
    assert!(after.elevation()[12].is_nan() && budget.imbalance() < 1e-9);
}

#[test]
fn wrong_automata_are_refused_before_they_run() {
    let rule = |rule: serde_json::Value| json!({ "states": { "water": 1 }, "effects": [{ "rules": [{ "set": "water", "to": 1 }, rule] }] });
    let states = |states: serde_json::Value| json!({ "states": states, "effects": [{ "rules": [{ "set": "height", "to": "sand + mud" }] }] });
    for (json, told) in [
        (
            rule(json!({ "set": "watr", "to": 1 })),
            "`effects[0].rules[1].set` is \"watr\"; expected one of the states height, water (did you mean `water`?)",
        ),
        (rule(json!({ "set": "water", "to": "watr + 1" })), "`watr` is not known (did you mean `water`?)"),
        (rule(json!({ "set": "water", "to": "sum_arond(water)" })), "did you mean `sum_around`?"),
        (rule(json!({ "set": "water", "to": "drop" })), "`drop` is a function"),
        (rule(json!({ "set": "water", "to": "at(water, 1)" })), "`at` takes 3 values, not 2"),
        (rule(json!({ "set": "water", "to": "1/0" })), "a formula whose value is finite"),
        (rule(json!({ "set": "water", "to": [1, 0] })), "a finite number or a formula"),
        (rule(json!({ "set": "water" })), "`effects[0].rules[1].to` is not given"),
        (rule(json!({ "set": "water", "to": 1, "amount": 1 })), "it goes with `move`"),
        (rule(json!({ "move": "water", "to": "lowest" })), "rules[1].amount` is not given"),
        (rule(json!({ "move": "water", "amount": 1, "to": "lowst" })), "did you mean \"lowest\"?"),
        (rule(json!({ "move": "water", "amount": 1, "to": [0, 0] })), "[0, 0]"),
        (rule(json!({ "move": "water", "amount": 1, "to": [i64::MIN, 0] })), "cells to the east"),
        (rule(json!({ "move": "water", "amount": 1, "to": [1, 0], "over": "height" })), "`to` says which cell"),
        (rule(json!({ "move": "water", "set": "water", "to": 1 })), "with both"),
        (rule(json!({ "to": 1 })), "without `set` or `move`"),
        (states(json!({ "sand": "2*mud", "mud": "sand" })), "mud, sand wait for each other"),
        (states(json!({ "sand": "sand", "mud": 1 })), "sand wait for each other"),
        (states(json!({ "sand": 1, "mud": 1, "peat": 1 })), "a state that a rule uses"),
        (states(json!({ "sand": 1, "mud": 1, "height": 1 })), "always there"),
        (states(json!({ "sand": 1, "mud": 1, "Mud": 1 })), "small letters"),
        (states(json!({ "sand": 1, "mud": 1, "u": 1 })), "have that word already"),
        (states(json!({ "sand": 1, "mud": 1, "mud_depth": 1 })), "layers"),
        (json!({ "effects": [] }), "at least one effect"),
        (json!({ "effects": [{}] }), "at least one rule"),
        (json!({ "effects": [{ "steps": 0 }] }), "at least 1"),
        (json!({ "radius": 17 }), "at most 16"),
        (json!({ "states": { "sand": { "feild": "x" } } }), "unknown field `feild`"),
        (json!({ "states": { "sand": true } }), "expected a number, a formula"),
    ] {
        let found = serde_json::from_value::<Automaton>(json.clone()).map_err(|e| e.to_string());
        let error = found.and_then(|a| a.validate().map_err(|e| e.to_string())).unwrap_err();
        assert!(error.contains(told), "{json}: {error}");
    }
    let deep = rule(json!({ "set": "water", "to": "sum_around(".repeat(5000) }));
    assert!(serde_json::from_value::<Automaton>(deep).unwrap().validate().is_err());
}

#[test]
fn numbers_that_are_none_are_told_with_the_rule() {
    let json = json!({ "states": { "a": 1 }, "effects": [{ "rules": [{ "set": "a", "to": "1/(step - 2)" }] }] });
    let mut sim = Simulation::new(rough(9)).process(read(&json)).unwrap().dt(YEAR).until(Stop::steps(5));
    let error = sim.run().unwrap_err().to_string();
    assert!(error.contains("`a` is not finite at node 0 after `effects[0].rules[0]`"), "{error}");
    let json = json!({ "states": { "a": "1/(u - u)" }, "effects": [{ "rules": [{ "set": "a", "to": 1 }] }] });
    let mut sim = Simulation::new(rough(9)).process(read(&json)).unwrap().dt(YEAR).until(Stop::steps(5));
    assert!(sim.run().unwrap_err().to_string().contains("the start of `automaton`"));
}
