//! The format of Therion.

use std::fmt::Write;

use super::{Survey, walls};

/// The survey as the text of a `.th` file: one centreline.
pub(super) fn text(survey: &Survey<'_>) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let mut line = |l: &str| {
        let _ = writeln!(text, "{l}");
    };
    line("encoding utf-8");
    let title = survey.title.replace(['"', '\n', '\r'], " ");
    line(&format!("survey cave -title \"{title}\""));
    line("  centreline");
    if let Some(epsg) = survey.epsg {
        line(&format!("    cs EPSG:{epsg}"));
    }
    for &station in &survey.fixed {
        line(&format!("    fix {} {}", station + 1, survey.place(station).join(" ")));
    }
    for (station, word) in &survey.entrances {
        line(&format!("    station {} \"{word}\" entrance", station + 1));
    }
    line("    data cartesian from to easting northing altitude");
    for &leg in &survey.legs {
        line(&format!("    {} {} {}", leg[0] + 1, leg[1] + 1, survey.leg(leg).join(" ")));
    }
    for passage in &survey.passages {
        line("    data dimensions station left right up down");
        passage.iter().for_each(|(station, p)| line(&format!("    {} {}", station + 1, walls(*p))));
    }
    line("  endcentreline");
    line("endsurvey");
    text
}
