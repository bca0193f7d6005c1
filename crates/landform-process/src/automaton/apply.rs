//! One rule, applied to all cells at once.

use landform_core::grid::Status;
use landform_core::verb::Change;
use landform_core::{Error, Result, parallel};

use super::program::{PlannedRule, Way};
use super::words::GROUND;
use super::world::World;

/// Cell that an amount goes to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Target {
    /// It stays.
    #[default]
    None,
    /// It leaves the map.
    Outside,
    Cell(usize),
}

/// Applies a rule, which reads `world` and changes the values of its state in `now`. Returns the
/// volumes that it moved if the state is the ground.
///
/// # Errors
/// [`Error::NonFinite`] with the state and the rule, if a value is no finite number.
pub(super) fn apply(rule: &PlannedRule, world: &World, now: &mut [f64], told: Told<'_>) -> Result<Change> {
    let mut values = vec![0.0; now.len()];
    rule.formula.write(world, &mut values);
    let status = world.around.status();
    finite(&values, status, told)?;
    let held = |cell: usize| match status[cell] {
        Status::Interior => false,
        Status::BaseLevel => rule.is_of_ground(),
        Status::Masked => true,
    };
    match rule.way {
        None => Ok(set(rule, world, now, &values, held)),
        Some(way) => {
            // Nothing but the ground can be less than nothing.
            let available = |cell: usize| if rule.is_of_ground() { f64::INFINITY } else { now[cell].max(0.0) };
            parallel::update(&mut values, |cell, amount| {
                *amount = if held(cell) { 0.0 } else { amount.min(available(cell)).max(0.0) };
            });
            let surface = match &rule.over {
                Some(over) => {
                    let mut surface = vec![0.0; now.len()];
                    over.write(world, &mut surface);
                    finite(&surface, status, told)?;
                    Some(surface)
                }
                None => None,
            };
            let surface = surface.as_deref().unwrap_or(&world.states[GROUND]);
            let change = carry(rule, world, way, surface, now, &values);
            finite(now, status, told)?;
            Ok(change)
        }
    }
}

/// Names for messages.
#[derive(Clone, Copy)]
pub(super) struct Told<'a> {
    /// The state that changes.
    pub(super) state: &'a str,
    /// Numbers of the effect and of the rule in it, from 0.
    pub(super) rule: [usize; 2],
}

fn finite(values: &[f64], status: &[Status], told: Told<'_>) -> Result<()> {
    let is_wrong = |cell: usize| !values[cell].is_finite() && status[cell] != Status::Masked;
    match parallel::find_first(values.len(), is_wrong) {
        None => Ok(()),
        Some(node) => {
            let [effect, rule] = told.rule;
            let after = format!("`effects[{effect}].rules[{rule}]` of `automaton`");
            Err(Error::NonFinite { field: format!("`{}`", told.state), node, after })
        }
    }
}

/// Sets a state. Of ground that rises nobody knows where from, so it counts as supplied; what sinks
/// as exported.
fn set(
    rule: &PlannedRule,
    world: &World,
    now: &mut [f64],
    values: &[f64],
    held: impl Fn(usize) -> bool + Sync,
) -> Change {
    let mut change = Change::default();
    if rule.is_of_ground() {
        let (area, rise) =
            (world.grid.cell_area(), |cell: usize| if held(cell) { 0.0 } else { values[cell] - now[cell] });
        change.supplied = area * parallel::sum(now.len(), |cell| rise(cell).max(0.0));
        change.eroded = area * parallel::sum(now.len(), |cell| (-rise(cell)).max(0.0));
        change.exported = change.eroded;
        change.raised = parallel::max(now.len(), rise).max(0.0);
    }
    parallel::update(now, |cell, now| {
        if !held(cell) {
            *now = values[cell];
        }
    });
    change
}

/// Carries amounts to where they go. All leave before any arrives; cells are visited in order, so
/// that sums do not depend on threads.
fn carry(rule: &PlannedRule, world: &World, way: Way, surface: &[f64], now: &mut [f64], amounts: &[f64]) -> Change {
    let (around, status) = (world.around, world.around.status());
    let target = |cell: usize| match way {
        _ if amounts[cell] == 0.0 => Target::None,
        Way::Lowest => around.lowest(surface, cell).map_or(Target::None, Target::Cell),
        Way::Steepest => around.steepest(surface, cell).map_or(Target::None, |(to, _)| Target::Cell(to)),
        Way::Offset(by) => around.offset(cell, by).map_or(Target::Outside, Target::Cell),
        Way::Lower => around.lowest(surface, cell).map_or(Target::None, Target::Cell),
    };
    let targets = parallel::map(now.len(), target);
    let mut arriving = vec![0.0; now.len()];
    let (mut gone, mut arrived, mut lost) = (0.0, 0.0, 0.0);
    let mut put = |to: usize, amount: f64| {
        if rule.is_of_ground() && status[to] == Status::BaseLevel {
            lost += amount;
        } else {
            arriving[to] += amount;
            arrived += amount;
        }
    };
    let mut outside = 0.0;
    for (cell, target) in targets.into_iter().enumerate() {
        let amount = amounts[cell];
        match (target, way) {
            (Target::None, _) => continue,
            (Target::Outside, _) => outside += amount,
            (Target::Cell(lowest), Way::Lower) => share(world, surface, cell, lowest, amount, &mut put),
            (Target::Cell(to), _) => put(to, amount),
        }
        now[cell] -= amount;
        gone += amount;
    }
    parallel::update(now, |cell, now| *now += arriving[cell]);
    if !rule.is_of_ground() {
        return Change::default();
    }
    let area = world.grid.cell_area();
    Change { eroded: area * gone, deposited: area * arrived, exported: area * (lost + outside), ..Change::default() }
}

/// Shares an amount among lower neighbours by slope; the lowest takes what the others leave.
fn share(world: &World, surface: &[f64], cell: usize, lowest: usize, amount: f64, put: &mut impl FnMut(usize, f64)) {
    let slope = |to: usize, distance: f64| ((surface[cell] - surface[to]) / distance).max(0.0);
    let mut all = 0.0;
    world.around.each(cell, |to, distance| all += slope(to, distance));
    let mut left = amount;
    world.around.each(cell, |to, distance| {
        let part = (amount * (slope(to, distance) / all)).min(left);
        if to != lowest && part > 0.0 {
            left -= part;
            put(to, part);
        }
    });
    put(lowest, left);
}
