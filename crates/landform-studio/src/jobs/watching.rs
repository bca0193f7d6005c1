//! What looks at a preview while it runs.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::time::Instant;

use landform::Result;
use landform::core::terrain::AnyTerrain;
use landform::core::verb::CancelToken;
use landform::recipe::{Looker, Moment};
use serde_json::json;

use super::control::Control;
use super::layers::{Rasters, names};
use super::order::Order;
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
}

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
    fn wants_all(&self) -> bool {
        self.order.watched
    }

    fn look(&self, moment: &mut dyn Moment) -> Result<ControlFlow<()>> {
        let holds = self.control.holds();
        if holds || (self.order.watched && self.hub.has_room()) {
            self.show(&moment.ground(), moment.time(), true)?;
        }
        if holds {
            self.board.set(self.hub, |state| state.paused = true);
        }
        self.control.wait(*lock(&self.last), &self.cancel);
        *lock(&self.last) = Instant::now();
        if holds && !self.control.is_paused() {
            self.board.set(self.hub, |state| state.paused = false);
        }
        Ok(ControlFlow::Continue(()))
    }
}
