//! Numbers of a row of bytes.
//!
//! # Sources
//! TIFF 6.0, section 14 (differences), and Adobe's technical note 3 (floating-point predictor).

use landform_core::{Error, Result};

use super::NAME;

/// How samples are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Kind {
    /// Bits of a sample.
    bits: u16,
    /// 1 whole numbers without sign, 2 with sign, 3 real numbers.
    format: u16,
    /// 1 none, 2 differences, 3 differences of the bytes of real numbers.
    predictor: u16,
    /// Whether the most significant byte comes first.
    is_big: bool,
}

impl Kind {
    /// # Errors
    /// [`Error::Format`] for numbers that are not read.
    pub(super) fn new(bits: u16, format: u16, predictor: u16, is_big: bool) -> Result<Self> {
        // Undefined data is taken as whole numbers, as others do.
        let format = if format == 4 { 1 } else { format };
        let is_known = match format {
            1 => [1, 2, 4, 8, 16, 32, 64].contains(&bits),
            2 => [8, 16, 32, 64].contains(&bits),
            3 => [16, 32, 64].contains(&bits),
            _ => false,
        };
        let is_predicted = predictor == 1 || predictor == 2 && bits >= 8 || predictor == 3 && format == 3;
        if is_known && is_predicted {
            return Ok(Self { bits, format, predictor, is_big });
        }
        let what = match format {
            1 => "whole numbers",
            2 => "whole numbers with sign",
            3 => "real numbers",
            5 | 6 => "complex numbers",
            _ => "unknown samples",
        };
        Err(Error::Format {
            format: NAME,
            what: format!(
                "its {bits}-bit {what} with predictor {predictor} are not read; expected 8 to 64-bit integers or 16 to 64-bit floats"
            ),
            hint: Some("change their type first: gdal_translate -ot Float32 in.tif out.tif".into()),
        })
    }

    /// Bytes of a row of so many samples; none if that is absurd.
    pub(super) fn row_bytes(self, samples: usize) -> Option<usize> {
        samples.checked_mul(usize::from(self.bits)).map(|bits| bits.div_ceil(8))
    }

    /// Undoes the predictor of a row in place; samples of one pixel lie side by side.
    pub(super) fn undo_predictor(self, row: &mut [u8], bands: usize) {
        match (self.predictor, self.bits) {
            (3, _) => self.undo_bytes(row, bands),
            (2, 8) => add_up::<1>(row, bands, self.is_big),
            (2, 16) => add_up::<2>(row, bands, self.is_big),
            (2, 32) => add_up::<4>(row, bands, self.is_big),
            (2, 64) => add_up::<8>(row, bands, self.is_big),
            _ => {}
        }
    }

    /// All most significant bytes come first, then all others, as differences; afterwards numbers
    /// in the order of the file.
    fn undo_bytes(self, row: &mut [u8], bands: usize) {
        for k in bands..row.len() {
            row[k] = row[k].wrapping_add(row[k - bands]);
        }
        let size = usize::from(self.bits / 8);
        let (count, planes) = (row.len() / size, row.to_vec());
        for (i, number) in row.chunks_exact_mut(size).enumerate() {
            for (k, byte) in number.iter_mut().enumerate() {
                let plane = if self.is_big { k } else { size - 1 - k };
                *byte = planes[plane * count + i];
            }
        }
    }

    /// Every `step`-th sample from `first` on, at most `count`.
    pub(super) fn pick(self, row: &[u8], first: usize, step: usize, count: usize, out: &mut Vec<f64>) {
        if self.bits < 8 {
            let bits = usize::from(self.bits);
            let at = |k: usize| (row[k * bits / 8] >> (8 - bits - k * bits % 8)) & ((1 << bits) - 1);
            out.extend((0..count).map(|k| f64::from(at(first + k * step))));
            return;
        }
        let size = usize::from(self.bits / 8);
        let samples = row.chunks_exact(size).skip(first).step_by(step).take(count);
        let number = self.number();
        let is_big = self.is_big;
        out.extend(samples.map(|bytes| number(word(bytes, is_big))));
    }

    /// The number of the bits of a word.
    fn number(self) -> fn(u64) -> f64 {
        match (self.format, self.bits) {
            (2, 8) => |v| f64::from(v as u8 as i8),
            (2, 16) => |v| f64::from(v as u16 as i16),
            (2, 32) => |v| f64::from(v as u32 as i32),
            (2, _) => |v| v as i64 as f64,
            (3, 16) => |v| half(v as u16),
            (3, 32) => |v| f64::from(f32::from_bits(v as u32)),
            (3, _) => f64::from_bits,
            _ => |v| v as f64,
        }
    }
}

fn word(bytes: &[u8], is_big: bool) -> u64 {
    let join = |sum: u64, byte: &u8| sum << 8 | u64::from(*byte);
    if is_big { bytes.iter().fold(0, join) } else { bytes.iter().rev().fold(0, join) }
}

fn add_up<const N: usize>(row: &mut [u8], bands: usize, is_big: bool) {
    let (numbers, _) = row.as_chunks_mut::<N>();
    for k in bands..numbers.len() {
        let sum = word(&numbers[k], is_big).wrapping_add(word(&numbers[k - bands], is_big));
        for (i, byte) in numbers[k].iter_mut().enumerate() {
            let place = if is_big { N - 1 - i } else { i };
            *byte = (sum >> (8 * place)) as u8;
        }
    }
}

/// A real number of 16 bits.
pub(in crate::format) fn half(bits: u16) -> f64 {
    let sign = if bits & 0x8000 == 0 { 1.0 } else { -1.0 };
    let (exponent, fraction) = (bits >> 10 & 0x1F, f64::from(bits & 0x3FF) / 1_024.0);
    let power = |e: u16| f64::from(f32::from_bits((u32::from(e) + 112) << 23));
    match exponent {
        0 => sign * fraction * power(1),
        31 if fraction == 0.0 => sign * f64::INFINITY,
        31 => f64::NAN,
        e => sign * (1.0 + fraction) * power(e),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picked(kind: Kind, row: &[u8], first: usize, step: usize, count: usize) -> Vec<f64> {
        let mut out = Vec::new();
        kind.pick(row, first, step, count, &mut out);
        out
    }

    #[test]
    fn every_kind_of_number_is_read_in_both_orders() {
        let kind = |bits, format, is_big| Kind::new(bits, format, 1, is_big).unwrap();
        assert_eq!(picked(kind(16, 2, true), &[0xFF, 0xFE, 0, 7], 0, 1, 2), [-2.0, 7.0]);
        assert_eq!(picked(kind(16, 1, false), &[0xFE, 0xFF, 7, 0], 0, 1, 2), [65_534.0, 7.0]);
        assert_eq!(picked(kind(64, 2, false), &(-5_i64).to_le_bytes(), 0, 1, 1), [-5.0]);
        assert_eq!(picked(kind(64, 3, true), &2.5_f64.to_be_bytes(), 0, 1, 1), [2.5]);
        assert_eq!(picked(kind(16, 3, false), &[0x00, 0x3E], 0, 1, 1), [1.5]);
        assert_eq!(picked(kind(1, 1, false), &[0b1010_0000], 0, 1, 4), [1.0, 0.0, 1.0, 0.0]);
        assert_eq!(picked(kind(4, 1, false), &[0x2A, 0x70], 1, 2, 1), [10.0]);
        assert_eq!(picked(kind(8, 1, false), &[1, 2, 3, 4], 1, 2, 2), [2.0, 4.0]);
        for (bits, format) in [(24, 3), (64, 6), (12, 1), (8, 3), (0, 1)] {
            assert!(Kind::new(bits, format, 1, false).is_err(), "{bits} {format}");
        }
    }

    #[test]
    fn half_numbers_are_those_of_the_standard() {
        for (bits, value) in [
            (0x0000, 0.0),
            (0x3C00, 1.0),
            (0xC000, -2.0),
            (0x7BFF, 65_504.0),
            (0x0400, 6.103_515_625e-5),
            (0x0001, 5.960_464_477_539_063e-8),
        ] {
            assert_eq!(half(bits), value);
        }
        assert!(half(0x7C00).is_infinite() && half(0x7E00).is_nan());
    }

    #[test]
    fn differences_add_up_band_by_band() {
        for is_big in [false, true] {
            let kind = Kind::new(16, 1, 2, is_big).unwrap();
            let bytes = |v: u16| if is_big { v.to_be_bytes() } else { v.to_le_bytes() };
            let mut row: Vec<u8> = [100, 7, 5, 0, 65_535, 1].into_iter().flat_map(bytes).collect();
            kind.undo_predictor(&mut row, 2);
            assert_eq!(picked(kind, &row, 0, 2, 3), [100.0, 105.0, 104.0]);
            assert_eq!(picked(kind, &row, 1, 2, 3), [7.0, 7.0, 8.0]);
        }
    }

    #[test]
    fn planes_of_bytes_become_real_numbers_in_both_orders() {
        let values = [100.0_f32, 115.5, -2.25];
        // Most significant bytes of all numbers first, whatever the order of the file; then
        // differences.
        let planes: Vec<u8> = (0..4).flat_map(|k| values.map(|v| v.to_be_bytes()[k])).collect();
        let packed: Vec<u8> =
            (0..12).map(|i| if i == 0 { planes[0] } else { planes[i].wrapping_sub(planes[i - 1]) }).collect();
        for is_big in [false, true] {
            let kind = Kind::new(32, 3, 3, is_big).unwrap();
            let mut row = packed.clone();
            kind.undo_predictor(&mut row, 1);
            assert_eq!(picked(kind, &row, 0, 1, 3), values.map(f64::from));
        }
    }
}
