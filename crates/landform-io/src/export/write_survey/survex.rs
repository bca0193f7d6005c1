//! The format of Survex.

use super::{Survey, Words};

const WORDS: Words =
    Words { command: "*", row: "", walls: "passage", entrance: |station, kind| format!("entrance {station} ; {kind}") };

/// The survey as the text of a `.svx` file: cartesian legs, passages, fixed points, entrances.
pub(super) fn text(survey: &Survey<'_>) -> String {
    let title = survey.plain_title();
    let title = if title.is_empty() { String::new() } else { format!("*title \"{title}\"\n") };
    let system = survey.epsg.map_or_else(String::new, |epsg| format!("*cs EPSG:{epsg}\n*cs out EPSG:{epsg}\n"));
    format!("{title}*begin cave\n{system}{}*end cave\n", survey.centreline(&WORDS))
}
