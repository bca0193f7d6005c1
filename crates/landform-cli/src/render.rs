//! `landform render`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::core::units::Angle;
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
    /// Angle by which the camera looks down, such as "28 deg".
    #[arg(long, allow_hyphen_values = true)]
    tilt: Option<String>,
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
    Spectrum,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let defaults = WritePicture::default();
    let angle = |text: &Option<String>, default| text.as_deref().map_or(Ok(default), Angle::parse);
    let picture = WritePicture {
        view: match args.view {
            Kind::Map => ViewKind::Map,
            Kind::Perspective => ViewKind::Perspective,
            Kind::Spectrum => ViewKind::Spectrum,
        },
        path: args.output.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default(),
        size: args.size,
        view_from: angle(&args.from, defaults.view_from)?,
        tilt: angle(&args.tilt, defaults.tilt)?,
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
