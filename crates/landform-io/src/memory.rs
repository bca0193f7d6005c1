//! Memory of the machine.

use landform_core::{Error, Result};

/// Bytes that this process may still take, if the system reports them: what is free, or what its
/// own limit leaves.
pub fn available() -> Option<u64> {
    let free = number("/proc/meminfo", "MemAvailable:", 0).map(|k| k * 1024);
    // `ulimit -v` limits addresses, of which some are taken.
    let limit = number("/proc/self/limits", "Max address space", 0);
    let taken = number("/proc/self/status", "VmSize:", 0).unwrap_or(0) * 1024;
    free.into_iter().chain(limit.map(|l| l.saturating_sub(taken))).min()
}

/// Most bytes of memory that this process has held at once, if the system reports it.
///
/// ```
/// assert!(landform_io::memory::peak().is_none_or(|bytes| bytes > 1 << 16));
/// ```
pub fn peak() -> Option<u64> {
    number("/proc/self/status", "VmHWM:", 0).map(|k| k * 1024)
}

/// The number at a place of the line of a file that begins with a key.
fn number(path: &str, key: &str, place: usize) -> Option<u64> {
    let text = std::fs::read_to_string(path).ok()?;
    let line = text.lines().find_map(|l| l.strip_prefix(key))?;
    line.split_whitespace().nth(place)?.parse().ok()
}

/// Refuses what needs more memory than there is.
///
/// # Errors
/// [`Error::Format`] with the bytes needed and left.
pub(crate) fn require(format: &'static str, what: &str, bytes: u64) -> Result<()> {
    match available() {
        Some(left) if bytes > left => Err(Error::Format {
            format,
            what: format!("{what} takes {} MB of memory; {} MB are left", bytes >> 20, left >> 20),
            hint: Some("cut out or coarsen it first, as by gdal_translate -outsize 25% 25%".into()),
        }),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_than_there_is_is_refused_with_a_way_out() {
        assert!(require("PNG", "it", 1).is_ok());
        if available().is_some() {
            let error = require("PNG", "a picture of 9 x 9", u64::MAX).unwrap_err();
            assert!(error.to_string().contains("MB of memory") && error.hint().is_some(), "{error}");
        }
    }
}
