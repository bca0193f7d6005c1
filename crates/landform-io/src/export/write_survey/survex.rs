//! The format of Survex.

use std::fmt::Write;

use super::{Survey, walls};

/// The survey as the text of a `.svx` file: cartesian legs, passages, fixed points, entrances.
pub(super) fn text(survey: &Survey<'_>) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let mut line = |l: &str| {
        let _ = writeln!(text, "{l}");
    };
    let title = survey.title.replace(['"', '\n', '\r'], " ");
    if !title.is_empty() {
        line(&format!("*title \"{title}\""));
    }
    line("*begin cave");
    if let Some(epsg) = survey.epsg {
        line(&format!("*cs EPSG:{epsg}"));
        line(&format!("*cs out EPSG:{epsg}"));
    }
    for &station in &survey.fixed {
        line(&format!("*fix {} {}", station + 1, survey.place(station).join(" ")));
    }
    for (station, word) in &survey.entrances {
        line(&format!("*entrance {} ; {word}", station + 1));
    }
    line("*data cartesian from to easting northing altitude");
    for &leg in &survey.legs {
        line(&format!("{} {} {}", leg[0] + 1, leg[1] + 1, survey.leg(leg).join(" ")));
    }
    for passage in &survey.passages {
        line("*data passage station left right up down");
        passage.iter().for_each(|(station, p)| line(&format!("{} {}", station + 1, walls(*p))));
    }
    line("*end cave");
    text
}
