//! Bends: every place of a network moves by a field of noise, so that passages turn and stay
//! together where they meet.

use landform_core::{Error, Result, parallel};

use super::near::Near;
use super::rock::Rock;
use super::space::{Skeleton, Vector, between, distance};

/// Waves of the field over the length of bends.
const WAVES: [f64; 2] = [1.0, 0.4];
/// Slope of the field for a tortuosity t: this times √(t² − 1). Measured.
const STRENGTH: f64 = 0.46;
/// Vertical bends over those in plan.
const VERTICAL: f64 = 0.5;

/// Pieces of an arc around a sphere; their chords stay outside of it.
const ARC: usize = 64;
/// More places than this are refused.
const MOST_PLACES: f64 = 1e6;

/// Fine passages that turn. The first nodes are those of the network, and `fixed` ones stay.
/// Where all rock is fractured, bends are less by the part `straighter`.
///
/// # Errors
/// [`Error::Parameter`] for bends of which passages have too many.
pub(super) fn wander(
    skeleton: &Skeleton,
    fixed: &[u32],
    [tortuosity, straighter]: [f64; 2],
    rock: &Rock<'_>,
) -> Result<Skeleton> {
    let fine = 0.2 * WAVES[1] * rock.bend;
    let mut nodes = skeleton.nodes.clone();
    let mut is_fixed = vec![false; nodes.len()];
    fixed.iter().for_each(|&n| is_fixed[n as usize] = true);
    for (at, _) in nodes.iter_mut().zip(&is_fixed).filter(|n| !*n.1) {
        *at = rock.inside(*at, 0.0);
    }
    let pieces = |[a, b]: &[u32; 2]| (distance(nodes[*a as usize], nodes[*b as usize]) / fine).ceil().max(1.0);
    let all: f64 = skeleton.edges.iter().map(pieces).sum();
    if !(all <= MOST_PLACES) {
        let given = format!("{} m: {all:.0} places along passages", rock.bend);
        let expected = format!("bends of which passages have at most {MOST_PLACES:.0}; longer ones have fewer");
        return Err(Error::parameter("bend", given, &expected));
    }
    let still: Vec<Vector> = fixed.iter().map(|&n| nodes[n as usize]).collect();
    // Beyond it, what is fixed is not felt.
    let reach = (WAVES[0] * rock.bend).max(2.0 * rock.cover());
    let near = Near::new(&still, reach);
    let mut bent = Skeleton { nodes: nodes.clone(), edges: Vec::new() };
    for edge in &skeleton.edges {
        let [a, b] = edge.map(|n| nodes[n as usize]);
        let pieces = pieces(edge) as usize;
        let mut last = edge[0];
        for k in 1..pieces {
            let at = between(a, b, k as f64 / pieces as f64);
            last = bent.grow(last, rock.around(a, b, at, rock.cover()));
        }
        bent.edges.push([last, edge[1]]);
    }
    let straight = 1.0 - straighter * rock.fractured();
    let strength = STRENGTH * straight * (tortuosity * tortuosity - 1.0).max(0.0).sqrt();
    let seed = rock.seed.named("bends");
    let moved = parallel::map(bent.nodes.len(), |i| {
        let at = bent.nodes[i];
        let around = near.within(at, reach).into_iter().map(|s| distance(still[s as usize], at));
        let far = around.fold(f64::INFINITY, f64::min);
        if far == 0.0 {
            return at;
        }
        let mut to = at;
        for (octave, wave) in WAVES.iter().map(|w| w * rock.bend).enumerate() {
            let amplitude = strength * wave * (far / wave).min(1.0);
            for k in 0..3 {
                let by = Rock::noise(seed.with(8 * octave as u64 + k as u64), at, wave);
                to[k] += by * if k == 2 { (VERTICAL * amplitude).min(rock.depth) } else { amplitude };
            }
        }
        // Passages from the surface have less rock over them at first.
        let cover = rock.cover().min(0.5 * far);
        let places = [to, at].map(|p| rock.settled(rock.inside(p, cover)));
        places.into_iter().find(|p| rock.is_in_rock(*p)).unwrap_or(at)
    });
    bent.nodes = moved.into_iter().map(|p| rock.settled(p)).collect();
    go_around(&mut bent, rock);
    Ok(bent)
}

/// Leads pieces that bends have moved across a sphere around it.
fn go_around(bent: &mut Skeleton, rock: &Rock<'_>) {
    for edge in std::mem::take(&mut bent.edges) {
        let [a, b] = edge.map(|n| bent.nodes[n as usize]);
        let mut last = edge[0];
        if !rock.is_clear(a, b, f64::INFINITY) {
            for k in 1..ARC {
                let at = rock.around(a, b, between(a, b, k as f64 / ARC as f64), rock.cover());
                last = bent.grow(last, rock.settled(at));
            }
        }
        bent.edges.push([last, edge[1]]);
    }
}
