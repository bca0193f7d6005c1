//! Bends: every place of a network moves by a field of noise, so that passages turn and stay
//! together where they meet.

use landform_core::parallel;

use super::rock::Rock;
use super::space::{Skeleton, Vector, between, distance};

/// Waves of the field over the length of bends.
const WAVES: [f64; 2] = [1.0, 0.4];
/// Slope of the field for a tortuosity t: this times √(t² − 1). Measured.
const STRENGTH: f64 = 0.4;
/// Vertical bends over those in plan.
const VERTICAL: f64 = 0.5;

/// Fine passages that turn. The first nodes are those of the network, and `fixed` ones stay.
pub(super) fn wander(skeleton: &Skeleton, fixed: &[u32], tortuosity: f64, rock: &Rock<'_>) -> Skeleton {
    let fine = 0.2 * WAVES[1] * rock.bend;
    let mut bent = Skeleton { nodes: skeleton.nodes.clone(), edges: Vec::new() };
    for &[a, b] in &skeleton.edges {
        let ends = [a, b].map(|n| skeleton.nodes[n as usize]);
        let pieces = (distance(ends[0], ends[1]) / fine).ceil().clamp(1.0, 10_000.0) as usize;
        let mut last = a;
        for k in 1..pieces {
            last = bent.grow(last, between(ends[0], ends[1], k as f64 / pieces as f64));
        }
        bent.edges.push([last, b]);
    }
    let still: Vec<Vector> = fixed.iter().map(|&n| skeleton.nodes[n as usize]).collect();
    let strength = STRENGTH * (tortuosity * tortuosity - 1.0).max(0.0).sqrt();
    let seed = rock.seed.named("bends");
    let moved = parallel::map(bent.nodes.len(), |i| {
        let at = bent.nodes[i];
        let far = still.iter().map(|s| distance(*s, at)).fold(f64::INFINITY, f64::min);
        if far == 0.0 {
            return at;
        }
        let mut to = at;
        for (octave, wave) in WAVES.iter().map(|w| w * rock.bend).enumerate() {
            let amplitude = strength * wave * (far / wave).min(1.0);
            for k in 0..3 {
                let by = Rock::noise(seed.with(8 * octave as u64 + k as u64), at, wave);
                to[k] += amplitude * by * if k == 2 { VERTICAL } else { 1.0 };
            }
        }
        // Passages from the surface have less rock over them at first.
        rock.inside(to, rock.cover().min(0.5 * far))
    });
    bent.nodes = moved.into_iter().map(|p| p.map(|v| (v * 1000.0).round() / 1000.0)).collect();
    bent
}
