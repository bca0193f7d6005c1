//! One container for checkpoints and the cache: compressed, versioned, checksummed, named.
//!
//! Layout: 8 bytes magic, 32 bytes SHA-256 of the rest, then kind and key (each a byte of length
//! and text), then the payload (postcard) as an LZ4 frame, written as it is made, so that no second
//! copy of the value stands in memory. Floats keep every bit. Anything foreign, truncated or
//! changed is an error that says so.

use lz4_flex::frame::{FrameDecoder, FrameEncoder};
use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

use crate::{Error, Result};

const MAGIC: &[u8; 8] = b"LANDFRM2";
const FORMAT: &str = "landform state";

/// A value as a container's bytes; `kind` and `key` say what it is and what it belongs to.
///
/// # Errors
/// [`Error::Format`] if the value cannot be encoded.
pub fn pack(kind: &str, key: &str, value: &impl Serialize) -> Result<Vec<u8>> {
    const SUM: std::ops::Range<usize> = 8..40;
    let mut bytes = MAGIC.to_vec();
    bytes.resize(SUM.end, 0);
    for text in [kind, key] {
        bytes.push(u8::try_from(text.len()).map_err(|_| Error::format(FORMAT, "a name is too long"))?);
        bytes.extend(text.as_bytes());
    }
    let frame = postcard::to_io(value, FrameEncoder::new(&mut bytes)).map_err(|e| Error::format(FORMAT, e))?;
    frame.finish().map_err(|e| Error::format(FORMAT, e))?;
    let sum = Sha256::digest(&bytes[SUM.end..]);
    bytes[SUM].copy_from_slice(&sum);
    Ok(bytes)
}

/// Whether bytes carry this kind and key, if they are whole and undamaged. The first few hundred
/// will do.
pub fn is_for(kind: &str, key: &str, bytes: &[u8]) -> bool {
    let names: Vec<u8> = [kind, key].iter().flat_map(|t| std::iter::once(t.len() as u8).chain(t.bytes())).collect();
    bytes.get(40..).is_some_and(|body| body.starts_with(&names))
}

/// What follows the checksum of a container, of whatever kind.
///
/// # Errors
/// [`Error::Format`] that says whether the bytes are foreign or damaged.
pub fn undamaged(bytes: &[u8]) -> Result<&[u8]> {
    let fail = |what: &str| Err(Error::format(FORMAT, what));
    let Some(rest) = bytes.strip_prefix(MAGIC) else {
        return fail("it was not written by this version of landform");
    };
    let Some((sum, body)) = rest.split_at_checked(32) else {
        return fail("it is truncated");
    };
    if Sha256::digest(body).as_slice() != sum {
        return fail("it is truncated or damaged");
    }
    Ok(body)
}

/// The value in a container that [`pack`] made with the same kind and key. A first part of the
/// value may be read alone.
///
/// # Errors
/// [`Error::Format`] that says whether the bytes are foreign, damaged, or belong to something else.
pub fn unpack<T: DeserializeOwned>(kind: &str, key: &str, bytes: &[u8]) -> Result<T> {
    let fail = |what: &str| Err(Error::format(FORMAT, what));
    let mut rest = undamaged(bytes)?;
    for expected in [kind, key] {
        let text = rest.split_first().and_then(|(n, r)| r.split_at_checked(usize::from(*n)));
        match text {
            Some((text, after)) if text == expected.as_bytes() => rest = after,
            _ => return fail("it belongs to something else"),
        }
    }
    let mut text = vec![0; 1 << 20];
    let read = postcard::from_io((FrameDecoder::new(rest), &mut text));
    read.map(|(value, _)| value).map_err(|e| Error::format(FORMAT, e))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_is_unpacked_to_the_bit() {
        let value = (vec![1.0_f64, -0.0, 1e-310, f64::INFINITY], String::from("x"), 7_u32);
        let bytes = pack("test", "abc", &value).unwrap();
        let back: (Vec<f64>, String, u32) = unpack("test", "abc", &bytes).unwrap();
        assert!(value.0.iter().zip(&back.0).all(|(a, b)| a.to_bits() == b.to_bits()));
        assert_eq!((back.1, back.2), (value.1, value.2));
    }

    #[test]
    fn damage_of_any_byte_or_length_is_an_error() {
        let bytes = pack("test", "abc", &vec![1.0_f64; 40]).unwrap();
        for n in 0..bytes.len() {
            assert!(unpack::<Vec<f64>>("test", "abc", &bytes[..n]).is_err());
            let mut damaged = bytes.clone();
            damaged[n] ^= 0x10;
            assert!(unpack::<Vec<f64>>("test", "abc", &damaged).is_err());
        }
        assert!(unpack::<Vec<f64>>("test", "abd", &bytes).unwrap_err().to_string().contains("something else"));
        assert!(unpack::<Vec<f64>>("test", "abc", b"hello").is_err());
    }
}
