//! `landform convert`.

use std::path::PathBuf;
use std::process::ExitCode;

use landform::core::terrain::NodeSurface;
use landform::io::files::write_whole;
use landform::io::format::{
    DataType, RasterFile, Reading, blurred, mesh_file_from_height_field, mesh_format, raster_format_to_write,
    read_raster, sidecar_path,
};

use crate::show_error::Failure;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Raster to read.
    input: PathBuf,
    /// Raster or mesh (glb, obj, ply, stl) to write; the extension sets the format.
    output: PathBuf,
}

pub(crate) fn run(args: &Args) -> Result<ExitCode, Failure> {
    let mesh = mesh_format(&args.output);
    let raster = raster_format_to_write(&args.output);
    if let (Err(_), Err(unknown)) = (&mesh, &raster) {
        let hint = "for a mesh: glb, obj, ply, stl".to_string();
        return Err(landform::core::Error::Recipe { at: None, what: unknown.to_string(), hint: Some(hint) }.into());
    }
    let Reading { field: terrain, notes } = read_raster(&args.input)?;
    for note in &notes {
        say!("note: {note}");
    }
    let as_read = RasterFile::real(terrain.grid(), terrain.elevation(), "elevation", "m", 0);
    if let Some(note) = blurred(&args.output.display().to_string(), &as_read) {
        say!("note: {note}");
    }
    if let Ok(format) = mesh {
        let file = mesh_file_from_height_field(&terrain);
        if file.triangles.is_empty() {
            return Err(landform::core::Error::NoFace { what: "the surface" }.into());
        }
        write_whole(&args.output, &(format.write)(&file)?)?;
    } else {
        let format = raster?;
        let mut file = as_read;
        if file.needs_float64(1e-6) {
            file.geotiff.data_type = DataType::Float64;
        }
        write_whole(&args.output, &(format.write)(&file)?)?;
        if let Some(sidecar) = format.sidecar(&file) {
            let beside = sidecar_path(&args.output.display().to_string());
            write_whole(beside.as_ref(), &sidecar.text()?)?;
        }
    }
    say!("{}", args.output.display());
    Ok(ExitCode::SUCCESS)
}
