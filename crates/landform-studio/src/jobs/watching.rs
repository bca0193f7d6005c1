//! What looks at a preview while it runs.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use landform::Result;
use landform::core::terrain::AnyTerrain;
use landform::core::verb::CancelToken;
use landform::recipe::{Left, Looker, Moment};
use serde_json::json;

use super::control::Control;
use super::layers::{Rasters, names};
use super::order::Order;
use super::paint::Easel;
use super::state::Board;
use crate::hub::{Hub, Slot, lock};
use crate::protocol::{Frame, Stamp};

/// Rows and columns of ground that is still changing.
const MOVING: usize = 1025;
/// Rows and columns of what a level came to.
const AT_REST: usize = 2049;

/// Shows a run's ground, holds it.
pub(crate) struct Watching<'a> {
    pub(crate) hub: &'a Hub,
    pub(crate) board: &'a Board,
    pub(crate) control: &'a Control,
    pub(crate) rasters: &'a Rasters,
    pub(crate) order: &'a Order,
    pub(crate) level: String,
    pub(crate) cancel: CancelToken,
    pub(crate) sea_level: Option<f64>,
    pub(crate) last: Mutex<Instant>,
    pub(crate) easel: &'a Easel,
    /// How often cells are halved from this level to the recipe's own.
    pub(crate) halvings: u32,
    pub(crate) lefts: &'a Mutex<Lefts>,
    /// Whether the ground is no longer what the recipe says.
    pub(crate) changed: AtomicBool,
    pub(crate) began: Instant,
}

/// What processes left, by level and stage.
pub(crate) type Lefts = BTreeMap<(u32, usize), Left>;

/// Ground of more nodes is not kept to go on from.
const MOST_KEPT: usize = 300_000;
/// How many are kept.
const MOST_LEFTS: usize = 12;
/// What goes on while a value is dragged shows its ground after so long.
const SETTLES: Duration = Duration::from_millis(30);
/// What is painted on goes on for so long, s.
const AFTER_PAINT: f64 = 20.0;

impl Watching<'_> {
    /// Shows ground to all pages.
    pub(crate) fn show(&self, ground: &AnyTerrain, time: f64, moving: bool) -> Result<()> {
        let rows = self.rasters.layers(ground, &self.hub.fields(), if moving { MOVING } else { AT_REST })?;
        let names: Vec<_> = names(ground).iter().map(|(name, unit)| json!({ "name": name, "unit": unit })).collect();
        self.hub.tell_if_new(Slot::Fields, &json!({ "tell": "fields", "names": names }));
        let order = self.order;
        let computed = self.hub.clock();
        let stamp = order.stamp.map(|(page, received)| Stamp { page, received, computed });
        let state = self.board.get();
        let end = order.shown.unwrap_or(order.steps.len().saturating_sub(1));
        let environment = &order.recipe.environment;
        let sea_level = environment.sea_level.as_ref().map(|_| environment.sea_level_at(time)).or(self.sea_level);
        self.hub.show(Frame {
            number: self.hub.next_number(),
            revision: order.revision,
            level: self.level.clone(),
            rows: rows.rows,
            cols: rows.cols,
            cell_size: rows.cell_size,
            origin: rows.origin,
            time,
            stage: if moving { state.stage } else { order.steps.get(end).copied() },
            sea_level,
            stamp,
            layers: rows.layers,
        });
        Ok(())
    }
}

impl Looker for Watching<'_> {
    fn wants(&self, stage: usize) -> bool {
        match self.order.goes_on {
            Some(first) => first <= stage && lock(self.lefts).contains_key(&(self.halvings, stage)),
            None => self.order.watched,
        }
    }

    fn has_changed_it(&self) -> bool {
        self.changed.load(Ordering::Relaxed)
    }

    fn goes_on_from(&self, stage: usize) -> Option<Left> {
        self.order.goes_on.filter(|&first| first <= stage)?;
        let left = lock(self.lefts).get(&(self.halvings, stage)).cloned()?;
        self.changed.store(true, Ordering::Relaxed);
        self.board.set(self.hub, |state| state.settling = true);
        Some(left)
    }

    fn ended(&self, stage: usize, left: &dyn Fn() -> Left) {
        let mut lefts = lock(self.lefts);
        let left = left();
        if left.ground.nodes() <= MOST_KEPT && (lefts.len() < MOST_LEFTS || lefts.contains_key(&(self.halvings, stage)))
        {
            lefts.insert((self.halvings, stage), left);
        } else {
            lefts.remove(&(self.halvings, stage));
        }
    }

    fn look(&self, moment: &mut dyn Moment) -> Result<ControlFlow<()>> {
        let order = self.order;
        if order.watched {
            self.control.count(&self.cancel);
        }
        loop {
            if self.easel.paint(moment)? {
                self.changed.store(true, Ordering::Relaxed);
                self.show(&moment.ground(), moment.time(), true)?;
            }
            let holds = order.watched && self.control.holds();
            let breaks_off = order.dragging && !self.has_changed_it() && self.cancel.is_cancelled();
            if holds || breaks_off || (order.watched && self.hub.has_room()) {
                self.show(&moment.ground(), moment.time(), true)?;
            }
            if !order.watched {
                break;
            }
            if holds {
                self.board.set(self.hub, |state| state.paused = true);
            }
            let goes = self.control.wait(Some(*lock(&self.last)), &self.cancel);
            if holds && !self.control.is_paused() {
                self.board.set(self.hub, |state| state.paused = false);
            }
            if goes {
                break;
            }
        }
        *lock(&self.last) = Instant::now();
        let ends = match (order.goes_on, self.has_changed_it()) {
            (Some(_), true) if order.dragging => self.began.elapsed() >= SETTLES,
            (Some(_), true) => self.easel.idle() > AFTER_PAINT,
            _ => false,
        };
        if ends {
            return Ok(ControlFlow::Break(()));
        }
        Ok(ControlFlow::Continue(()))
    }
}
