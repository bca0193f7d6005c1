//! OpenEXR: one float32 channel of real metres.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, MetaData, ReadChannels, ReadLayers,
    Text, WritableImage, read as exr_read,
};
use landform_core::grid::Shape;
use landform_core::terrain::HeightField;
use landform_core::{Error, Result};

use super::{RasterFile, Sidecar, check_dimensions};

const NAME: &str = "OpenEXR";

pub(super) fn read(bytes: &[u8], sidecar: Option<&Sidecar>) -> Result<HeightField> {
    let fail = |e: exr::error::Error| Error::format(NAME, e);
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(fail)?;
    for header in &meta.headers {
        let size = header.layer_size;
        let per_pixel = header.channels.bytes_per_pixel as u64;
        check_dimensions(NAME, size.height() as u64, size.width() as u64, per_pixel, bytes.len())?;
    }
    let image = exr_read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))
        .map_err(fail)?;
    let layer = image.layer_data;
    let shape = Shape::new(layer.size.height(), layer.size.width());
    let channels = layer.channel_data.list;
    let channel = ["Y", "R", "Z"]
        .iter()
        .find_map(|name| channels.iter().find(|c| c.name == **name))
        .or_else(|| channels.first())
        .ok_or_else(|| Error::format(NAME, "it has no channel"))?;
    if channel.sample_data.len() != shape.len() {
        return Err(Error::format(NAME, "its channel is subsampled"));
    }
    let raw: Vec<f64> = channel.sample_data.values_as_f32().map(f64::from).collect();
    HeightField::new(Sidecar::grid(sidecar, shape)?, Sidecar::values(sidecar, raw.into_iter()))
}

pub(super) fn write(file: &RasterFile) -> Result<Vec<u8>> {
    write_channels(file, &["Y"])
}

/// The values three times, as red, green and blue: for readers that take grey for something else.
///
/// # Errors
/// [`Error::Format`].
pub(crate) fn write_rgb(file: &RasterFile) -> Result<Vec<u8>> {
    write_channels(file, &["R", "G", "B"])
}

fn write_channels(file: &RasterFile, names: &[&str]) -> Result<Vec<u8>> {
    let shape = file.grid.shape;
    let samples: Vec<f32> = file.values.iter().map(|&v| v as f32).collect();
    let channel = |name: &&str| AnyChannel::new(Text::new_or_panic(name), FlatSamples::F32(samples.clone()));
    let channels = AnyChannels::sort(names.iter().map(channel).collect());
    let attributes = LayerAttributes::named(Text::new_or_panic("elevation"));
    let layer = Layer::new((shape.cols, shape.rows), attributes, Encoding::SMALL_LOSSLESS, channels);
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).map_err(|e| Error::format(NAME, e))?;
    Ok(bytes.into_inner())
}
