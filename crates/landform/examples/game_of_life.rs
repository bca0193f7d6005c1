//! Conway's Game of Life on the automaton (Koh 2002, figure 8): little is alike from one picture to
//! the next.
//!
//! `cargo run --release --example game_of_life` writes game_of_life.gif into the folder it is run
//! in.

use landform::core::Result;
use landform::core::agents::{Automaton, Neighbourhood};
use landform::core::grid::Shape;
use landform::core::random::Seed;
use landform::io::format::encode_animation;

/// Alive with three living neighbours; alive with two, if it was.
pub(crate) fn life(n: Neighbourhood<bool>) -> bool {
    let neighbours = n.around.iter().filter(|alive| **alive).count();
    neighbours == 3 || n.cell && neighbours == 2
}

/// A torus of which a third lives at random.
pub(crate) fn world(n: usize, seed: u64) -> Result<Automaton<bool>> {
    let cells = (0..n * n).map(|i| Seed(seed).uniform(i as u64) < 1.0 / 3.0).collect();
    Automaton::new(Shape::new(n, n), cells, None)
}

fn main() -> Result<()> {
    let mut world = world(160, 1)?;
    let mut frames: Vec<Vec<[u8; 3]>> = Vec::new();
    for _ in 0..100 {
        frames.push(world.cells().iter().map(|alive| if *alive { [40, 60, 40] } else { [235, 232, 222] }).collect());
        world.step(life);
    }
    let frames: Vec<&[[u8; 3]]> = frames.iter().map(Vec::as_slice).collect();
    let path = std::path::Path::new("game_of_life.gif");
    let bytes = encode_animation("game_of_life.gif", Shape::new(160, 160), &frames)?;
    std::fs::write(path, bytes).map_err(|e| landform::core::Error::io("write", path, e))
}
