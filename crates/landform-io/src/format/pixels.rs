//! Pixels as a picture stores them.

use landform_core::grid::Shape;

/// A picture as it is stored: numbers from 0 to `greatest`.
pub(super) struct Pixels {
    pub(super) shape: Shape,
    /// Grey, or red, green, blue.
    pub(super) colours: usize,
    pub(super) has_opacity: bool,
    /// Colours, then opacity, of each pixel.
    pub(super) samples: Vec<u16>,
    pub(super) greatest: u16,
}

impl Pixels {
    pub(super) fn pixels(&self) -> impl Iterator<Item = &[u16]> {
        self.samples.chunks_exact(self.colours + usize::from(self.has_opacity))
    }

    /// Luminance of each pixel (ITU-R BT.709), in the picture's own numbers.
    pub(super) fn grey(&self) -> Vec<u16> {
        let luminance = |p: &[u16]| {
            let sum = [2126, 7152, 722].iter().zip(p).map(|(weight, v)| weight * u32::from(*v)).sum::<u32>();
            (sum / 10_000) as u16
        };
        self.pixels().map(|p| if self.colours == 3 { luminance(p) } else { p[0] }).collect()
    }

    pub(super) fn is_coloured(&self) -> bool {
        self.colours == 3 && self.pixels().any(|p| p[0] != p[1] || p[1] != p[2])
    }

    /// Where the picture is not wholly transparent; none where it has no opacity, or says nothing
    /// by it.
    pub(super) fn visible(&self) -> Option<Vec<bool>> {
        let visible: Vec<bool> = self.has_opacity.then(|| self.pixels().map(|p| p[self.colours] > 0).collect())?;
        visible.contains(&true).then_some(visible)
    }
}
