//! The format of Therion.

use super::{Survey, Words};

const WORDS: Words = Words {
    command: "    ",
    row: "    ",
    walls: "dimensions",
    entrance: |station, kind| format!("station {station} \"{kind}\" entrance"),
};

/// The survey as the text of a `.th` file: one centreline.
pub(super) fn text(survey: &Survey<'_>) -> String {
    let title = survey.plain_title();
    let system = survey.epsg.map_or_else(String::new, |epsg| format!("    cs EPSG:{epsg}\n"));
    let lines = survey.centreline(&WORDS);
    format!("encoding utf-8\nsurvey cave -title \"{title}\"\n  centreline\n{system}{lines}  endcentreline\nendsurvey\n")
}
