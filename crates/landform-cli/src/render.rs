//! `landform render`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::core::Error;
use landform::core::units::{Angle, Length};
use landform::core::verb::Params;
use landform::io::export::{ViewKind, WritePicture};
use landform::io::files::write_whole;
use landform::io::format::{Reading, encode_png, read_raster};

use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Elevation file.
    input: PathBuf,
    /// Picture to write (.png).
    output: PathBuf,
    /// View that is drawn.
    #[arg(long, value_enum, default_value_t = Kind::Perspective)]
    view: Kind,
    /// Length of the longer side, pixels.
    #[arg(long, default_value_t = 1600)]
    size: usize,
    /// Compass direction from which the camera looks, such as "200 deg".
    #[arg(long, allow_hyphen_values = true)]
    from: Option<String>,
    /// Angle by which the camera looks down, such as "28 deg". In the land it is one that shows the
    /// skyline, if not given.
    #[arg(long, allow_hyphen_values = true)]
    tilt: Option<String>,
    /// Landscape only: place of the eye from the south-west corner, such as "2 km,1500 m".
    #[arg(long)]
    standpoint: Option<String>,
    /// Landscape only: height of the eye over the ground, such as "20 m".
    #[arg(long)]
    eye_height: Option<String>,
    /// Factor on elevations.
    #[arg(long, default_value_t = 1.0)]
    exaggeration: f64,
    /// Zoom factor: with 1 the whole block is in view; larger values come closer.
    #[arg(long, default_value_t = 1.0)]
    zoom: f64,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Kind {
    Map,
    Perspective,
    Landscape,
    Spectrum,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let defaults = WritePicture::default();
    let angle = |text: &Option<String>, default| text.as_deref().map_or(Ok(default), Angle::parse);
    let picture = WritePicture {
        view: match args.view {
            Kind::Map => ViewKind::Map,
            Kind::Perspective => ViewKind::Perspective,
            Kind::Landscape => ViewKind::Landscape,
            Kind::Spectrum => ViewKind::Spectrum,
        },
        path: args.output.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default(),
        size: args.size,
        view_from: angle(&args.from, defaults.view_from)?,
        tilt: args.tilt.as_deref().map(Angle::parse).transpose()?,
        standpoint: args.standpoint.as_deref().map(place).transpose()?,
        eye_height: args.eye_height.as_deref().map(Length::parse).transpose()?,
        exaggeration: args.exaggeration,
        zoom: args.zoom,
        ..defaults
    };
    picture.validate()?;
    let Reading { field: terrain, notes } = read_raster(&args.input)?;
    for note in &notes {
        say!("note: {note}");
    }
    let drawn = picture.draw(&terrain)?;
    write_whole(&args.output, &encode_png(&drawn.pixels, drawn.shape)?)?;
    say!("{}", args.output.display());
    Ok(ExitCode::SUCCESS)
}

/// Two lengths with a comma between them.
fn place(text: &str) -> landform::core::Result<[Length; 2]> {
    match text.split_once(',') {
        Some((x, y)) => Ok([Length::parse(x.trim())?, Length::parse(y.trim())?]),
        None => Err(Error::parameter("standpoint", format!("\"{text}\""), "two lengths, such as \"2 km,1500 m\"")),
    }
}
