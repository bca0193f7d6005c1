//! What particles do to the ground, one after the other, and the books of it.

use landform_core::terrain::{Bounds, Brush, Erodible};
use landform_core::verb::Change;
use serde::{Deserialize, Serialize};

use super::path::{End, Trace, lies};

/// What is in transport between particles, by number of the material, and what is still to be
/// removed.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Stock {
    /// Volumes that found no room, m³: the next particle carries them.
    load: Vec<f64>,
    /// Volume less than the smallest piece of the ground, m³.
    owed: f64,
}

/// As what materials are laid down.
pub(super) struct Deposits {
    /// Number of the material as which the first `rocks` of the table are laid.
    pub(super) of_rock: u8,
    pub(super) rocks: u8,
}

impl Deposits {
    fn laid_as(&self, number: usize) -> u8 {
        if number < usize::from(self.rocks) { self.of_rock } else { number as u8 }
    }
}

/// Volumes of a batch, m³.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Books {
    taken: f64,
    laid: f64,
    brought: f64,
    left: f64,
}

impl Books {
    /// The change of a step; `carried` is what the stock has gained.
    pub(super) fn change(&self, carried: f64) -> Change {
        // What came from outside is laid first, as supply.
        let supplied = self.brought.min(self.laid);
        Change {
            supplied,
            eroded: self.taken,
            deposited: self.laid - supplied,
            exported: self.left - (self.brought - supplied),
            carried,
            raised: 0.0,
        }
    }
}

impl Stock {
    /// A stock of volumes by number of the material, m³.
    pub(super) fn of(load: Vec<f64>) -> Self {
        Self { load, owed: 0.0 }
    }

    /// Volume in transport, m³.
    pub(super) fn volume(&self) -> f64 {
        self.load.iter().sum()
    }

    /// Does to the ground what a particle did on its way.
    pub(super) fn apply<T: Erodible>(
        &mut self,
        ground: &mut T,
        bounds: &Bounds,
        deposits: &Deposits,
        trace: &Trace,
        books: &mut Books,
    ) {
        self.load[usize::from(deposits.of_rock)] += trace.brought;
        books.brought += trace.brought;
        for step in &trace.exchanges {
            let brush = Brush { at: step.at, radius: trace.radius };
            if step.volume < 0.0 {
                let wanted = self.owed - step.volume;
                let taken = ground.take(brush, wanted, &mut self.load);
                // Beside the ground nothing is to be had: not more than a particle is asked for later.
                let most = 4.0 * trace.radius * trace.radius * trace.radius;
                self.owed = (wanted - taken).clamp(0.0, most);
                books.taken += taken;
            } else {
                books.laid += self.lay(ground, deposits, brush, step.volume);
            }
        }
        match trace.end {
            End::Left => {
                books.left += self.volume();
                self.load.fill(0.0);
            }
            End::Here(at) => {
                let brush = Brush { at: lies(ground, bounds, at, trace.radius), radius: trace.radius };
                books.laid += self.lay(ground, deposits, brush, f64::INFINITY);
            }
        }
    }

    /// Lays up to a volume of the load, each material its part; returns what was laid.
    fn lay<T: Erodible>(&mut self, ground: &mut T, deposits: &Deposits, brush: Brush, volume: f64) -> f64 {
        let whole = self.volume();
        if !(whole > 0.0) {
            return 0.0;
        }
        let (part, mut laid) = ((volume / whole).min(1.0), 0.0);
        for (number, load) in self.load.iter_mut().enumerate().filter(|l| *l.1 > 0.0) {
            let done = ground.lay(brush, part * *load, deposits.laid_as(number));
            // In single precision a voxel may hold a little more than was laid.
            *load -= done;
            laid += done;
        }
        laid
    }
}
