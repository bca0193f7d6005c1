//! The header of a NumPy array: what its numbers are, in which order, and how many.
//!
//! # Sources
//! NumPy enhancement proposal 1, *A simple file format for NumPy arrays*: versions 1 to 3, which
//! differ in the size of the length and in the characters that names of columns may have.

use landform_core::{Error, Result};

use super::NAME;

const MAGIC: &[u8] = b"\x93NUMPY";
/// What precedes the numbers is filled up to a multiple of this.
const ALIGNMENT: usize = 64;

/// What the file says of its numbers.
#[derive(Debug, PartialEq)]
pub(super) struct Header {
    /// As NumPy writes a plain type, such as `<f4`; none for columns with names.
    pub(super) kind: Option<String>,
    /// Whether the first index runs fastest.
    pub(super) is_fortran: bool,
    pub(super) shape: Vec<u64>,
    /// Where the numbers begin.
    pub(super) start: usize,
}

impl Header {
    /// # Errors
    /// [`Error::Format`] where the header is none, or damaged.
    pub(super) fn read(bytes: &[u8]) -> Result<Self> {
        let wrong = |what: &str| Error::format(NAME, what);
        let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| wrong("it does not begin as one"))?;
        let (from, length) = match *rest {
            [1, _, a, b, ..] => (10, usize::from(u16::from_le_bytes([a, b]))),
            [2 | 3, _, a, b, c, d, ..] => (12, u32::from_le_bytes([a, b, c, d]) as usize),
            [version, _, ..] => return Err(wrong(&format!("version {version} is not read; expected 1, 2 or 3"))),
            _ => return Err(wrong("it is truncated")),
        };
        let start = from + length;
        let text = bytes.get(from..start).ok_or_else(|| wrong("its header is truncated"))?;
        let text = std::str::from_utf8(text).map_err(|_| wrong("its header is no text"))?;
        let value = |key: &str| value_of(text, key).ok_or_else(|| wrong(&format!("its header lacks {key}")));
        Ok(Self {
            kind: quoted(value("descr")?),
            is_fortran: value("fortran_order")?.starts_with("True"),
            shape: tuple(value("shape")?).ok_or_else(|| wrong("its shape is no tuple of whole numbers"))?,
            start,
        })
    }

    /// The bytes before the numbers of an array in rows, in version 1.
    pub(super) fn write(kind: &str, rows: usize, cols: usize) -> Vec<u8> {
        let mut text = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({rows}, {cols}), }}");
        let filled = (MAGIC.len() + 4 + text.len() + 1).next_multiple_of(ALIGNMENT);
        text += &" ".repeat(filled - MAGIC.len() - 4 - text.len() - 1);
        text.push('\n');
        [MAGIC, &[1, 0], &(text.len() as u16).to_le_bytes(), text.as_bytes()].concat()
    }
}

/// What follows a key of a dictionary as Python writes it.
fn value_of<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    let after = |quote: char| text.split_once(&format!("{quote}{key}{quote}")).map(|(_, rest)| rest);
    after('\'').or_else(|| after('"'))?.trim_start().strip_prefix(':').map(str::trim_start)
}

fn quoted(value: &str) -> Option<String> {
    let quote = value.chars().next().filter(|c| ['\'', '"'].contains(c))?;
    value[1..].split_once(quote).map(|(inner, _)| inner.into())
}

fn tuple(value: &str) -> Option<Vec<u64>> {
    let (inner, _) = value.strip_prefix('(')?.split_once(')')?;
    let entries = inner.split(',').map(str::trim).filter(|entry| !entry.is_empty());
    entries.map(|entry| entry.trim_end_matches('L').parse().ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(version: u8, dictionary: &str) -> Vec<u8> {
        let length = (dictionary.len() as u32).to_le_bytes();
        let length = if version == 1 { &length[..2] } else { &length };
        [MAGIC, &[version, 0], length, dictionary.as_bytes(), &[0; 8]].concat()
    }

    #[test]
    fn headers_of_all_versions_are_read() {
        let numpy = "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }          \n";
        let other = "{\"shape\": (5L,), \"descr\": \">i2\",\"fortran_order\" : True}";
        let columns = "{'descr': [('z', '<f4')], 'fortran_order': False, 'shape': (), }";
        for (version, from) in [(1, 10), (2, 12), (3, 12)] {
            let read = |text: &str| Header::read(&file(version, text)).unwrap();
            let header = |kind: Option<&str>, is_fortran, shape: &[u64], text: &str| Header {
                kind: kind.map(str::to_owned),
                is_fortran,
                shape: shape.to_vec(),
                start: from + text.len(),
            };
            assert_eq!(read(numpy), header(Some("<f4"), false, &[3, 4], numpy));
            assert_eq!(read(other), header(Some(">i2"), true, &[5], other));
            assert_eq!(read(columns), header(None, false, &[], columns));
        }
    }

    #[test]
    fn what_is_written_is_aligned_and_read_again() {
        let bytes = Header::write("<u4", 30, 4000);
        assert_eq!(bytes.len() % ALIGNMENT, 0);
        assert_eq!(bytes.last(), Some(&b'\n'));
        let header = Header { kind: Some("<u4".into()), is_fortran: false, shape: vec![30, 4000], start: bytes.len() };
        assert_eq!(Header::read(&bytes).unwrap(), header);
    }

    #[test]
    fn damaged_headers_are_refused() {
        let whole = Header::write("<f4", 2, 2);
        for length in 0..whole.len() {
            assert!(Header::read(&whole[..length]).is_err());
        }
        for text in
            ["", "{'descr': '<f4', 'shape': (2, 2)}", "{'descr': '<f4', 'fortran_order': False, 'shape': (-2, 2)}"]
        {
            assert!(Header::read(&file(1, text)).is_err());
        }
        assert!(Header::read(&file(4, "")).unwrap_err().to_string().contains("version 4"));
    }
}
