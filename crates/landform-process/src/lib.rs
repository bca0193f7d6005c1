//! Processes that change a terrain: one folder per phenomenon.
//!
//! A phenomenon may use `landform-core` and nothing beside it here; two that must interact are
//! coupled by a recipe.

pub mod automaton;
pub mod bank;
pub mod basin;
pub mod cave;
pub mod channel;
pub mod coast;
pub mod dune;
pub mod edit;
pub mod generate;
pub mod hillslope;
pub mod karst;
pub mod mechanism;
pub mod particles;
pub mod reef;
pub mod snow;
pub mod stream_power;
pub mod streams;
pub mod uplift;
pub mod volume;

/// The rows of all phenomena.
pub static STAGES: &[&[landform_core::stage::Stage]] = &[
    generate::STAGES,
    edit::STAGES,
    uplift::STAGES,
    stream_power::STAGES,
    bank::STAGES,
    hillslope::STAGES,
    channel::STAGES,
    coast::STAGES,
    dune::STAGES,
    snow::STAGES,
    reef::STAGES,
    streams::STAGES,
    automaton::STAGES,
    basin::STAGES,
    karst::STAGES,
    volume::STAGES,
    cave::STAGES,
    particles::STAGES,
];
