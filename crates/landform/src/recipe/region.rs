//! A window of a recipe's ground, built without the rest.

use landform_core::verb::{Margin, Reach, Window};
use landform_core::{Error, Result};

use super::entry::{Entry, Work};
use super::{Recipe, Verb};

impl Recipe {
    /// The same recipe for a window of its ground (south-west and north-east corner, m): only the
    /// window is built, with the margin that later stages read. It is the same as in the whole, to
    /// the bit.
    ///
    /// # Errors
    /// [`Error::Stage`] if a stage needs the whole ground, as every stage that routes water does.
    pub fn within(&self, bounds: [[f64; 2]; 2]) -> Result<Self> {
        let [sw, ne] = bounds;
        if !(sw[0] < ne[0] && sw[1] < ne[1]) {
            let value = format!("{},{},{},{}", sw[0], sw[1], ne[0], ne[1]);
            return Err(Error::parameter("region", value, "west,south,east,north in metres, each pair rising"));
        }
        let mut margin = Margin::default();
        for (index, entry) in self.entries.iter().enumerate() {
            let reach = entry.reach();
            if reach == Reach::Whole {
                let source = Error::Unsupported {
                    what: format!("`{}`, which needs the whole ground,", entry.name),
                    on: "region of it".into(),
                    supports: "the whole recipe; --level 1/4 shows it sooner".into(),
                };
                return Err(entry.failed(index, source));
            }
            // What is shown of the window needs nothing around it.
            margin = if entry.work.changes_terrain() { margin.plus(reach) } else { margin };
        }
        Ok(Self { window: Some(Window { bounds, margin }), ..self.clone() })
    }
}

impl Entry {
    /// How far around a node the ground can affect the result of the stage there.
    pub(super) fn reach(&self) -> Reach {
        if !self.with.is_empty() {
            return Reach::Whole;
        }
        match &self.work {
            Work::Once(part) if part.stage().verb == Verb::Convert => Reach::Whole,
            Work::Once(part) => part.reach(),
            // Each step reads the neighbourhood again; processes that read only the node itself may
            // take any number of steps.
            Work::Evolve(evolve) => {
                // Coarser cells lie by the corner of the whole.
                let still =
                    evolve.watch.is_none() && evolve.clock.until.is_none() && evolve.clock.halvings().is_empty();
                let each_at_its_place = evolve.parts.iter().all(|p| p.reach() == Reach::Point);
                if still && each_at_its_place { Reach::Point } else { Reach::Whole }
            }
        }
    }
}
