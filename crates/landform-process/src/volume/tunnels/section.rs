//! Shapes of passages across. Lengths here are in radii of the conduit, and every shape has the
//! area of a circle of one radius.

use landform_core::feature::Passage;

/// Shape of a passage across.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Section {
    /// An ellipse that lies: water dissolves it all around.
    Tube,
    /// A slot that water has cut down.
    Canyon,
    /// A tube over a slot.
    Keyhole,
    /// A circle around the way down.
    Shaft,
    /// Four quarters of ellipses to the walls.
    AsGiven,
}

/// Rise over run above which a passage is a shaft: 55 degrees.
const STEEP: f64 = 1.43;
/// Height over the water table up to which a tube is cut by a slot, m.
const LATELY_DRAINED: f64 = 12.0;

impl Section {
    /// By the slope between two places and the depth under the water table (m), where it is known.
    pub(super) fn of([a, b]: [[f64; 3]; 2], depth: Option<f64>) -> Self {
        let run = ((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])).sqrt();
        let slope = (b[2] - a[2]).abs() / run.max(1e-9);
        match depth {
            _ if slope > STEEP => Self::Shaft,
            Some(depth) if depth >= 0.0 => Self::Tube,
            Some(depth) if depth > -LATELY_DRAINED => Self::Keyhole,
            Some(_) => Self::Canyon,
            // 17 degrees.
            None if slope > 0.3 => Self::Canyon,
            None => Self::Tube,
        }
    }

    /// Whether a place `across` and `up` from the line, in radii, lies in the passage.
    fn holds(self, across: f64, up: f64) -> bool {
        let ellipse = |a: f64, b: f64, up: f64| (across / a) * (across / a) + (up / b) * (up / b) <= 1.0;
        match self {
            Self::Tube => ellipse(1.25, 0.8, up),
            Self::Shaft | Self::AsGiven => ellipse(1.0, 1.0, up),
            // Half as wide as high by more than three: 1.0 x 3.14.
            Self::Canyon => across.abs() <= 0.5 && (-2.14..=1.0).contains(&up),
            // A circle of 0.8 radii, and a slot of 0.6 by 1.885 under it.
            Self::Keyhole => ellipse(0.8, 0.8, up) || (across.abs() <= 0.3 && (-2.64..=-0.7).contains(&up)),
        }
    }
}

/// A straight piece of passage.
pub(super) struct Piece {
    from: [f64; 3],
    along: [f64; 3],
    length: f64,
    /// Unit vectors to the left and up across the passage.
    left: [f64; 3],
    up: [f64; 3],
    walls: [Passage; 2],
    section: Section,
    least: f64,
}

impl Piece {
    /// `least` is the distance from the line that is hollow in any case, m.
    pub(super) fn new([a, b]: [[f64; 3]; 2], walls: [Passage; 2], section: Section, least: f64) -> Self {
        let way = [0, 1, 2].map(|k| b[k] - a[k]);
        let length = way.iter().map(|v| v * v).sum::<f64>().sqrt();
        let along = if length > 0.0 { way.map(|v| v / length) } else { [1.0, 0.0, 0.0] };
        let run = (along[0] * along[0] + along[1] * along[1]).sqrt();
        let left = if run > 1e-6 { [-along[1] / run, along[0] / run, 0.0] } else { [0.0, 1.0, 0.0] };
        let up = [
            along[1] * left[2] - along[2] * left[1],
            along[2] * left[0] - along[0] * left[2],
            along[0] * left[1] - along[1] * left[0],
        ];
        Self { from: a, along, length, left, up, walls, section, least }
    }

    /// The box around the piece.
    pub(super) fn bounds(&self) -> landform_core::terrain::Bounds {
        let to = [0, 1, 2].map(|k| self.from[k] + self.length * self.along[k]);
        let widest = |w: &Passage| w.left.max(w.right).max(w.up).max(w.down);
        let reach = (2.7 * widest(&self.walls[0]).max(widest(&self.walls[1]))).max(self.least);
        landform_core::terrain::Bounds {
            low: [0, 1, 2].map(|k| self.from[k].min(to[k]) - reach),
            high: [0, 1, 2].map(|k| self.from[k].max(to[k]) + reach),
        }
    }

    /// Whether a place lies in the piece.
    pub(super) fn holds(&self, at: [f64; 3]) -> bool {
        let there = [0, 1, 2].map(|k| at[k] - self.from[k]);
        let dot = |v: [f64; 3]| v[0] * there[0] + v[1] * there[1] + v[2] * there[2];
        let (s, across, up) = (dot(self.along), dot(self.left), dot(self.up));
        let beyond = s - s.clamp(0.0, self.length);
        if beyond * beyond + across * across + up * up <= self.least * self.least {
            return true;
        }
        let t = if self.length > 0.0 { (s / self.length).clamp(0.0, 1.0) } else { 0.0 };
        let of = |wall: fn(&Passage) -> f64| (1.0 - t) * wall(&self.walls[0]) + t * wall(&self.walls[1]);
        let (side, height) = match self.section {
            Section::AsGiven => {
                let side = if across > 0.0 { of(|w| w.left) } else { of(|w| w.right) };
                (side, if up > 0.0 { of(|w| w.up) } else { of(|w| w.down) })
            }
            _ => {
                let radius = 0.25 * of(|w| w.left + w.right + w.up + w.down);
                (radius, radius)
            }
        };
        if !(side > 0.0 && height > 0.0) {
            return false;
        }
        // Ends are round, so that pieces meet without gaps.
        let across = (across * across + beyond * beyond).sqrt();
        self.section.holds(across / side, up / height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_section_has_the_area_of_a_circle() {
        for section in [Section::Tube, Section::Canyon, Section::Keyhole, Section::Shaft] {
            let n = 800;
            let at = |k: u32| 3.0 * (2.0 * (f64::from(k) + 0.5) / f64::from(n) - 1.0);
            let inside = (0..n * n).filter(|k| section.holds(at(k % n), at(k / n))).count();
            let area = inside as f64 * 36.0 / f64::from(n * n);
            assert!((area / std::f64::consts::PI - 1.0).abs() < 0.02, "{section:?} {area}");
        }
    }

    #[test]
    fn sections_follow_slope_and_water() {
        let to = |z: f64| [[0.0; 3], [10.0, 0.0, z]];
        assert_eq!(Section::of(to(30.0), Some(5.0)), Section::Shaft);
        assert_eq!(Section::of(to(-2.0), Some(5.0)), Section::Tube);
        assert_eq!(Section::of(to(-2.0), Some(-5.0)), Section::Keyhole);
        assert_eq!(Section::of(to(-2.0), Some(-50.0)), Section::Canyon);
        assert_eq!(Section::of(to(-6.0), None), Section::Canyon);
    }
}
