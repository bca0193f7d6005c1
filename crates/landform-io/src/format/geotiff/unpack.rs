//! Strips and tiles, unpacked.

use std::io::Read;

use landform_core::{Error, Result};

use super::NAME;

/// Ways of packing, by the number in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Packing {
    None,
    Lzw,
    Deflate,
    PackBits,
    Zstd,
    /// Pictures: left to the `tiff` crate.
    Jpeg,
}

impl Packing {
    /// By its number.
    ///
    /// # Errors
    /// [`Error::Format`] with the way out.
    pub(super) fn of(number: u16) -> Result<Self> {
        let name = match number {
            1 => return Ok(Self::None),
            5 => return Ok(Self::Lzw),
            8 | 32_946 => return Ok(Self::Deflate),
            32_773 => return Ok(Self::PackBits),
            50_000 => return Ok(Self::Zstd),
            7 => return Ok(Self::Jpeg),
            2..=4 => " (fax)",
            6 => " (old JPEG)",
            34_712 | 33_003..=33_005 => " (JPEG 2000)",
            34_887 => " (LERC)",
            34_925 => " (LZMA)",
            50_001 => " (WebP)",
            50_002 | 52_546 => " (JPEG XL)",
            _ => "",
        };
        Err(Error::Format {
            format: NAME,
            what: format!(
                "its compression {number}{name} is not read; expected none, LZW, deflate, PackBits, ZSTD or JPEG"
            ),
            hint: Some("pack it otherwise first: gdal_translate -co COMPRESS=DEFLATE in.tif out.tif".into()),
        })
    }

    /// The first `wanted` bytes of what was packed.
    ///
    /// # Errors
    /// [`Error::Format`] where it is damaged or too short.
    pub(super) fn unpack(self, bytes: &[u8], wanted: usize) -> Result<Vec<u8>> {
        let found = match self {
            Self::None | Self::Jpeg => bytes.get(..wanted).map(<[u8]>::to_vec).unwrap_or_default(),
            Self::Deflate => read(flate2::read::ZlibDecoder::new(bytes), wanted)?,
            Self::Zstd => read(ruzstd::decoding::StreamingDecoder::new(bytes).map_err(damaged)?, wanted)?,
            Self::PackBits => pack_bits(bytes, wanted),
            Self::Lzw => lzw(bytes, wanted)?,
        };
        if found.len() < wanted {
            return Err(Error::format(NAME, "it ends before its data does: truncated"));
        }
        Ok(found)
    }
}

fn damaged(error: impl std::fmt::Display) -> Error {
    Error::format(NAME, format!("its data are damaged: {error}"))
}

fn read(source: impl Read, wanted: usize) -> Result<Vec<u8>> {
    let mut found = Vec::new();
    source.take(wanted as u64).read_to_end(&mut found).map_err(damaged)?;
    Ok(found)
}

fn lzw(bytes: &[u8], wanted: usize) -> Result<Vec<u8>> {
    let mut decoder = weezl::decode::Decoder::with_tiff_size_switch(weezl::BitOrder::Msb, 8);
    let (mut found, mut rest) = (vec![0; wanted], bytes);
    let mut done = 0;
    while done < wanted {
        let step = decoder.decode_bytes(rest, &mut found[done..]);
        let status = step.status.map_err(damaged)?;
        done += step.consumed_out;
        rest = &rest[step.consumed_in..];
        if !matches!(status, weezl::LzwStatus::Ok) || step.consumed_in == 0 && step.consumed_out == 0 {
            break;
        }
    }
    found.truncate(done);
    Ok(found)
}

fn pack_bits(bytes: &[u8], wanted: usize) -> Vec<u8> {
    let mut found = Vec::new();
    let mut rest = bytes;
    while let Some((&head, after)) = rest.split_first() {
        if found.len() >= wanted {
            break;
        }
        rest = match head {
            0..=127 => {
                let (run, rest) = after.split_at((usize::from(head) + 1).min(after.len()));
                found.extend_from_slice(run);
                rest
            }
            128 => after,
            129.. => {
                let Some((&value, rest)) = after.split_first() else { break };
                found.resize(found.len() + 257 - usize::from(head), value);
                rest
            }
        };
    }
    found.truncate(wanted);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_and_words_are_unpacked() {
        // The example of the specification.
        let packed = [0xFE, 0xAA, 0x02, 0x80, 0x00, 0x2A, 0xFD, 0xAA, 0x03, 0x80, 0x00, 0x2A, 0x22, 0xF7, 0xAA];
        let found = Packing::PackBits.unpack(&packed, 24).unwrap();
        assert_eq!((found[..6].to_vec(), found[23]), (vec![0xAA, 0xAA, 0xAA, 0x80, 0x00, 0x2A], 0xAA));
        assert!(Packing::PackBits.unpack(&packed[..4], 24).is_err());
    }

    #[test]
    fn unknown_packings_are_named_with_the_way_out() {
        let error = Packing::of(34_887).unwrap_err();
        assert!(error.to_string().contains("compression 34887 (LERC)"), "{error}");
        assert!(error.hint().unwrap().contains("COMPRESS=DEFLATE"));
        assert!(Packing::of(12_345).is_err());
    }

    #[test]
    fn damage_is_an_error() {
        for packing in [Packing::None, Packing::Lzw, Packing::Deflate, Packing::PackBits, Packing::Zstd] {
            for bytes in [&[][..], &[0xFF; 3], &[0x28, 0xB5, 0x2F, 0xFD, 0, 0]] {
                assert!(packing.unpack(bytes, 1_000).is_err(), "{packing:?}");
            }
        }
    }
}
