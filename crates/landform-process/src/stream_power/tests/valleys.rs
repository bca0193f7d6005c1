//! Creep against incision: when slopes break into valleys (VP3), and thresholds.

use landform_core::units::Diffusivity;

use super::*;

/// Half of a ridge between two open sides, from its divide in the north to base level in the south,
/// with water in sheets (area per width), at a channelization index; elevations after so many times
/// L²/D, L half the ridge's width.
fn strip(index: f64, rows: usize, cols: usize, times: f64, steps: u64) -> Vec<f64> {
    let (length, d) = (100.0, 0.01);
    let dx = length / (rows - 1) as f64;
    let mut grid = Grid::new(Shape::new(rows, cols), [dx; 2]).unwrap();
    grid.edges = Edges { south: Edge::Open, north: Edge::Closed, east: Edge::Periodic, west: Edge::Periodic };
    let z = (0..grid.len()).map(|i| if i / cols == rows - 1 { 0.0 } else { 0.1 * Seed(7).uniform(i as u64) });
    let terrain = HeightField::new(grid.clone(), z.collect()).unwrap();
    // C_I = K l^(m + n) / (D^n U^(1 - n)), m = 1/2, n = 1, l the ridge's whole width.
    let k = index * d / math::pow(2.0 * length, 1.5);
    let rivers = StreamPower {
        erodibility: Some(Erodibility::of(k).into()),
        multiple_flow: Some(1.1),
        specific_area: true,
        limiting_slope: Some(0.0),
        ..StreamPower::default()
    };
    let creep = LinearDiffusion { diffusivity: Diffusivity::of(d).into() };
    let duration = times * length * length / d * YEAR;
    let mut sim = Simulation::new(terrain)
        .process(uplift(0.1))
        .unwrap()
        .process(rivers)
        .unwrap()
        .process(creep)
        .unwrap()
        .dt(duration / steps as f64)
        .until(Stop::steps(steps));
    sim.run().unwrap();
    sim.into_terrain().elevation().to_vec()
}

/// Spread of the heights along a row, over their mean.
fn roughness(z: &[f64], cols: usize, row: usize) -> f64 {
    let row = &z[row * cols..(row + 1) * cols];
    let mean = row.iter().sum::<f64>() / cols as f64;
    (row.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / cols as f64).sqrt() / mean
}

#[test]
fn slopes_break_into_valleys_above_a_critical_index() {
    // VP3: smooth at 20, channels at 80 (critical: about 37, Bonetti et al. 2020; here between 28
    // and 56).
    let smooth = strip(20.0, 41, 120, 2.0, 200);
    let broken = strip(80.0, 41, 120, 2.0, 200);
    let at = |z: &[f64]| roughness(z, 120, 20);
    assert!(at(&smooth) < 1e-3, "{}", at(&smooth));
    assert!(at(&broken) > 0.05, "{}", at(&broken));
}

#[test]
fn a_threshold_spares_what_is_gentle() {
    // Where k A^m S^n stays below k theta nothing is cut; a river above it keeps the excess: S
    // A^m = theta + U/k at a steady state.
    let theta = 40.0;
    for n in [1.0, 1.4] {
        let rivers = StreamPower { threshold: theta, ..law(0.5, n) };
        let terrain = steady(raster(32, 3), rivers, 1000.0 * KYR);
        let domain = terrain.domain();
        let mut flow = Flow::new();
        let mut area = node_areas(&*domain);
        flow.route(&*domain, terrain.elevation(), &mut area);
        let z = terrain.elevation();
        let mut off: Vec<f64> = (0..z.len())
            .filter(|&i| domain.status()[i] == Status::Interior)
            .map(|i| {
                let slope = (z[i] - z[flow.receivers()[i] as usize]) / domain.distance(i, flow.slots()[i]);
                (area[i].sqrt() * math::pow(slope, n) / (theta + U / K) - 1.0).abs()
            })
            .collect();
        off.sort_by(f64::total_cmp);
        assert!(off[off.len() / 2] < 1e-6 && off[off.len() * 99 / 100] < 1e-3, "{n}: {:?}", off[off.len() / 2]);
    }
    let spared = StreamPower { threshold: 1e9, ..law(0.5, 1.0) };
    let before = raster(16, 1);
    let mut sim = Simulation::new(before.clone()).process(spared).unwrap().dt(KYR).until(Stop::steps(3));
    sim.run().unwrap();
    assert_eq!(sim.terrain().elevation(), before.elevation());
}
