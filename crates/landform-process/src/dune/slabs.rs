//! A round of Werner's rules, with any rule of shelter.

use landform_core::grid::Grid;
use landform_core::random::{Seed, Stream};
use landform_core::verb::Rose;

use super::field::{Field, Places};
use super::params::Dunes;
use super::protection::Protection;
use super::shelter::Shelter;

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
        let shelter = Shelter::from(params, grid, field, protection.as_deref_mut(), (wind, towards));
        let (surface, mut mark) = field.sand.shelter();
        shelter.find(surface, |first, are_sheltered| mark.set(first, are_sheltered));
        let mut stream = seed.with(part_of_round).stream();
        for strip in 0..n.div_ceil(STRIP) {
            let sites = strip * STRIP..((strip + 1) * STRIP).min(n);
            let times = (sites.len() as f64 * part / SHELTERS_A_ROUND as f64).ceil() as usize;
            blow(params, field, hop, slab, sites, times, &mut stream);
        }
    }
}

/// A probability as a bound on 32 random bits.
fn bound(chance: f64) -> u64 {
    (chance * (1u64 << 32) as f64) as u64
}

fn blow(
    params: &Dunes,
    field: &mut Field,
    hop: [f64; 2],
    slab: i32,
    sites: std::ops::Range<usize>,
    times: usize,
    stream: &mut Stream,
) {
    // By whether the site keeps what lands, and whether sand lies there: one table, since a
    // processor guesses one outcome better than three.
    let [on_ground, on_sand, always] = [params.stay_on_ground(), params.stay_on_sand(), 1.0].map(bound);
    let stays = [[on_ground, on_sand], [always, always]];
    let whole = hop.map(|h| h.floor() as i64);
    // The probability of one cell more.
    let more = [0, 1].map(|k| bound(hop[k] - hop[k].floor()));
    let slants = more != [0, 0];
    let places = Places::new(field.sand.shape());
    for _ in 0..times {
        let bits = stream.bits();
        let site = sites.start + Stream::index((bits >> 32) as u32, sites.len());
        if !field.sand.is_exposed(site) {
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
            let Some(next) = field.hop(places.of(at), c, r) else {
                field.left += i64::from(taken);
                break;
            };
            at = next;
            let [keeps, is_sand] = [field.sand.keeps(at), field.sand.is_exposed(at)].map(usize::from);
            if draw < stays[keeps][is_sand] {
                field.sand.put(at, taken);
                break;
            }
            draw = stream.bits() >> 32;
        }
    }
}
