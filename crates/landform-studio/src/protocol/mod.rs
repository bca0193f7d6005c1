//! What the page and the server say to each other.

mod frame;
mod request;

pub(crate) use frame::{Band, Encoding, Frame, Layer, Stamp, bands};
pub(crate) use request::{Numbered, Request, read};
