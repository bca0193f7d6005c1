//! Terrains in memory, the least recently used forgotten first.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use landform_core::terrain::bytes_a_node;
use landform_core::verb::Event;

use crate::recipe::AnyTerrain;

/// Terrains in memory.
#[derive(Debug, Default)]
pub(super) struct Memory {
    most_bytes: u64,
    /// The most recently used last.
    items: Mutex<Vec<Item>>,
}

#[derive(Debug)]
struct Item {
    key: String,
    terrain: Arc<AnyTerrain>,
    event: Event,
    bytes: u64,
}

impl Memory {
    pub(super) fn of(most_bytes: u64) -> Self {
        Self { most_bytes, items: Mutex::default() }
    }

    fn items(&self) -> MutexGuard<'_, Vec<Item>> {
        // A list is still valid after a panic of another thread.
        self.items.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn find(&self, key: &str) -> Option<(Arc<AnyTerrain>, Event)> {
        let mut items = self.items();
        let at = items.iter().position(|item| item.key == key)?;
        let item = items.remove(at);
        let found = (item.terrain.clone(), item.event.clone());
        items.push(item);
        Some(found)
    }

    /// Keeps a terrain, unless it alone is too large.
    pub(super) fn keep(&self, key: &str, terrain: &Arc<AnyTerrain>, event: &Event) {
        let bytes = terrain.elevation().len() as u64 * bytes_a_node(terrain.kind());
        if bytes > self.most_bytes {
            return;
        }
        let mut items = self.items();
        items.retain(|item| item.key != key);
        items.push(Item { key: key.into(), terrain: terrain.clone(), event: event.clone(), bytes });
        let mut total: u64 = items.iter().map(|item| item.bytes).sum();
        let mut oldest = 0;
        while total > self.most_bytes {
            total -= items[oldest].bytes;
            oldest += 1;
        }
        items.drain(..oldest);
    }

    pub(super) fn forget(&self, key: &str) {
        self.items().retain(|item| item.key != key);
    }

    pub(super) fn clear(&self) {
        self.items().clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::{HeightField, Representation};

    #[test]
    #[allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]
    fn what_was_used_least_recently_goes_first() {
        let grid = Grid::new(Shape::new(10, 10), [1.0, 1.0]).unwrap();
        let terrain = Arc::new(HeightField::new(grid, vec![0.0; 100]).unwrap().wrap());
        let event = Event { stage: "flat".into(), parameters: String::new(), sources: Vec::new(), outcome: None };
        let one = 100 * bytes_a_node(terrain.kind());
        let memory = Memory::of(2 * one);
        memory.keep("a", &terrain, &event);
        memory.keep("b", &terrain, &event);
        assert!(memory.find("a").is_some());
        memory.keep("c", &terrain, &event);
        assert!(memory.find("b").is_none() && memory.find("a").is_some() && memory.find("c").is_some());
        Memory::of(one - 1).keep("a", &terrain, &event);
        assert!(Memory::of(0).find("a").is_none());
    }
}
