//! A look at a model while it runs: to show it, to hold it, to change it.

use std::ops::ControlFlow;

use landform_core::Result;
use landform_core::sim::Model;
use landform_core::terrain::{AnyTerrain, Surface};

/// Looks at a run of processes after every step.
///
/// ```
/// use std::ops::ControlFlow;
/// use std::sync::atomic::{AtomicU64, Ordering};
/// use landform::core::verb::MemoryOutput;
/// use landform::recipe::{Looker, Moment, Options, Recipe};
///
/// struct Highest(AtomicU64);
/// impl Looker for Highest {
///     fn look(&self, moment: &mut dyn Moment) -> landform::Result<ControlFlow<()>> {
///         let highest = moment.ground().elevation().iter().fold(0.0, |a, &z| f64::max(a, z));
///         self.0.store(highest as u64, Ordering::Relaxed);
///         Ok(ControlFlow::Continue(()))
///     }
/// }
///
/// let text = r#"
/// [[stage]]
/// use = "flat"
/// grid = { size = ["400 m", "400 m"], cell_size = "100 m" }
/// [[stage]]
/// use = "uplift"
/// rate = "1 m/yr"
/// clock = { dt = "1 yr", duration = "20 yr" }"#;
/// let seen = Highest(AtomicU64::new(0));
/// let options = Options { look: Some(&seen), ..Options::default() };
/// Recipe::parse(text, "rising", "".as_ref(), &[])?.run(&mut MemoryOutput::default(), &options)?;
/// assert_eq!(seen.0.into_inner(), 20);
/// # Ok::<(), landform::Error>(())
/// ```
pub trait Looker: Sync {
    /// Whether processes run though their ground is in the cache.
    fn wants_all(&self) -> bool {
        false
    }

    /// Whether the ground was changed from outside in this run. From then on nothing is read from
    /// the cache or kept in it.
    fn has_changed_it(&self) -> bool {
        false
    }

    /// Looks at the model after a step. The run goes on when this returns;
    /// [`ControlFlow::Break`] ends its processes there.
    ///
    /// # Errors
    /// What it returns ends the run.
    fn look(&self, moment: &mut dyn Moment) -> Result<ControlFlow<()>>;
}

/// A model between two steps.
pub trait Moment {
    /// Steps taken.
    fn steps(&self) -> u64;
    /// Time, s.
    fn time(&self) -> f64;
    /// A copy of the ground.
    fn ground(&self) -> AnyTerrain;
}

/// A model on the finest cells.
pub(super) struct Running<'a, T: Surface>(pub(super) &'a mut Model<T>);

impl<T: Surface> Moment for Running<'_, T> {
    fn steps(&self) -> u64 {
        self.0.steps()
    }

    fn time(&self) -> f64 {
        self.0.time()
    }

    fn ground(&self) -> AnyTerrain {
        self.0.terrain().at_centres().into_owned().wrap()
    }
}

/// A model on coarser cells, which is shown on the finest.
pub(super) struct Coarser<'a, T: Surface> {
    /// The model.
    pub(super) model: &'a Model<T>,
    /// Its ground before it ran.
    pub(super) before: &'a T,
    /// The ground on the finest cells, before it ran.
    pub(super) finest: &'a T,
}

impl<T: Surface> Moment for Coarser<'_, T> {
    fn steps(&self) -> u64 {
        self.model.steps()
    }

    fn time(&self) -> f64 {
        self.model.time()
    }

    fn ground(&self) -> AnyTerrain {
        let mut terrain = self.finest.clone();
        terrain.take_change_of(self.before, self.model.terrain());
        terrain.at_centres().into_owned().wrap()
    }
}

/// A look that does nothing where nobody looks.
pub(super) fn look(looker: Option<&dyn Looker>, moment: &mut dyn Moment) -> Result<ControlFlow<()>> {
    looker.map_or(Ok(ControlFlow::Continue(())), |looker| looker.look(moment))
}
