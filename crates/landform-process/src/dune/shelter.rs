//! Which sites are sheltered from a wind: by a shadow or by protection.

use landform_core::grid::Grid;

use super::field::Field;
use super::params::Dunes;
use super::protection::Protection;
use crate::mechanism::wind::WindScan;

/// The rule of shelter from one wind.
pub(super) enum Shelter<'a> {
    /// The ground casts a shadow that falls by so many units from line to line.
    Shadow { scan: WindScan, fall: f32 },
    /// Protection from a wind of the rose.
    Protection(&'a Protection, usize),
}

impl<'a> Shelter<'a> {
    /// The rule of a model for a wind of the rose, by its number; protection is brought up to date.
    pub(super) fn from(
        params: &Dunes,
        grid: &Grid,
        field: &Field,
        protection: Option<&'a mut Protection>,
        (wind, towards): (usize, [f64; 2]),
    ) -> Self {
        let Some(protection) = protection else {
            let scan = WindScan::new(grid.shape, grid.spacing, field.is_torus(), towards);
            return Self::Shadow { scan, fall: field.fall(params.shadow(), scan.line_spacing) };
        };
        protection.update(field);
        Self::Protection(protection, wind)
    }

    /// Calls `found` with runs of sites, from the first on, and whether each is in shelter on a
    /// surface, units.
    pub(super) fn find(&self, surface: &[i32], mut found: impl FnMut(usize, &[bool])) {
        let mut run = Vec::new();
        match self {
            Self::Shadow { scan, fall } => {
                let (low, high) = surface.iter().fold((i32::MAX, i32::MIN), |(a, b), &h| (a.min(h), b.max(h)));
                let heights = |first: usize, run: &mut [f32]| {
                    run.iter_mut().zip(&surface[first..]).for_each(|(h, &units)| *h = units as f32);
                };
                scan.shelter(heights, high as f32 - low as f32, *fall, |first, air| {
                    run.clear();
                    // Half a unit is rounding.
                    run.extend(air.iter().zip(&surface[first..]).map(|(&air, &units)| air > units as f32 + 0.5));
                    found(first, &run);
                });
            }
            Self::Protection(protection, wind) => {
                run.extend(protection.find(*wind));
                found(0, &run);
            }
        }
    }
}
