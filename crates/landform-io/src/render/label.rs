//! Words on pictures, and legends of maps.

use font8x8::legacy::BASIC_LEGACY;

use super::colour::to_srgb;
use super::{Picture, Ramp};

/// Side of a letter before it is enlarged, pixels.
const LETTER: usize = 8;
/// Least columns of a picture that has room for a legend.
const LEAST_COLUMNS: usize = 300;

impl Picture {
    /// Writes a line of plain text into the lower left corner, light on a dark band. Text that does
    /// not fit is cut off; letters that the font lacks are left blank.
    pub fn label(&mut self, text: &str) {
        let scale = (self.shape.cols / 320).max(1);
        let (pad, size) = (2 * scale, LETTER * scale);
        let (height, width) = (size + 2 * pad, text.chars().count() * size + 2 * pad);
        if self.shape.rows < height {
            return;
        }
        let top = self.shape.rows - height;
        self.darken([top, 0], [height, width]);
        self.write(text, [top + pad, pad], scale);
    }

    /// Draws what the colours of a map mean into the lower right corner: a title, the ramp, and the
    /// values at its ends. A picture that is too small for it stays as it is.
    pub(crate) fn legend(&mut self, title: &str, ramp: Ramp, ends: [String; 2]) {
        let scale = (self.shape.cols / 700).max(1);
        let (pad, size) = (4 * scale, LETTER * scale);
        let letters = title.chars().count().max(ends[0].len() + 2 + ends[1].len());
        let (height, width) = (3 * size + 4 * pad, letters * size + 2 * pad);
        let Some([top, left]) = self.room_for([height, width]) else { return };
        self.darken([top, left], [height, width]);
        self.write(title, [top + pad, left + pad], scale);
        let bar = letters * size;
        for r in 0..size {
            let row = (top + 2 * pad + size + r) * self.shape.cols + left + pad;
            for c in 0..bar {
                self.pixels[row + c] = to_srgb(ramp.at(c as f64 / (bar - 1).max(1) as f64));
            }
        }
        let line = top + 3 * pad + 2 * size;
        self.write(&ends[0], [line, left + pad], scale);
        self.write(&ends[1], [line, left + pad + bar - ends[1].len() * size], scale);
    }

    fn room_for(&self, [height, width]: [usize; 2]) -> Option<[usize; 2]> {
        let has_room = self.shape.cols >= LEAST_COLUMNS && 3 * height < self.shape.rows && width < self.shape.cols;
        has_room.then(|| [self.shape.rows - height, self.shape.cols - width])
    }

    fn darken(&mut self, [top, left]: [usize; 2], [height, width]: [usize; 2]) {
        for r in top..(top + height).min(self.shape.rows) {
            let row = r * self.shape.cols;
            for pixel in &mut self.pixels[row + left..row + (left + width).min(self.shape.cols)] {
                *pixel = pixel.map(|v| v / 3);
            }
        }
    }

    fn write(&mut self, text: &str, [top, left]: [usize; 2], scale: usize) {
        let size = LETTER * scale;
        for (k, letter) in text.chars().enumerate() {
            let Some(glyph) = BASIC_LEGACY.get(letter as usize) else { continue };
            for (y, x) in (0..size).flat_map(|y| (0..size).map(move |x| (y, x))) {
                let (row, col) = (top + y, left + k * size + x);
                let is_ink = glyph[y / scale] >> (x / scale) & 1 == 1;
                if is_ink && row < self.shape.rows && col < self.shape.cols {
                    self.pixels[row * self.shape.cols + col] = [245; 3];
                }
            }
        }
    }
}

/// A number in three digits.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    if (1e-3..1e5).contains(&value.abs()) { format!("{rounded}") } else { format!("{rounded:e}") }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::Shape;

    use super::*;

    fn blank(rows: usize, cols: usize) -> Picture {
        Picture { shape: Shape::new(rows, cols), pixels: vec![[200; 3]; rows * cols] }
    }

    #[test]
    fn a_label_stays_in_its_corner() {
        let mut picture = blank(40, 100);
        picture.label("12.5 kyr");
        let changed: Vec<usize> = (0..4000).filter(|&i| picture.pixels[i] != [200; 3]).collect();
        assert!(changed.iter().all(|i| i / 100 >= 28 && i % 100 < 68) && changed.len() == 12 * 68);
        assert!(picture.pixels.iter().filter(|p| **p == [245; 3]).count() > 60);
        // Too long, and too low: no panic.
        picture.label(&"x".repeat(50));
        Picture { shape: Shape::new(3, 3), pixels: vec![[0; 3]; 9] }.label("no");
    }

    #[test]
    fn a_legend_shows_its_ramp_from_end_to_end() {
        let mut picture = blank(300, 400);
        picture.legend("discharge, m3/s", Ramp::Grey, [0.0, 1.25e6].map(short));
        let changed: Vec<usize> = (0..picture.pixels.len()).filter(|&i| picture.pixels[i] != [200; 3]).collect();
        assert!(changed.iter().all(|i| i / 400 >= 260 && i % 400 >= 272) && changed.len() == 40 * 128);
        let row = |c: usize| picture.pixels[276 * 400 + c];
        assert_eq!((row(276), row(395)), ([16; 3], [248; 3]));
        // No room: nothing changes.
        let mut small = blank(60, 299);
        small.legend("discharge, m3/s", Ramp::Grey, [0.0, 1.0].map(short));
        assert!(small.pixels.iter().all(|p| *p == [200; 3]));
    }

    #[test]
    fn numbers_of_a_legend_are_short() {
        for (value, text) in
            [(0.0, "0"), (1234.56, "1230"), (0.012_345, "0.0123"), (-3.0, "-3"), (6.543e-9, "6.54e-9"), (2e7, "2e7")]
        {
            assert_eq!(short(value), text);
        }
    }
}
