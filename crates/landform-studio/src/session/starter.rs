//! The text that a new step begins with.

use std::fmt::Write;

use landform::core::error::nearest;
use landform::core::stage::Verb;
use landform::recipe::stages;
use landform::{Error, Result};

/// A clock to begin with.
const CLOCK: &str = "clock = { dt = \"10 kyr\", duration = \"1 Myr\" }\n";

/// Lines of a new step, below its header; within an `evolve` it has no clock of its own.
///
/// # Errors
/// [`Error::Recipe`] if there is no such stage, or it is no process where one is wanted.
pub(crate) fn of(name: &str, within: bool) -> Result<String> {
    if name == "evolve" && !within {
        let process = "process = [\n  { use = \"uplift\", rate = \"0.5 mm/yr\" },\n  { use = \"stream_power\" },\n]\n";
        return Ok(format!("use = \"evolve\"\n{CLOCK}{process}"));
    }
    let Some(stage) = stages().find(|stage| stage.name == name) else {
        let hint = nearest(name, stages().map(|stage| stage.name)).map(|near| format!("did you mean `{near}`?"));
        return Err(Error::Recipe { at: None, what: format!("stage `{name}` is not known"), hint });
    };
    if within && stage.verb != Verb::Process {
        let what = format!("`{name}` is no process: it cannot stand in `evolve`");
        return Err(Error::Recipe { at: None, what, hint: None });
    }
    let mut text = format!("use = \"{name}\"\n");
    let has_clock = stage.read(&(stage.form.defaults)()).is_ok_and(|read| read.own_clock().is_some());
    if stage.verb == Verb::Process && !within && !has_clock {
        // Writing to a text cannot fail.
        let _ = write!(text, "{CLOCK}");
    }
    Ok(text)
}
