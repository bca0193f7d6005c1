//! The recipe's text: the whole truth, of which one value changes at a time.

mod blocks;
mod edit;
mod history;
mod json;

pub(crate) use blocks::{Block, blocks};
pub(crate) use edit::{Key, Spot, insert, only_ground, relocate, remove, set, toggle};
pub(crate) use history::History;
pub(crate) use json::of_item;
