//! PNM pictures as they are stored: numbers up to a greatest one of any size.
//!
//! # Sources
//! Netpbm, formats PGM (P5, plain P2) and PPM (P6, plain P3).

use landform_core::grid::Shape;
use landform_core::{Error, Result};

use super::check_dimensions;
use super::pixels::Pixels;

const NAME: &str = "PNM";

/// Reads a picture.
///
/// # Errors
/// [`Error::Format`].
pub(super) fn read(bytes: &[u8]) -> Result<Pixels> {
    let (colours, is_plain) = match bytes.get(..2) {
        Some(b"P2") => (1, true),
        Some(b"P3") => (3, true),
        Some(b"P5") => (1, false),
        Some(b"P6") => (3, false),
        _ => return Err(Error::format(NAME, "it begins with none of P2, P3, P5 and P6")),
    };
    let mut words = Words { rest: bytes.get(2..).unwrap_or_default() };
    let mut number = |name: &str| words.number().ok_or_else(|| Error::format(NAME, format!("it has no {name}")));
    let (cols, rows, greatest) = (number("width")?, number("height")?, number("greatest value")?);
    check_dimensions(NAME, u64::from(rows), u64::from(cols), colours, bytes.len())?;
    let greatest = u16::try_from(greatest).ok().filter(|g| *g > 0);
    let greatest = greatest.ok_or_else(|| Error::format(NAME, "its greatest value is not within 1 and 65535"))?;
    let shape = Shape::new(rows as usize, cols as usize);
    let count = shape.len() * colours as usize;
    let samples: Vec<u16> = if is_plain {
        std::iter::from_fn(|| words.number()).take(count).map(|v| u16::try_from(v).unwrap_or(u16::MAX)).collect()
    } else {
        // One white space ends the header.
        let data = words.rest.get(1..).unwrap_or_default();
        if greatest < 256 {
            data.iter().take(count).map(|b| u16::from(*b)).collect()
        } else {
            data.chunks_exact(2).take(count).map(|b| u16::from_be_bytes([b[0], b[1]])).collect()
        }
    };
    if samples.len() < count {
        return Err(Error::format(
            NAME,
            format!("it has {} samples of {count} ({cols} x {rows}): truncated", samples.len()),
        ));
    }
    Ok(Pixels { shape, colours: colours as usize, has_opacity: false, samples, greatest })
}

struct Words<'a> {
    rest: &'a [u8],
}

impl Words<'_> {
    /// The next whole number, past white space and comments.
    fn number(&mut self) -> Option<u32> {
        loop {
            let blank = self.rest.iter().take_while(|b| b.is_ascii_whitespace()).count();
            self.rest = self.rest.get(blank..)?;
            if self.rest.first() != Some(&b'#') {
                break;
            }
            let line = self.rest.iter().take_while(|b| **b != b'\n').count();
            self.rest = self.rest.get(line..)?;
        }
        let digits = self.rest.iter().take_while(|b| b.is_ascii_digit()).count();
        let (word, rest) = self.rest.split_at_checked(digits)?;
        self.rest = rest;
        std::str::from_utf8(word).ok()?.parse().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stay_as_stored_whatever_the_greatest_is() {
        for (bytes, greatest, last) in [
            (&b"P2\n# a comment\n2 2 1000\n0 1 2\n880\n"[..], 1_000, 880),
            (b"P5 2 2 100\n\x00\x01\x02\x58", 100, 88),
            (b"P5\n2 2\n1000\n\0\0\0\x01\0\x02\x03\x70", 1_000, 880),
        ] {
            let found = read(bytes).unwrap();
            assert_eq!((found.shape, found.greatest), (Shape::new(2, 2), greatest));
            assert_eq!(found.samples, [0, 1, 2, last]);
        }
        for bytes in
            [&b"P5"[..], b"P5 2 2", b"P5 2 2 255\n1", b"P2 2 2 255 1 2 3", b"P5 0 2 255\n", b"P5 2 2 70000\n12345678"]
        {
            assert!(read(bytes).is_err());
        }
    }
}
