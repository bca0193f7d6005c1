//! Runs that begin on coarser cells, which are halved on the way.
//!
//! The ground of a coarser level is what the recipe at that level makes of it, so that the run
//! until the first halving is that of a preview, to the bit. A finer level takes over what changed
//! on the coarser one; what is finer than its cells stays as it was.

use landform_core::Result;
use landform_core::verb::MemoryOutput;

use super::entry::Work;
use super::evolve::{Coarser, failed_on};
use super::options::{Options, Outputs};
use super::{Level, Ran, Recipe};

impl Recipe {
    /// The coarser levels of the stage at an index, coarsest first; none if the run was asked to
    /// stop.
    ///
    /// # Errors
    /// If a stage before cannot work with so few cells, or fails there.
    pub(super) fn coarser_levels(&self, index: usize, options: &Options) -> Result<Option<Vec<Coarser>>> {
        let Work::Evolve(evolve) = &self.entries[index].work else { return Ok(Some(Vec::new())) };
        let times = evolve.clock.halvings();
        let mut levels = Vec::new();
        for (k, &until) in times.iter().enumerate() {
            let level = Level::halved(times.len() - k)?;
            let mut recipe = self.at(level).map_err(|e| failed_on(level, e))?;
            let Work::Evolve(evolve) = &recipe.entries[index].work else { continue };
            let parts = evolve.parts.clone();
            recipe.entries.truncate(recipe.last_before(index) + 1);
            recipe.entries.retain(|entry| entry.work.changes_terrain());
            recipe.notes.clear();
            let quiet = Options {
                cache: options.cache,
                salt: options.salt.clone(),
                cancel: options.cancel.clone(),
                outputs: Outputs::Nothing,
                ..Options::default()
            };
            let ran = recipe.run(&mut MemoryOutput::default(), &quiet);
            let Ran::ToTheEnd(ground, _) = ran.map_err(|e| failed_on(level, e))? else { return Ok(None) };
            levels.push(Coarser { level, ground, parts, until });
        }
        Ok(Some(levels))
    }

    /// Index of the stage whose ground the stage at an index gets.
    fn last_before(&self, index: usize) -> usize {
        let from = self.entries[index].from.as_deref();
        let labelled = |label| self.entries[..index].iter().rposition(|e| e.label.as_deref() == Some(label));
        from.and_then(labelled).unwrap_or(index - 1)
    }
}
