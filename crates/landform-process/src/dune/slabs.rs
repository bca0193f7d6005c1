//! A round of Werner's rules, with any rule of shelter.

use landform_core::grid::Grid;
use landform_core::random::{Seed, Stream};
use landform_core::verb::Rose;

use super::Scratch;
use super::field::Field;
use super::params::Dunes;
use super::protection::Protection;
use crate::mechanism::wind::WindScan;

/// How often shelter is found anew in a round.
const SHELTERS_A_ROUND: u64 = 4;
/// Sites of a strip on which the wind acts together: their heights, sand and shelter fit in the
/// second-level cache.
const STRIP: usize = 1 << 16;

/// Lets the wind act once on average on every site (or on a fraction of them).
#[expect(clippy::too_many_arguments, reason = "one call, from the step")]
pub(super) fn round(
    params: &Dunes,
    grid: &Grid,
    field: &mut Field,
    mut protection: Option<&mut Protection>,
    scratch: &mut Scratch,
    rose: &Rose,
    wind: usize,
    part: f64,
    seed: Seed,
) {
    let n = grid.len();
    let towards = rose.winds()[wind].towards();
    let hop = field.cells_of(towards, params.hop(grid), grid.spacing);
    let slab = field.sand.slab();
    for part_of_round in 0..SHELTERS_A_ROUND {
        find_shelter(params, grid, field, protection.as_deref_mut(), scratch, (wind, towards));
        let mut stream = seed.with(part_of_round).stream();
        for strip in 0..n.div_ceil(STRIP) {
            let sites = strip * STRIP..((strip + 1) * STRIP).min(n);
            let times = (sites.len() as f64 * part / SHELTERS_A_ROUND as f64).ceil() as usize;
            blow(params, field, &scratch.sheltered, hop, slab, sites, times, &mut stream);
        }
    }
}

/// Finds which sites are sheltered from a wind of the rose, into `scratch.sheltered`.
pub(super) fn find_shelter(
    params: &Dunes,
    grid: &Grid,
    field: &Field,
    protection: Option<&mut Protection>,
    scratch: &mut Scratch,
    (wind, towards): (usize, [f64; 2]),
) {
    let n = grid.len();
    scratch.sheltered.resize(n, false);
    let Some(protection) = protection else {
        let sweep = WindScan::new(grid.shape, grid.spacing, field.is_torus(), towards);
        let surface = field.sand.surface();
        let fall = field.fall(params.shadow(), sweep.line_spacing);
        scratch.air.resize(n, 0.0);
        sweep.shelter(|i| surface[i] as f32, fall, &mut scratch.lines, &mut scratch.air);
        for i in 0..n {
            // Half a unit is rounding.
            scratch.sheltered[i] = scratch.air[i] > surface[i] as f32 + 0.5;
        }
        return;
    };
    protection.update(field);
    protection.sheltered(wind, &mut scratch.sheltered);
}

/// A probability as a bound on 32 random bits.
fn bound(chance: f64) -> u64 {
    (chance * (1u64 << 32) as f64) as u64
}

#[expect(clippy::too_many_arguments, reason = "the inner loop, split from the round for its length")]
fn blow(
    params: &Dunes,
    field: &mut Field,
    sheltered: &[bool],
    hop: [f64; 2],
    slab: i32,
    sites: std::ops::Range<usize>,
    times: usize,
    stream: &mut Stream,
) {
    let (on_sand, on_ground) = (bound(params.stay_on_sand()), bound(params.stay_on_ground()));
    let whole = hop.map(|h| h.floor() as i64);
    // The probability of one cell more.
    let more = [0, 1].map(|k| bound(hop[k] - hop[k].floor()));
    let slants = more != [0, 0];
    for _ in 0..times {
        let bits = stream.bits();
        let site = sites.start + Stream::index((bits >> 32) as u32, sites.len());
        if field.sand.depth(site) <= 0 || sheltered[site] {
            continue;
        }
        let taken = field.sand.take(site, slab);
        let mut draw = bits & 0xffff_ffff;
        let mut at = site;
        loop {
            let [mut c, mut r] = whole;
            if slants {
                let bits = stream.bits();
                c += i64::from(bits & 0xffff_ffff < more[0]);
                r += i64::from(bits >> 32 < more[1]);
            }
            let Some(next) = field.hop(at, c, r) else {
                field.left += i64::from(taken);
                break;
            };
            at = next;
            let depth = field.sand.depth(at);
            if field.sand.is_sink(at) || sheltered[at] || draw < if depth > 0 { on_sand } else { on_ground } {
                field.sand.put(at, taken);
                break;
            }
            draw = stream.bits() >> 32;
        }
    }
}
