//! The studio: a local server and the page that it shows.
//!
//! One session holds a recipe's text, runs previews of it and shows their ground to every page that
//! is open. Pages are views: what they show comes from the server, and a page that is loaded again
//! loses nothing. All runs are those of [`landform::recipe`].
//!
//! | module | holds |
//! |---|---|
//! | `text` | the recipe's text, changed one value at a time |
//! | `session` | the text with what it comes to; opening and saving |
//! | `jobs` | previews, charts, builds: a thread each |
//! | `hub` | pages that look on, and what is on its way to each |
//! | `protocol` | requests, and ground in numbers |
//! | `root` | the one folder that may be reached |
//! | `server` | who may come in; pages, files, the connection |
//! | `studio` | requests become edits and jobs |

mod hub;
mod jobs;
mod protocol;
mod root;
mod server;
mod session;
mod studio;
mod text;

pub use server::{Server, Settings};
