//! Values that were used lately, as many as fit.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Values by key, of so many bytes in all; the least recently used is forgotten first.
///
/// ```
/// use landform_core::recent::Recent;
/// let recent = Recent::of(20);
/// recent.keep("a", 1, 10);
/// recent.keep("b", 2, 10);
/// assert_eq!(recent.find(&"a"), Some(1));
/// recent.keep("c", 3, 10);
/// assert_eq!((recent.find(&"a"), recent.find(&"b")), (Some(1), None));
/// ```
#[derive(Debug)]
pub struct Recent<K, V> {
    most_bytes: u64,
    /// The most recently used last.
    items: Mutex<Vec<(K, V, u64)>>,
}

impl<K: PartialEq, V: Clone> Recent<K, V> {
    /// Nothing yet, and at most so many bytes.
    pub fn of(most_bytes: u64) -> Self {
        Self { most_bytes, items: Mutex::new(Vec::new()) }
    }

    /// Whether anything can be kept.
    pub fn has_room(&self) -> bool {
        self.most_bytes > 0
    }

    fn items(&self) -> MutexGuard<'_, Vec<(K, V, u64)>> {
        // A list that somebody panicked over is still a list.
        self.items.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The value of a key, which counts as use.
    pub fn find(&self, key: &K) -> Option<V> {
        let mut items = self.items();
        let at = items.iter().position(|item| item.0 == *key)?;
        let item = items.remove(at);
        let found = item.1.clone();
        items.push(item);
        Some(found)
    }

    /// Keeps a value, unless it alone is too large.
    pub fn keep(&self, key: K, value: V, bytes: u64) {
        if bytes > self.most_bytes {
            return;
        }
        let mut items = self.items();
        items.retain(|item| item.0 != key);
        items.push((key, value, bytes));
        let mut total: u64 = items.iter().map(|item| item.2).sum();
        let mut oldest = 0;
        while total > self.most_bytes {
            total -= items[oldest].2;
            oldest += 1;
        }
        items.drain(..oldest);
    }

    /// Forgets a key.
    pub fn forget(&self, key: &K) {
        self.items().retain(|item| item.0 != *key);
    }

    /// Forgets everything.
    pub fn clear(&self) {
        self.items().clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_used_least_recently_goes_first() {
        let recent = Recent::of(20);
        recent.keep("a", 1, 10);
        recent.keep("b", 2, 10);
        assert!(recent.find(&"a").is_some());
        recent.keep("c", 3, 10);
        assert!(recent.find(&"b").is_none() && recent.find(&"a").is_some() && recent.find(&"c").is_some());
        Recent::of(9).keep("a", 1, 10);
        assert!(Recent::<&str, u8>::of(0).find(&"a").is_none());
    }

    #[test]
    fn what_is_too_large_is_not_kept_and_drives_nothing_out() {
        let recent = Recent::of(10);
        recent.keep("a", 1, 10);
        recent.keep("b", 2, 11);
        assert_eq!((recent.find(&"a"), recent.find(&"b")), (Some(1), None));
        recent.keep("a", 3, 4);
        assert_eq!(recent.find(&"a"), Some(3));
        recent.forget(&"a");
        assert!(recent.find(&"a").is_none() && !Recent::<u8, u8>::of(0).has_room());
    }
}
