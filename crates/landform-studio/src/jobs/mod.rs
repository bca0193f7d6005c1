//! What is computed: previews, charts, builds.

mod background;
mod charts;
mod control;
mod layers;
mod order;
mod paint;
mod sea;
mod state;
mod watching;
mod worker;

pub(crate) use background::{Background, Task, Work};
pub(crate) use charts::Charts;
pub(crate) use order::{Order, halved};
pub(crate) use paint::{Piece, Tool};
pub(crate) use worker::Worker;

/// What a task comes to; a mistake of the program in it is an error, and the thread goes on.
fn whole<T>(task: impl FnOnce() -> landform::Result<T>) -> landform::Result<T> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(task)).unwrap_or_else(|_| {
        let what = "it broke off by a mistake of the program".into();
        Err(landform::Error::Recipe { at: None, what, hint: Some("please report it with the recipe".into()) })
    })
}
