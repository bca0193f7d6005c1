//! A look at a model while it runs: to show it, to hold it, to change it.

use std::ops::ControlFlow;
use std::sync::Arc;

use landform_core::Result;
use landform_core::parallel;
use landform_core::sim::Model;
use landform_core::terrain::{AnyTerrain, Layer, Surface};

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
///         self.0.store(highest.round() as u64, Ordering::Relaxed);
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
    /// Whether the processes of a stage (from 0) run though their ground is in the cache.
    fn wants(&self, _stage: usize) -> bool {
        false
    }

    /// Whether the ground was changed from outside in this run. From then on nothing is read from
    /// the cache or kept in it.
    fn has_changed_it(&self) -> bool {
        false
    }

    /// Ground that the processes of a stage (from 0) go on from, in place of that before it, with
    /// the time and the steps that they are at. They then run until [`Looker::look`] breaks off;
    /// the ground counts as changed from outside. Other ground than that of as many nodes is passed
    /// over.
    fn goes_on_from(&self, _stage: usize) -> Option<Left> {
        None
    }

    /// The processes of a stage (from 0) have ended.
    fn ended(&self, _stage: usize, _left: &dyn Fn() -> Left) {}

    /// Looks at the model after a step. The run goes on when this returns;
    /// [`ControlFlow::Break`] ends its processes there.
    ///
    /// # Errors
    /// What it returns ends the run.
    fn look(&self, moment: &mut dyn Moment) -> Result<ControlFlow<()>>;
}

/// A new elevation (m) for a node's index, place (m) and elevation (m).
///
/// ```
/// let dam: &landform::recipe::Change<'_> = &|_, [x, _], z| if x < 10.0 { z + 3.0 } else { z };
/// assert_eq!(dam(0, [5.0, 0.0], 1.0), 4.0);
/// ```
pub type Change<'a> = dyn Fn(usize, [f64; 2], f64) -> f64 + Sync + 'a;

/// What processes left.
///
/// ```
/// use std::sync::Arc;
/// use landform::core::grid::{Grid, Shape};
/// use landform::core::terrain::{HeightField, Representation};
/// use landform::recipe::Left;
///
/// let ground = HeightField::new(Grid::new(Shape::new(2, 2), [1.0; 2])?, vec![0.0; 4])?.wrap();
/// let left = Left { ground: Arc::new(ground), time: 0.0, steps: 0 };
/// assert_eq!(left.ground.nodes(), 4);
/// # Ok::<(), landform::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Left {
    /// The ground, its nodes where the processes had them.
    pub ground: Arc<AnyTerrain>,
    /// Time, s.
    pub time: f64,
    /// Steps taken.
    pub steps: u64,
}

/// A model between two steps.
///
/// ```
/// use landform::recipe::Moment;
///
/// /// Digs a pit of 3 m around a place.
/// fn dig(moment: &mut dyn Moment, [x, y]: [f64; 2]) -> landform::Result<bool> {
///     moment.edit(&|_, at, z| if (at[0] - x).abs().max((at[1] - y).abs()) < 9.0 { z - 3.0 } else { z })
/// }
/// ```
pub trait Moment {
    /// Steps taken.
    fn steps(&self) -> u64;
    /// Time, s.
    fn time(&self) -> f64;
    /// A copy of the ground.
    fn ground(&self) -> AnyTerrain;
    /// Changes elevations: `change` gets the index, the place (m) and the elevation (m) of a node
    /// and returns its new elevation. False where nothing can be changed, as while cells are
    /// coarser.
    ///
    /// # Errors
    /// If a process does not find what it needs on the changed ground.
    fn edit(&mut self, change: &Change<'_>) -> Result<bool>;
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

    fn edit(&mut self, change: &Change<'_>) -> Result<bool> {
        let edit = |terrain: &mut T| {
            let new: Vec<f64> = {
                let z = terrain.elevation();
                parallel::map(z.len(), |i| if z[i].is_finite() { change(i, terrain.position(i), z[i]) } else { z[i] })
            };
            // What a hand lays down is rock, and it takes what lies uppermost.
            terrain.change(Layer::Bedrock, |z| z.copy_from_slice(&new));
        };
        self.0.edit(edit).map(|()| true)
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

    fn edit(&mut self, _: &Change<'_>) -> Result<bool> {
        Ok(false)
    }
}

/// A look that does nothing where nobody looks.
pub(super) fn look(looker: Option<&dyn Looker>, moment: &mut dyn Moment) -> Result<ControlFlow<()>> {
    looker.map_or(Ok(ControlFlow::Continue(())), |looker| looker.look(moment))
}
