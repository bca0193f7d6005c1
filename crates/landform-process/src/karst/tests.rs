use landform_core::analysis::{NetworkStatistics, network_statistics};
use landform_core::feature::Conduit;
use landform_core::grid::{Grid, Shape};
use landform_core::math;
use landform_core::parallel::with_threads;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
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
    // A cliff, and places that are no whole millimetres.
    let grid = Grid::new(Shape::new(41, 41), [1.000_37; 2]).unwrap();
    let z = (0..grid.len()).map(|i| if grid.position(i)[0] < 25.0 { 140.0 } else { 20.0 });
    let cliff = HeightField::new(grid.clone(), z.collect()).unwrap();
    let small = KarstNetwork { springs: Vec::new(), radius: [0.1, 0.2].map(Length::of), ..network() };
    for seed in 0..5 {
        let grown = small.grow(&cliff, Seed(seed)).unwrap();
        for at in &grown.network.nodes {
            let [x, y] = [at[0], at[1]].map(|v| v.clamp(0.0, 40.0 * 1.000_37));
            assert!(at[2] <= cliff.elevation_at([x, y]) + 1e-6, "{at:?}");
        }
    }
    for params in all_ways() {
        let grown = grown(&params, 3);
        let parts = grown.network.parts();
        let used = grown.network.edges().into_iter().flatten();
        assert!(used.map(|n| parts[n as usize]).all(|p| p == parts[grown.springs[0] as usize]), "{:?}", params.preset);
        assert_eq!(grown.sinkholes.len(), 40);
        assert!(grown.shares.iter().all(|s| s.is_finite()), "{:?}", params.preset);
        for at in &grown.network.nodes {
            assert!(at.iter().all(|v| v.is_finite()));
            assert!(at[2] <= ground.elevation_at([at[0], at[1]]) + 1e-6, "{:?} {at:?}", params.preset);
        }
    }
}

#[test]
fn water_is_shared_out_and_passages_widen_towards_the_spring() {
    for (params, seed) in all_ways().into_iter().flat_map(|p| (0..4).map(move |seed| (p.clone(), seed))) {
        let grown = grown(&params, seed);
        let what = format!("{:?} {:?} {seed}", params.preset, params.method);
        let n = grown.network.nodes.len();
        let (mut balance, mut ends) = (vec![0.0; n], vec![0; n]);
        let (mut into, mut out_of) = (vec![0.0_f64; n], vec![0.0_f64; n]);
        for (conduit, share) in grown.network.conduits.iter().zip(&grown.shares) {
            let [a, b] = [conduit.nodes[0], conduit.nodes[conduit.nodes.len() - 1]].map(|n| n as usize);
            assert!((0.0..=1.0 + 1e-9).contains(share), "{what} {share}");
            balance[a] -= share;
            balance[b] += share;
            [a, b].into_iter().for_each(|n| ends[n] += 1);
            into[b] = into[b].max(conduit.passages[0].left);
            out_of[a] = out_of[a].max(conduit.passages[0].left);
        }
        let spring = grown.springs[0] as usize;
        assert!((balance[spring] - 1.0).abs() < 1e-6, "{what} {}", balance[spring]);
        for i in (0..n).filter(|&i| ends[i] > 1 && i != spring && !grown.sinkholes.contains(&(i as u32))) {
            assert!(balance[i].abs() < 1e-6, "{what} {}", balance[i]);
            if !matches!(params.preset, Preset::Branchwork) {
                continue;
            }
            assert!(into[i] <= out_of[i] + 1e-4, "{what}: {} flows into {}", into[i], out_of[i]);
        }
        let radii: Vec<f64> = grown.network.conduits.iter().map(|c| c.passages[0].left).collect();
        assert!(radii.iter().all(|r| (1.5..=8.0).contains(r)), "{what}");
        let is_at_spring = |c: &&Conduit| c.nodes.contains(&(spring as u32));
        let widest = grown.network.conduits.iter().filter(is_at_spring).map(|c| c.passages[0].left);
        assert_eq!(widest.fold(0.0, f64::max), 8.0, "{what}");
    }
}

/// In a tree the cube of a radius is the sum of those above it, to the rounding of radii, where
/// no passage is as thin as is allowed.
#[test]
fn cubes_of_radii_add_up_at_every_junction_of_a_tree() {
    let params = KarstNetwork { radius: [1e-3, 8.0].map(Length::of), ..network() };
    for seed in 0..4 {
        let grown = grown(&params, seed);
        let n = grown.network.nodes.len();
        let (mut into, mut out_of, mut ends) = (vec![0.0; n], vec![0.0; n], vec![0; n]);
        for conduit in &grown.network.conduits {
            let cube = math::pow(conduit.passages[0].left, 3.0);
            let [a, b] = [conduit.nodes[0], conduit.nodes[conduit.nodes.len() - 1]].map(|n| n as usize);
            out_of[a] += cube;
            into[b] += cube;
            [a, b].into_iter().for_each(|n| ends[n] += 1);
        }
        let is_inner = |i: &usize| ends[*i] > 2 && !grown.springs.contains(&(*i as u32));
        assert!((0..n).filter(is_inner).count() > 50);
        for i in (0..n).filter(is_inner) {
            assert!((into[i] / out_of[i] - 1.0).abs() < 1e-3, "{} {}", into[i], out_of[i]);
        }
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

/// Share of the length of passages that leads within 15 degrees of 40 or 130 degrees from north.
fn along_families(params: &KarstNetwork) -> f64 {
    let (mut near, mut all) = (0.0, 0.0);
    for network in (0..3).map(|seed| grown(params, seed).network) {
        let pieces = network.conduits.iter().flat_map(|c| c.nodes.chunks(6).map(|p| [p[0], p[p.len() - 1]]));
        for [a, b] in pieces.map(|e| e.map(|n| network.nodes[n as usize])) {
            let azimuth = math::atan2(b[0] - a[0], b[1] - a[1]).to_degrees().rem_euclid(90.0);
            let far = math::hypot(b[0] - a[0], b[1] - a[1]);
            all += far;
            near += if (azimuth - 40.0).abs() < 15.0 { far } else { 0.0 };
        }
    }
    near / all
}

#[test]
fn ways_follow_two_families_of_fractures_by_either_method() {
    let family = |dip_direction: f64| Fracture { dip_direction: Angle::of(dip_direction), ..Fracture::default() };
    for params in all_ways().into_iter().filter(|p| !p.preset.is_maze()) {
        let with = KarstNetwork { fractures: vec![family(130.0), family(40.0)], ..params.clone() };
        let found = [along_families(&with), along_families(&params)];
        assert!(found[0] > 1.2 * found[1], "{:?} {:?} {found:?}", params.preset, params.method);
    }
}

#[test]
fn networks_are_as_natural_ones_are() {
    for params in all_ways().into_iter().filter(|p| !p.preset.is_maze()) {
        let params = KarstNetwork { radius: [1.0, 5.0].map(Length::of), ..params };
        let found = (1..=4).map(|seed| statistics(&grown(&params, seed)).in_range);
        let found: Vec<usize> = found.collect();
        let what = format!("{:?} {:?} {found:?}", params.preset, params.method);
        assert!(found.iter().all(|n| *n >= 7) && found.iter().filter(|n| **n == 8).count() >= 3, "{what}");
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

/// Places of passages, those that were left out of the network left out.
fn places(grown: &Grown) -> Vec<[f64; 3]> {
    let nodes = grown.network.conduits.iter().flat_map(|c| &c.nodes);
    nodes.map(|n| grown.network.nodes[*n as usize]).collect()
}

fn sphere(at: [f64; 3], radius: f64) -> Forbidden {
    Forbidden { at: at.map(Length::of), radius: Length::of(radius) }
}

/// No piece of a passage comes nearer to the middle than the radius.
#[track_caller]
fn outside(grown: &Grown, spheres: &[Forbidden]) {
    for [a, b] in grown.network.edges().into_iter().map(|e| e.map(|n| grown.network.nodes[n as usize])) {
        for sphere in spheres {
            let (middle, radius) = (sphere.at.map(Length::si), sphere.radius.si());
            let near = (0..=20).map(|k| distance(middle, super::space::between(a, b, f64::from(k) / 20.0)));
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(near > radius - 1e-2, "{near} {radius} {a:?} {b:?}");
        }
    }
}

#[test]
fn spheres_are_left_out_and_waypoints_reached() {
    let ground = plateau();
    let way = [400.0, 1700.0, 5.0];
    let many = (0..60).map(|k| sphere([f64::from(k % 8) * 250.0, f64::from(k / 8) * 250.0 + 130.0, 20.0], 30.0));
    // Some stand out of the ground, or reach beyond the map.
    let settings =
        [vec![sphere([1000.0, 900.0, 20.0], 250.0)], vec![sphere([700.0, 300.0, 40.0], 600.0)], many.collect()];
    for (forbidden, params) in settings.iter().flat_map(|f| all_ways().into_iter().map(move |p| (f, p))) {
        let params = KarstNetwork {
            forbidden: forbidden.clone(),
            waypoints: vec![way.map(Length::of)],
            sinkholes: Sinkholes::Count(15),
            ..params
        };
        let grown = match params.grow(&ground, Seed(4)) {
            Ok(grown) => grown,
            Err(error) => {
                // Refused, and not without a word on how to go on.
                assert!(error.hint().is_some_and(|h| h.contains("forbidden")), "{error}");
                assert!(forbidden.len() > 1 || forbidden[0].radius.si() > 300.0, "{error}");
                continue;
            }
        };
        outside(&grown, forbidden);
        assert!(grown.network.nodes.contains(&way), "{:?}", params.preset);
        for at in places(&grown) {
            assert!(at[2] <= ground.elevation_at([at[0], at[1]]) + 1e-6, "{at:?}");
            assert!((0..2).all(|k| (0.0..=2000.0).contains(&at[k])), "{at:?}");
        }
    }
}

#[test]
fn passages_go_around_ground_without_data() {
    let mut z = plateau().elevation().to_vec();
    let grid = plateau().grid().clone();
    for (i, z) in z.iter_mut().enumerate() {
        let [x, y] = grid.position(i);
        if math::hypot(x - 1200.0, y - 700.0) < 250.0 {
            *z = f64::NAN;
        }
    }
    let ground = HeightField::new(grid, z).unwrap();
    let params = KarstNetwork { method: Method::ShortestPaths, ..network() };
    let all = (0..4).flat_map(|seed| places(&params.grow(&ground, Seed(seed)).unwrap()));
    for at in all {
        assert!(ground.elevation_at([at[0], at[1]]).is_finite(), "{at:?}");
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let at = |params: &KarstNetwork, ground: &HeightField| {
        let error = params.check().and_then(|()| params.grow(ground, Seed(1)).map(drop));
        error.unwrap_err().to_string()
    };
    let refused = |params: KarstNetwork, word: &str| {
        let error = at(&params, &plateau());
        assert!(error.contains(word) && error.len() < 300, "{word} is not in: {error}");
    };
    let of = Length::of;
    let spring = |x: f64, level: f64| Spring { at: [of(x), of(300.0)], water_table: Some(of(level)) };
    refused(KarstNetwork { sinkholes: Sinkholes::Count(0), ..network() }, "sinkholes");
    refused(KarstNetwork { radius: [8.0, 2.0].map(of), ..network() }, "radius");
    refused(KarstNetwork { radius: [8.0, 700.0].map(of), ..network() }, "0 m to 500 m");
    refused(KarstNetwork { step: Some(of(1e-3)), ..network() }, "`step`");
    refused(KarstNetwork { bend: Some(of(1e-3)), ..network() }, "2 m to 500 m");
    refused(KarstNetwork { bend: Some(of(5000.0)), ..network() }, "2 m to 500 m");
    refused(KarstNetwork { phreatic_depth: of(5000.0), ..network() }, "`phreatic_depth`");
    refused(KarstNetwork { springs: vec![spring(1900.0, 500.0)], ..network() }, "water leaves through it");
    refused(KarstNetwork { springs: vec![spring(100.0, 145.0)], ..network() }, "twice the rock");
    refused(KarstNetwork { springs: vec![spring(1900.0, -90_000.0)], ..network() }, "springs.water_table");
    refused(KarstNetwork { springs: vec![spring(9000.0, 20.0)], ..network() }, "on the map");
    refused(KarstNetwork { springs: vec![spring(1900.0, 20.0), spring(1900.0, 30.0)], ..network() }, "twice");
    refused(KarstNetwork { gamma: Some(2.0), ..network() }, "`gamma`");
    let maze = KarstNetwork { preset: Preset::Spongework, ..network() };
    refused(KarstNetwork { method: Method::ShortestPaths, ..maze.clone() }, "`method`");
    refused(KarstNetwork { cycles: Some(3), ..maze }, "`cycles`");
    let many = KarstNetwork { method: Method::ShortestPaths, sinkholes: Sinkholes::Count(400), ..network() };
    assert!(many.check().unwrap_err().to_string().contains("at most 400"));
    for z in [400.0, 143.0, -1e308, -9000.0] {
        refused(KarstNetwork { waypoints: vec![[of(500.0), of(500.0), of(z)]], ..network() }, "waypoints");
    }
    let around = |x: f64, y: f64, z: f64| KarstNetwork { forbidden: vec![sphere([x, y, z], 100.0)], ..network() };
    refused(
        KarstNetwork { waypoints: vec![[of(500.0), of(500.0), of(0.0)]], ..around(500.0, 500.0, 0.0) },
        "waypoints",
    );
    refused(around(1900.0, 300.0, 20.0), "springs");
    let sinks = Sinkholes::Places(vec![[of(500.0), of(500.0)]]);
    refused(KarstNetwork { sinkholes: sinks, ..around(500.0, 500.0, 140.0) }, "sinkholes");
    refused(KarstNetwork { forbidden: vec![sphere([1000.0; 3], 1e4)], ..network() }, "springs");
    let open = KarstNetwork { springs: Vec::new(), forbidden: vec![sphere([1000.0; 3], 1e4)], ..network() };
    refused(open, "no place for a spring");
    let high = HeightField::new(plateau().grid().clone(), (0..10_201).map(|i| f64::from(i % 7) * 1e299).collect());
    assert!(at(&network(), &high.unwrap()).contains("e299"));
    let error = |text: &str| serde_json::from_str::<KarstNetwork>(text).unwrap_err().to_string();
    assert!(error(r#"{"sinkholes":-1}"#).contains("1 to 5000"));
    assert!(error(r#"{"sinkholes":[["1 kg","2 m"]]}"#).contains("`kg`"));
}
