use landform_core::analysis::{NetworkStatistics, network_statistics};
use landform_core::grid::{Grid, Shape};
use landform_core::math;
use landform_core::parallel::with_threads;
use landform_core::random::Seed;
use landform_core::terrain::HeightField;
use landform_core::units::{Angle, Length};
use landform_core::verb::Params;

use super::grow::Grown;
use super::space::distance;
use super::*;

/// A plateau that falls to a valley in the east.
fn plateau() -> HeightField {
    let grid = Grid::new(Shape::new(101, 101), [20.0; 2]).unwrap();
    let z = (0..grid.len()).map(|i| {
        let [x, y] = grid.position(i);
        let t = ((x / 2000.0 - 0.8) / 0.14).clamp(0.0, 1.0);
        140.0 - 120.0 * t * t * (3.0 - 2.0 * t) + 4.0 * ((x * 0.013 + y * 0.021) % 2.0)
    });
    HeightField::new(grid.clone(), z.collect()).unwrap()
}

fn network() -> KarstNetwork {
    KarstNetwork {
        sinkholes: Sinkholes::Count(40),
        springs: vec![Spring { at: [1900.0, 300.0].map(Length::of), water_table: Some(Length::of(20.0)) }],
        radius: [1.5, 8.0].map(Length::of),
        ..KarstNetwork::default()
    }
}

fn grown(params: &KarstNetwork, seed: u64) -> Grown {
    params.grow(&plateau(), Seed(seed)).unwrap()
}

fn statistics(grown: &Grown) -> NetworkStatistics {
    network_statistics(&grown.network.nodes, &grown.network.edges())
}

fn all_ways() -> Vec<KarstNetwork> {
    let presets = [Preset::Branchwork, Preset::Mixed, Preset::Anastomotic, Preset::RectilinearMaze, Preset::Spongework];
    let with = |preset, method| KarstNetwork { preset, method, ..network() };
    let grown = presets.map(|p| with(p, Method::SpaceColonisation));
    grown.into_iter().chain(presets[..3].iter().map(|p| with(*p, Method::ShortestPaths))).collect()
}

#[test]
fn every_sinkhole_reaches_the_spring_and_no_passage_leaves_the_rock() {
    let ground = plateau();
    for params in all_ways() {
        let grown = grown(&params, 3);
        let parts = grown.network.parts();
        let used = grown.network.edges().into_iter().flatten();
        assert!(used.map(|n| parts[n as usize]).all(|p| p == parts[grown.springs[0] as usize]), "{:?}", params.preset);
        assert_eq!(grown.sinkholes.len(), 40);
        assert!(grown.shares.iter().all(|s| s.is_finite()), "{:?}", params.preset);
        for at in &grown.network.nodes {
            assert!(at.iter().all(|v| v.is_finite()));
            assert!(at[2] <= ground.elevation_at([at[0], at[1]]) + 2e-3, "{:?} {at:?}", params.preset);
        }
    }
}

#[test]
fn radii_follow_the_pipe_rule_at_every_junction() {
    for params in all_ways().into_iter().take(3) {
        let grown = grown(&params, 5);
        let n = grown.network.nodes.len();
        let (mut balance, mut carried) = (vec![0.0; n], vec![0.0_f64; n]);
        for (conduit, share) in grown.network.conduits.iter().zip(&grown.shares) {
            let [a, b] = [conduit.nodes[0], conduit.nodes[conduit.nodes.len() - 1]].map(|n| n as usize);
            balance[a] -= share;
            balance[b] += share;
            [a, b].into_iter().for_each(|n| carried[n] = carried[n].max(*share));
        }
        let ends: Vec<u32> = grown.network.neighbours().iter().map(|j| j.len() as u32).collect();
        for i in (0..n).filter(|&i| ends[i] > 2 && !grown.springs.contains(&(i as u32))) {
            assert!(balance[i].abs() < 1e-6 * carried[i].max(1e-3), "{} {}", balance[i], carried[i]);
        }
        let radii: Vec<f64> = grown.network.conduits.iter().map(|c| c.passages[0].left).collect();
        assert!(radii.iter().all(|r| (1.5..=8.0).contains(r)) && radii.contains(&8.0));
    }
}

#[test]
fn passages_follow_fractures_and_keep_to_beds() {
    let fracture =
        Fracture { dip_direction: Angle::of(130.0), tolerance: Angle::of(5.0), weight: 2.0, ..Fracture::default() };
    let along = KarstNetwork { fractures: vec![fracture], tortuosity: 1.1, ..network() };
    let (with, without) = (grown(&along, 2), grown(&KarstNetwork { tortuosity: 1.1, ..network() }, 2));
    assert!(statistics(&with).orientation_entropy < statistics(&without).orientation_entropy);
    // The strike is 40 degrees from north.
    let mut bins = [0.0; 18];
    for [a, b] in with.network.edges() {
        let [a, b] = [a, b].map(|n| with.network.nodes[n as usize]);
        let azimuth = math::atan2(b[0] - a[0], b[1] - a[1]).to_degrees().rem_euclid(180.0);
        bins[((azimuth + 5.0) / 10.0) as usize % 18] += distance(a, b);
    }
    let peak = (0..18).max_by(|a, b| bins[*a].total_cmp(&bins[*b])).unwrap();
    assert!((3..=5).contains(&peak), "{peak} {bins:?}");
    let bed = Bed { elevation: Length::of(-5.0), weight: 2.0, ..Bed::default() };
    let off = |grown: &Grown| {
        let low: Vec<f64> = grown.network.nodes.iter().map(|n| n[2]).filter(|z| *z < 20.0).collect();
        low.iter().map(|z| (z + 5.0).abs()).sum::<f64>() / low.len() as f64
    };
    let on_bed = grown(&KarstNetwork { beds: vec![bed], ..network() }, 2);
    assert!(off(&on_bed) < 0.6 * off(&without), "{} {}", off(&on_bed), off(&without));
}

#[test]
fn lengths_do_not_depend_on_the_distance_of_samples() {
    for method in [Method::SpaceColonisation, Method::ShortestPaths] {
        let length = |step: f64| {
            let params = KarstNetwork { method, step: Some(Length::of(step)), ..network() };
            (0..6).map(|seed| grown(&params, seed).network.length()).sum::<f64>()
        };
        let (coarse, fine) = (length(20.0), length(10.0));
        assert!((coarse / fine - 1.0).abs() < 0.05, "{method:?} {coarse} {fine}");
    }
}

#[test]
fn the_same_bytes_on_any_number_of_threads() {
    for params in all_ways() {
        let run = |threads| with_threads(threads, || grown(&params, 9).features()).unwrap();
        let (one, three) = (run(1), run(3));
        for (a, b) in one.iter().zip(three.iter()) {
            assert!(a == b, "{:?} {a:?} {b:?}", params.preset);
        }
    }
}

#[test]
fn spheres_are_left_out_and_waypoints_reached() {
    let forbidden = Forbidden { at: [1000.0, 900.0, 20.0].map(Length::of), radius: Length::of(250.0) };
    let way = [400.0, 1700.0, 5.0];
    let params = KarstNetwork { forbidden: vec![forbidden], waypoints: vec![way.map(Length::of)], ..network() };
    let grown = grown(&params, 4);
    let inside = grown.network.nodes.iter().filter(|n| distance(**n, [1000.0, 900.0, 20.0]) < 249.9);
    assert_eq!(inside.filter(|n| n[2] < 130.0).count(), 0);
    let nearest = grown.network.nodes.iter().map(|n| distance(*n, way)).fold(f64::INFINITY, f64::min);
    assert!(nearest < 40.0, "{nearest}");
}

#[test]
fn what_cannot_be_is_refused() {
    let refused = |params: KarstNetwork| params.check().is_err() || params.grow(&plateau(), Seed(1)).is_err();
    assert!(refused(KarstNetwork { sinkholes: Sinkholes::Count(0), ..network() }));
    assert!(refused(KarstNetwork { radius: [8.0, 2.0].map(Length::of), ..network() }));
    assert!(refused(KarstNetwork { step: Some(Length::of(1e-3)), ..network() }));
    let high = Spring { at: [1900.0, 300.0].map(Length::of), water_table: Some(Length::of(500.0)) };
    assert!(refused(KarstNetwork { springs: vec![high], ..network() }));
    let off = Spring { at: [9000.0, 300.0].map(Length::of), water_table: None };
    assert!(refused(KarstNetwork { springs: vec![off], ..network() }));
}
