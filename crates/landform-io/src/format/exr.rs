//! OpenEXR: one float32 channel of real metres.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, MetaData, ReadChannels, ReadLayers,
    Text, WritableImage, read as exr_read,
};
use landform_core::grid::Shape;
use landform_core::{Error, Result};

use super::said::Stored;
use super::{RasterFile, Sidecar, check_dimensions};

const NAME: &str = "OpenEXR";

pub(super) fn read(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
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
        .all_layers()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))
        .map_err(fail)?;
    let channels = image.layer_data.iter().flat_map(|l| l.channel_data.list.iter().map(move |c| (l, c)));
    let names: Vec<String> = channels.clone().map(|(_, c)| c.name.to_string()).collect();
    let taken = (0..names.len()).min_by_key(|&k| rank(&names[k])).filter(|&k| rank(&names[k]) < ALPHA);
    let Some((layer, channel)) = taken.and_then(|k| channels.clone().nth(k)) else {
        return Err(Error::format(NAME, format!("it has no channel of heights (channels: {})", names.join(", "))));
    };
    let shape = Shape::new(layer.size.height(), layer.size.width());
    let values = |c: &AnyChannel<FlatSamples>| -> Result<Vec<f64>> {
        if c.sample_data.len() != shape.len() {
            return Err(Error::format(NAME, "its channel is subsampled"));
        }
        Ok(c.sample_data.values_as_f32().map(f64::from).collect())
    };
    let alpha = layer.channel_data.list.iter().find(|c| last_name(&c.name.to_string()).eq_ignore_ascii_case("A"));
    let alpha = alpha.map(values).transpose()?.map(|a| a.into_iter().map(|a| a > 0.0).collect::<Vec<_>>());
    let mut stored = Stored::bare(shape, values(channel)?);
    // A picture that is nowhere opaque says nothing by it.
    stored.valid = alpha.filter(|a| a.contains(&true));
    if names.len() > 1 && !["Y", "R"].contains(&channel.name.to_string().as_str()) {
        stored.notes.push(format!("channel {} of {} is taken", channel.name, names.join(", ")));
    }
    Ok(stored)
}

/// The rank of a channel that holds no heights.
const ALPHA: usize = 4;

/// The lower, the more likely a channel holds heights: by its name, after that of its layer.
fn rank(name: &str) -> usize {
    let name = last_name(name).to_uppercase();
    match name.as_str() {
        "Y" | "HEIGHT" | "ELEVATION" | "DISPLACEMENT" => 0,
        "R" => 1,
        "Z" => 2,
        "A" | "AR" | "AG" | "AB" | "ALPHA" => ALPHA,
        _ => 3,
    }
}

fn last_name(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or(name)
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

/// Words of 32 bits, bit by bit as the floats of one channel, red.
///
/// # Errors
/// [`Error::Format`].
pub(crate) fn write_words(words: &[u32], shape: Shape) -> Result<Vec<u8>> {
    write_samples(words.iter().map(|&w| f32::from_bits(w)).collect(), shape, &["R"], "control")
}

fn write_channels(file: &RasterFile, names: &[&str]) -> Result<Vec<u8>> {
    let samples = file.values.iter().map(|&v| v as f32).collect();
    write_samples(samples, file.grid.shape, names, "elevation")
}

fn write_samples(samples: Vec<f32>, shape: Shape, names: &[&str], layer: &str) -> Result<Vec<u8>> {
    let channel = |name: &&str| AnyChannel::new(Text::new_or_panic(name), FlatSamples::F32(samples.clone()));
    let channels = AnyChannels::sort(names.iter().map(channel).collect());
    let attributes = LayerAttributes::named(Text::new_or_panic(layer));
    let layer = Layer::new((shape.cols, shape.rows), attributes, Encoding::SMALL_LOSSLESS, channels);
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).map_err(|e| Error::format(NAME, e))?;
    Ok(bytes.into_inner())
}
