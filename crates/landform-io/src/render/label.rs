//! Words on pictures.

use font8x8::legacy::BASIC_LEGACY;

use super::Picture;

/// Side of a letter before it is enlarged, pixels.
const LETTER: usize = 8;

impl Picture {
    /// Writes a line of plain text into the lower left corner, light on a dark band. Text that does
    /// not fit is cut off; letters that the font lacks are left blank.
    pub fn label(&mut self, text: &str) {
        let (rows, cols) = (self.shape.rows, self.shape.cols);
        let scale = (cols / 320).max(1);
        let (pad, size) = (2 * scale, LETTER * scale);
        let (height, width) = (size + 2 * pad, text.chars().count() * size + 2 * pad);
        if rows < height {
            return;
        }
        let top = rows - height;
        for r in 0..height {
            for c in 0..width.min(cols) {
                let is_ink = || {
                    let (y, x) = (r.checked_sub(pad)? / scale, c.checked_sub(pad)? / scale);
                    let glyph = BASIC_LEGACY.get(text.chars().nth(x / LETTER)? as usize)?;
                    Some(y < LETTER && glyph[y] >> (x % LETTER) & 1 == 1)
                };
                let pixel = &mut self.pixels[(top + r) * cols + c];
                *pixel = if is_ink().unwrap_or(false) { [245; 3] } else { pixel.map(|v| v / 3) };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::Shape;

    use super::*;

    #[test]
    fn a_label_stays_in_its_corner() {
        let blank = || Picture { shape: Shape::new(40, 100), pixels: vec![[200; 3]; 4000] };
        let mut picture = blank();
        picture.label("12.5 kyr");
        let changed: Vec<usize> = (0..4000).filter(|&i| picture.pixels[i] != [200; 3]).collect();
        assert!(changed.iter().all(|i| i / 100 >= 28 && i % 100 < 68) && changed.len() == 12 * 68);
        assert!(picture.pixels.iter().filter(|p| **p == [245; 3]).count() > 60);
        // Too long, and too low: no panic.
        picture.label(&"x".repeat(50));
        Picture { shape: Shape::new(3, 3), pixels: vec![[0; 3]; 9] }.label("no");
    }
}
