//! Karst networks of many seeds beside natural ones.

use landform::core::Result;
use landform::core::analysis::{NetworkStatistics, network_statistics};
use landform::core::feature::ConduitNetwork;
use landform::core::grid::{Grid, Shape};
use landform::core::random::Seed;
use landform::core::terrain::{HeightField, NodeSurface};
use landform::core::units::Length;
use landform::core::verb::{Context, Edit};
use landform::process::karst::{KarstNetwork, Method, Preset, Sinkholes, Spring};

const SEEDS: u64 = 20;
/// Presets were tuned on the first seeds, and not on the second.
const FIRST: [u64; 2] = [1, 101];

/// Prints, for each pattern and method, how many of the seeds lie in all natural ranges, and the
/// middle and the ends of each measure.
pub(super) fn networks() -> Result<()> {
    FIRST.into_iter().try_for_each(of_seeds)
}

fn of_seeds(first: u64) -> Result<()> {
    println!(
        "\nKarst networks on a plateau, seeds {first} to {}: seeds in all natural ranges; least, middle, greatest",
        first + SEEDS - 1
    );
    let patterns = [Preset::Branchwork, Preset::Mixed, Preset::Anastomotic];
    let mazes = [Preset::RectilinearMaze, Preset::Spongework].map(|preset| (preset, Method::SpaceColonisation));
    let both = |preset| [Method::SpaceColonisation, Method::ShortestPaths].map(|method| (preset, method));
    for (preset, method) in patterns.into_iter().flat_map(both).chain(mazes) {
        let all =
            (first..first + SEEDS).map(|seed| measured(preset, method, Seed(seed))).collect::<Result<Vec<_>>>()?;
        let in_all = all.iter().filter(|s| s.in_range == s.natural_ranges.len()).count();
        println!("{preset:?}, {method:?}: {in_all} of {SEEDS}");
        for (k, range) in all[0].natural_ranges.iter().enumerate() {
            let mut values: Vec<f64> = all.iter().map(|s| s.natural_ranges[k].value).collect();
            values.sort_by(f64::total_cmp);
            let [least, middle, most] = [0, values.len() / 2, values.len() - 1].map(|i| values[i]);
            println!("  {:<26} {least:>7.3} {middle:>7.3} {most:>7.3}  natural {:?}", range.measure, range.natural);
        }
    }
    Ok(())
}

fn measured(preset: Preset, method: Method, seed: Seed) -> Result<NetworkStatistics> {
    let springs = vec![Spring { at: [1900.0, 300.0].map(Length::of), water_table: Some(Length::of(20.0)) }];
    let sinkholes = Sinkholes::Count(40);
    let karst = KarstNetwork { preset, method, sinkholes, springs, ..KarstNetwork::default() };
    let mut ground = plateau()?;
    karst.edit(&mut ground, &Context { seed, ..Context::default() })?;
    let network = ConduitNetwork::of(ground.features());
    Ok(network_statistics(&network.nodes, &network.edges()))
}

/// A plateau that falls to a valley in the east.
fn plateau() -> Result<HeightField> {
    let grid = Grid::new(Shape::new(101, 101), [20.0; 2])?;
    let height = |i: usize| {
        let [x, y] = grid.position(i);
        let t = ((x / 2000.0 - 0.8) / 0.14).clamp(0.0, 1.0);
        140.0 - 120.0 * t * t * (3.0 - 2.0 * t) + 4.0 * ((x * 0.013 + y * 0.021) % 2.0)
    };
    let heights = (0..grid.len()).map(height).collect();
    HeightField::new(grid.clone(), heights)
}
