//! The only parallel tools: ordered maps and fixed-tree sums. The only file that names rayon.
//!
//! Work is cut into pieces of fixed size, never by the number of threads, and pieces are combined
//! in order; so a result has the same bits on any number of threads.
//!
//! Which thread does which piece is decided in one function that is compiled once
//! ([`side_by_side`]). So a loop is compiled once where it is written, and not again for each way
//! in which work can be split and stolen. One indirect call a piece is all that this costs.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use crate::{Error, Result};

/// Length of a piece. Small enough to balance two cores on 10⁵ nodes, large enough that a piece
/// outweighs its scheduling.
pub const PIECE: usize = 16_384;

/// Pieces that few but costly values are cut into.
const PIECES: usize = 64;

/// More threads would spend their time waiting for each other.
const MOST_THREADS: usize = 512;

/// Does `work` of 0..count, on all threads.
#[inline(never)]
fn side_by_side(count: usize, work: &(dyn Fn(usize) + Sync)) {
    match count {
        0 => {}
        1 => work(0),
        _ => (0..count).into_par_iter().for_each(work),
    }
}

/// A value that one thread puts in or takes out, once.
struct Once<T>(Mutex<Option<T>>);

impl<T> Once<T> {
    fn new(value: Option<T>) -> Self {
        Self(Mutex::new(value))
    }

    fn swap(&self, value: Option<T>) -> Option<T> {
        std::mem::replace(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner), value)
    }
}

/// Does `work` of every task and its number.
fn each<T: Send>(tasks: Vec<T>, work: &(dyn Fn(usize, T) + Sync)) {
    let tasks: Vec<_> = tasks.into_iter().map(|task| Once::new(Some(task))).collect();
    side_by_side(tasks.len(), &|k| {
        if let Some(task) = tasks[k].swap(None) {
            work(k, task);
        }
    });
}

/// What `work` gives of every task, in order.
fn gather<T: Send, R: Send>(tasks: Vec<T>, work: &(dyn Fn(T) -> R + Sync)) -> Vec<R> {
    let results: Vec<_> = tasks.iter().map(|_| Once::new(None)).collect();
    each(tasks, &|k, task| {
        results[k].swap(Some(work(task)));
    });
    results.iter().filter_map(|result| result.swap(None)).collect()
}

/// Calls `f(i, &mut out[i])` for every index, in pieces of a size.
fn update_pieces<T: Send>(out: &mut [T], size: usize, f: impl Fn(usize, &mut T) + Sync) {
    each(out.chunks_mut(size).collect(), &|k, piece: &mut [T]| {
        for (j, v) in piece.iter_mut().enumerate() {
            f(k * size + j, v);
        }
    });
}

/// How many of `n` values, which may be costly, make a piece.
fn piece_of_costly(n: usize) -> usize {
    PIECE.min(n / PIECES + 1)
}

/// The sum of `f` over 0..n, added in a fixed order. **Cost** O(n).
pub fn sum(n: usize, f: impl Fn(usize) -> f64 + Sync) -> f64 {
    map_pieces(n, |r| r.map(&f).sum::<f64>()).into_iter().sum()
}

/// The greatest of `f` over 0..n, or negative infinity for n = 0; NaN is passed over.
pub fn max(n: usize, f: impl Fn(usize) -> f64 + Sync) -> f64 {
    map_pieces(n, |r| r.map(&f).fold(f64::NEG_INFINITY, f64::max)).into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// The first index for which `f` holds.
pub fn find_first(n: usize, f: impl Fn(usize) -> bool + Sync) -> Option<usize> {
    map_pieces(n, |mut r| r.find(|&i| f(i))).into_iter().flatten().next()
}

/// `f` of every index, in order.
pub fn map<T: Send + Clone + Default>(n: usize, f: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let mut out = vec![T::default(); n];
    update_pieces(&mut out, piece_of_costly(n), |i, v| *v = f(i));
    out
}

/// `f` of every piece of 0..n, in order.
pub fn map_pieces<T: Send>(n: usize, f: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
    gather((0..n).step_by(PIECE).collect(), &|first| f(first..(first + PIECE).min(n)))
}

/// Sets `out[i] = f(i)`.
pub fn fill<T: Send>(out: &mut [T], f: impl Fn(usize) -> T + Sync) {
    update(out, |i, v| *v = f(i));
}

/// Calls `f(i, &mut out[i])` for every index.
pub fn update<T: Send>(out: &mut [T], f: impl Fn(usize, &mut T) + Sync) {
    update_pieces(out, PIECE, f);
}

/// How many rows of `cols` values make a piece.
fn rows_of_a_piece(rows: usize, cols: usize) -> usize {
    (PIECE / cols.max(1)).min(rows / PIECES).max(1)
}

/// Calls `f(row, values)` for every row of a row-major slice.
pub fn for_rows_mut<T: Send>(out: &mut [T], cols: usize, f: impl Fn(usize, &mut [T]) + Sync) {
    let cols = cols.max(1);
    let rows = rows_of_a_piece(out.len() / cols, cols);
    each(out.chunks_mut(rows * cols).collect(), &|k, piece: &mut [T]| {
        for (j, row) in piece.chunks_mut(cols).enumerate() {
            f(k * rows + j, row);
        }
    });
}

/// Calls `f(first index, a, b)` for matching pieces of two slices of equal length.
pub fn for_pieces_mut2<A: Send, B: Send>(
    a: &mut [A],
    b: &mut [B],
    size: usize,
    f: impl Fn(usize, &mut [A], &mut [B]) + Sync,
) {
    let size = size.max(1);
    let pieces: Vec<_> = a.chunks_mut(size).zip(b.chunks_mut(size)).collect();
    each(pieces, &|k, (a, b): (&mut [A], &mut [B])| f(k * size, a, b));
}

/// Sorts by a total order in which no two different values are equal, so that the result does not
/// depend on how it is done.
pub fn sort_by<T: Send>(values: &mut [T], order: impl Fn(&T, &T) -> std::cmp::Ordering + Sync) {
    values.par_sort_unstable_by(order);
}

/// Calls `f(row, a, b)` for matching rows of two row-major slices of as many rows.
pub fn for_rows_mut2<A: Send, B: Send>(
    a: &mut [A],
    cols_a: usize,
    b: &mut [B],
    cols_b: usize,
    f: impl Fn(usize, &mut [A], &mut [B]) + Sync,
) {
    let rows = rows_of_a_piece(a.len() / cols_a.max(1), cols_a.max(cols_b));
    let pieces: Vec<_> = a.chunks_mut(rows * cols_a).zip(b.chunks_mut(rows * cols_b)).collect();
    each(pieces, &|k, (a, b): (&mut [A], &mut [B])| {
        for (j, (a, b)) in a.chunks_mut(cols_a).zip(b.chunks_mut(cols_b)).enumerate() {
            f(k * rows + j, a, b);
        }
    });
}

/// Calls `f(first index, pieces)` for matching pieces of slices of equal length and returns what it
/// gives, in order.
pub fn map_pieces_mut<const N: usize, A: Send, T: Send>(
    slices: [&mut [A]; N],
    size: usize,
    f: impl Fn(usize, [&mut [A]; N]) -> T + Sync,
) -> Vec<T> {
    let size = size.max(1);
    let count = slices.first().map_or(0, |s| s.len().div_ceil(size));
    let mut chunks = slices.map(|s| s.chunks_mut(size));
    let pieces: Vec<_> = (0..count).map(|k| (k, chunks.each_mut().map(|c| c.next().unwrap_or_default()))).collect();
    run_all(pieces, |(k, piece)| f(k * size, piece))
}

/// Does `f` for every task, side by side; returns what it gives, in order.
pub fn run_all<T: Send, R: Send>(tasks: Vec<T>, f: impl Fn(T) -> R + Sync) -> Vec<R> {
    gather(tasks, &f)
}

/// Runs `f` on exactly `threads` threads (0: as many as there are cores).
///
/// # Errors
/// [`Error::Parameter`] for more than 512 threads, [`Error::Io`] if they cannot be started.
pub fn with_threads<T: Send>(threads: usize, f: impl FnOnce() -> T + Send) -> Result<T> {
    if threads > MOST_THREADS {
        return Err(Error::parameter("threads", threads, &format!("at most {MOST_THREADS}; 0 takes all cores")));
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|e| Error::io("start", "threads", std::io::Error::other(e)))?;
    Ok(pool.install(f))
}

/// How many threads the current pool has.
pub fn threads() -> usize {
    rayon::current_num_threads()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_has_the_same_bits_on_any_number_of_threads() {
        let f = |i: usize| 1.0 / (i as f64 + 0.1);
        let sums: Vec<f64> = [1, 2, 3, 8].iter().map(|&t| with_threads(t, || sum(200_000, f)).unwrap()).collect();
        assert!(sums.iter().all(|s| s.to_bits() == sums[0].to_bits()));
    }

    #[test]
    fn map_keeps_order_and_find_first_finds_the_first() {
        assert!(map(50_000, |i| i).iter().enumerate().all(|(i, &v)| i == v));
        assert_eq!(find_first(100_000, |i| i % 30_000 == 29_999), Some(29_999));
        assert_eq!(max(0, |_| 1.0), f64::NEG_INFINITY);
    }
}
