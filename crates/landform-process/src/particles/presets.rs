//! Parameters of each phenomenon.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::surroundings::{Emitter, FlowIn};

/// What particles are.
///
/// ```
/// use landform_process::particles::Phenomenon;
/// assert_eq!(Phenomenon::default(), Phenomenon::Rain);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Phenomenon {
    /// Drops that run downhill and cut rills.
    #[default]
    Rain,
    /// Waves that wear a coast at the level of the water.
    Coastal,
    /// A river that a flow leads in bends.
    Meanders,
    /// A river of drops of several sizes.
    River,
    /// Ground that flows down and fills hollows.
    Landslide,
    /// Lava, of which the ground grows.
    Volcano,
    /// Water that dissolves passages.
    Karst,
    /// Water that cuts a passage.
    Tunnel,
    /// Air that blows grains against rock.
    Wind,
    /// Currents over the floor of the sea.
    UnderwaterCurrents,
}

/// Values of a phenomenon where none are given.
#[derive(Clone, Debug)]
pub(super) struct Preset {
    pub(super) particles: u64,
    pub(super) iterations: u64,
    /// Least and greatest radius, cells.
    pub(super) radius: [f64; 2],
    pub(super) restitution: f64,
    pub(super) density: f64,
    /// Part of the particle's volume.
    pub(super) capacity: f64,
    /// m/s.
    pub(super) erosion: f64,
    pub(super) deposition: f64,
    pub(super) initial_load: f64,
    pub(super) flow_in: FlowIn,
    pub(super) emitter: Emitter,
}

/// A row of Table 6.1: particles, iterations, radius, restitution, density, and the factors of
/// capacity, erosion and deposition.
type Row = (u64, u64, [f64; 2], f64, f64, [f64; 3]);

impl Phenomenon {
    /// Hartley (thesis), Table 6.1. For the volcano it has a restitution of 5 and a radius of 1,
    /// which are taken as swapped. Its factors are without units: capacity is taken in hundredths
    /// of the particle's volume, deposition in tenths, erosion in tenths of mm/s, or in 2 mm/s for
    /// what strikes rock and does not run over the ground: with less, rills and notches do not
    /// form, with more, particles are full after a few steps and heap up what they carry.
    const fn row(self) -> Row {
        match self {
            Self::Rain => (100, 10, [1.0, 1.0], 1.0, 1000.0, [10.0, 2.5, 0.3]),
            Self::Coastal => (80, 3, [5.0, 5.0], 0.1, 500.0, [10.0, 5.0, 0.5]),
            Self::Meanders => (10, 20, [5.0, 5.0], 1.0, 1000.0, [1.0, 1.0, 1.0]),
            Self::River => (100, 50, [1.5, 5.0], 0.5, 900.0, [0.1, 1.0, 1.0]),
            Self::Landslide => (200, 10, [2.5, 2.5], 0.2, 500.0, [0.1, 1.0, 1.0]),
            Self::Volcano => (150, 30, [5.0, 5.0], 1.0, 2000.0, [1.0, 1.0, 5.0]),
            Self::Karst => (1000, 40, [5.0, 5.0], 0.5, 500.0, [10.0, 5.0, 0.5]),
            Self::Tunnel => (100, 100, [2.5, 2.5], 0.1, 500.0, [1.0, 1.0, 1.0]),
            Self::Wind => (100, 10, [1.5, 1.5], 0.9, 1.5, [1.0, 1.0, 1.0]),
            Self::UnderwaterCurrents => (100, 50, [2.5, 2.5], 0.9, 1000.0, [1.0, 1.0, 1.0]),
        }
    }

    pub(super) fn preset(self) -> Preset {
        let (particles, iterations, radius, restitution, density, [capacity, erosion, deposition]) = self.row();
        let (flow_in, emitter) = match self {
            Self::Coastal | Self::Karst | Self::UnderwaterCurrents => (FlowIn::Water, Emitter::Water),
            Self::Wind => (FlowIn::Air, Emitter::Upwind),
            _ => (FlowIn::Everywhere, Emitter::Sky),
        };
        let strikes = matches!(self, Self::Coastal | Self::Karst | Self::Tunnel | Self::Wind);
        Preset {
            particles,
            iterations,
            radius,
            restitution,
            density,
            capacity: 0.01 * capacity,
            erosion: if strikes { 2e-3 } else { 1e-4 } * erosion,
            deposition: 0.1 * deposition,
            initial_load: if self == Self::Volcano { 0.1 } else { 0.0 },
            flow_in,
            emitter,
        }
    }
}
