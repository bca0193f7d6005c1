//! Moving pictures: GIF (256 colours a frame) and APNG (all of them).

use gif::{DisposalMethod, Encoder, Frame, Repeat};
use landform_core::grid::Shape;
use landform_core::{Error, Result};

/// Milliseconds that a frame is shown.
const FRAME: u16 = 120;
/// How fast the 256 colours of a frame are chosen: 1 slow and good, 30 fast.
const SPEED: i32 = 10;

/// Pixels of a frame: 8-bit red, green, blue, row-major from the top.
type Pixels = [[u8; 3]];

/// An animation that plays for ever, as the extension of `path` says: gif, or png and apng.
///
/// # Errors
/// [`Error::Extension`] for another extension, [`Error::Format`] for frames that differ in size, or
/// none.
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
/// [`Error::Extension`] if it is none of gif, png, apng.
pub fn animation_extension(path: &str) -> Result<&'static str> {
    let lower = path.to_lowercase();
    let known = ["gif", "apng", "png"];
    let found = known.into_iter().find(|e| lower.ends_with(&format!(".{e}")));
    found.ok_or_else(|| Error::extension("animation", path, &known))
}

fn gif(shape: Shape, frames: &[&Pixels]) -> Result<Vec<u8>> {
    let fail = |e: gif::EncodingError| Error::format("GIF", e);
    let side = |n: usize| u16::try_from(n).map_err(|_| Error::format("GIF", "a side has more than 65535 pixels"));
    let (cols, rows) = (side(shape.cols)?, side(shape.rows)?);
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, cols, rows, &[]).map_err(fail)?;
    encoder.set_repeat(Repeat::Infinite).map_err(fail)?;
    for pixels in frames {
        let mut frame = Frame::from_rgb_speed(cols, rows, pixels.as_flattened(), SPEED);
        frame.delay = FRAME / 10;
        frame.dispose = DisposalMethod::Background;
        encoder.write_frame(&frame).map_err(fail)?;
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
    encoder.set_frame_delay(FRAME, 1000).map_err(fail)?;
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
        let mut decoder = gif::DecodeOptions::new().read_info(gif.as_slice()).unwrap();
        assert_eq!((decoder.width(), decoder.height()), (9, 6));
        let delays = std::iter::from_fn(|| decoder.read_next_frame().unwrap().map(|f| f.delay));
        assert_eq!(delays.collect::<Vec<_>>(), [12; 3]);
        let apng = encode_animation("a.png", shape, &frames).unwrap();
        let reader = png::Decoder::new(std::io::Cursor::new(apng)).read_info().unwrap();
        assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
        assert!(encode_animation("a.mp4", shape, &frames).unwrap_err().to_string().contains(".gif"));
        assert!(encode_animation("a.gif", shape, &[]).is_err());
    }
}
