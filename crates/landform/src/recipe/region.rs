//! A window of a recipe's ground, built without the rest.

use landform_core::verb::{Margin, Reach, Window};
use landform_core::{Error, Result};

use super::entry::{Entry, Work};
use super::{Recipe, Verb};

impl Recipe {
    /// The same recipe for a window of its ground (south-west and north-east corner, m): only the window is built, with the margin that later
    /// stages look at, and not a bit of it differs from the whole.
    ///
    /// # Errors
    /// [`Error::Stage`] for a stage that needs the whole ground, such as everything that routes water.
    pub fn within(&self, bounds: [[f64; 2]; 2]) -> Result<Self> {
        let [sw, ne] = bounds;
        if !(sw[0] < ne[0] && sw[1] < ne[1]) {
            let value = format!("{},{},{},{}", sw[0], sw[1], ne[0], ne[1]);
            return Err(Error::parameter("region", value, "west,south,east,north in metres, each pair rising"));
        }
        let mut margin = Margin::default();
        for (index, entry) in self.entries.iter().enumerate().filter(|(_, e)| e.work.changes_terrain()) {
            let reach = entry.reach();
            if reach == Reach::Whole {
                let source = Error::Unsupported {
                    what: format!("`{}`, which needs the whole ground,", entry.name),
                    on: "region of it".into(),
                    supports: "the whole recipe; --level 1/4 shows it sooner".into(),
                };
                return Err(Error::Stage { index: index + 1, name: entry.name.clone(), source: Box::new(source) });
            }
            margin = margin.plus(reach);
        }
        Ok(Self { window: Some(Window { bounds, margin }), ..self.clone() })
    }
}

impl Entry {
    /// How far around a place the ground can matter to what the stage does there.
    pub(super) fn reach(&self) -> Reach {
        if !self.with.is_empty() {
            return Reach::Whole;
        }
        match &self.work {
            Work::Once(part) if part.stage().verb == Verb::Convert => Reach::Whole,
            Work::Once(part) => part.reach(),
            // Each step looks again; processes that look at nothing but the place may take any number of them.
            Work::Evolve(evolve) => {
                let still = evolve.watch.is_none() && evolve.clock.until.is_none();
                let each_at_its_place = evolve.parts.iter().all(|p| p.reach() == Reach::Point);
                if still && each_at_its_place { Reach::Point } else { Reach::Whole }
            }
        }
    }
}
