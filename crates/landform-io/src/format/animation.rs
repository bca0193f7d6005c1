//! Moving pictures: GIF (256 colours a frame) and APNG (all of them).

use image::codecs::gif::{GifEncoder, Repeat};
use image::{Delay, Frame, RgbaImage};
use landform_core::grid::Shape;
use landform_core::{Error, Result};

/// Milliseconds that a frame is shown.
const FRAME: u32 = 120;

/// Pixels of a frame: 8-bit red, green, blue, row-major from the top.
type Pixels = [[u8; 3]];

/// An animation that plays for ever, as the extension of `path` says: gif, or png and apng.
///
/// # Errors
/// [`Error::Parameter`] for another extension, [`Error::Format`] for frames that differ in size, or none.
pub fn encode_animation(path: &str, shape: Shape, frames: &[&Pixels]) -> Result<Vec<u8>> {
    if frames.is_empty() {
        return Err(Error::format("animation", "it has no frames"));
    }
    if frames.iter().any(|f| f.len() != shape.len()) {
        return Err(Error::format("animation", "its frames differ in size"));
    }
    match animation_extension(path)? {
        "gif" => gif(shape, frames),
        _ => apng(shape, frames),
    }
}

/// The extension of an animation's path.
///
/// # Errors
/// [`Error::Parameter`] if it is none of gif, png, apng.
pub fn animation_extension(path: &str) -> Result<&'static str> {
    let lower = path.to_lowercase();
    ["gif", "apng", "png"].into_iter().find(|e| lower.ends_with(&format!(".{e}"))).ok_or_else(|| {
        Error::parameter("animation", format!("\"{path}\""), "a name that ends with .gif, .png or .apng")
    })
}

fn gif(shape: Shape, frames: &[&Pixels]) -> Result<Vec<u8>> {
    let fail = |e: image::ImageError| Error::format("GIF", e);
    let mut bytes = Vec::new();
    let mut encoder = GifEncoder::new_with_speed(&mut bytes, 10);
    encoder.set_repeat(Repeat::Infinite).map_err(fail)?;
    for frame in frames {
        let pixels = frame.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect();
        let image = RgbaImage::from_raw(shape.cols as u32, shape.rows as u32, pixels)
            .ok_or_else(|| Error::format("GIF", "a frame has too few pixels"))?;
        let delay = Delay::from_numer_denom_ms(FRAME, 1);
        encoder.encode_frame(Frame::from_parts(image, 0, 0, delay)).map_err(fail)?;
    }
    drop(encoder);
    Ok(bytes)
}

fn apng(shape: Shape, frames: &[&Pixels]) -> Result<Vec<u8>> {
    let fail = |e: png::EncodingError| Error::format("APNG", e);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, shape.cols as u32, shape.rows as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_animated(frames.len() as u32, 0).map_err(fail)?;
    encoder.set_frame_delay(FRAME as u16, 1000).map_err(fail)?;
    let mut writer = encoder.write_header().map_err(fail)?;
    for frame in frames {
        writer.write_image_data(frame.as_flattened()).map_err(fail)?;
    }
    writer.finish().map_err(fail)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_kinds_hold_every_frame() {
        let shape = Shape::new(6, 9);
        let pixels = [0, 60, 120].map(|v: u8| vec![[v, 2 * v, 255 - v]; 54]);
        let frames: Vec<&Pixels> = pixels.iter().map(Vec::as_slice).collect();
        let gif = encode_animation("a.gif", shape, &frames).unwrap();
        let decoder = image::codecs::gif::GifDecoder::new(std::io::Cursor::new(&gif)).unwrap();
        assert_eq!(image::ImageDecoder::dimensions(&decoder), (9, 6));
        assert_eq!(image::AnimationDecoder::into_frames(decoder).count(), 3);
        let apng = encode_animation("a.png", shape, &frames).unwrap();
        let reader = png::Decoder::new(std::io::Cursor::new(apng)).read_info().unwrap();
        assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
        assert!(encode_animation("a.mp4", shape, &frames).unwrap_err().to_string().contains(".gif"));
        assert!(encode_animation("a.gif", shape, &[]).is_err());
    }
}
