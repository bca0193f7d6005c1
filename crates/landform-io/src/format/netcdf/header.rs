//! The header of the classic format, and numbers as it stores them.

use landform_core::{Error, Result};

const NAME: &str = super::NAME;
/// Marks of the lists of the header.
const DIMENSIONS: u32 = 10;
const VARIABLES: u32 = 11;
const ATTRIBUTES: u32 = 12;
/// Greatest offset of the first format.
const SMALL: u64 = i32::MAX as u64;

/// Kinds of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Byte = 1,
    Char,
    Short,
    Int,
    Float,
    Double,
}

impl Kind {
    fn of(code: u32) -> Result<Self> {
        let all = [Self::Byte, Self::Char, Self::Short, Self::Int, Self::Float, Self::Double];
        let fail = || Error::format(NAME, format!("{code} is no type of the classic format"));
        all.into_iter().find(|kind| *kind as u32 == code).ok_or_else(fail)
    }

    fn size(self) -> usize {
        match self {
            Self::Byte | Self::Char => 1,
            Self::Short => 2,
            Self::Int | Self::Float => 4,
            Self::Double => 8,
        }
    }

    fn number(self, b: &[u8]) -> f64 {
        match (self, b) {
            (Self::Byte | Self::Char, [a, ..]) => f64::from(i8::from_be_bytes([*a])),
            (Self::Short, [a, b, ..]) => f64::from(i16::from_be_bytes([*a, *b])),
            (Self::Int, [a, b, c, d, ..]) => f64::from(i32::from_be_bytes([*a, *b, *c, *d])),
            (Self::Float, [a, b, c, d, ..]) => f64::from(f32::from_be_bytes([*a, *b, *c, *d])),
            (Self::Double, [a, b, c, d, e, f, g, h, ..]) => f64::from_be_bytes([*a, *b, *c, *d, *e, *f, *g, *h]),
            _ => f64::NAN,
        }
    }

    fn put(self, out: &mut Vec<u8>, v: f64) {
        match self {
            Self::Byte | Self::Char => out.extend((v as i8).to_be_bytes()),
            Self::Short => out.extend((v as i16).to_be_bytes()),
            Self::Int => out.extend((v as i32).to_be_bytes()),
            Self::Float => out.extend((v as f32).to_be_bytes()),
            Self::Double => out.extend(v.to_be_bytes()),
        }
    }
}

/// Text or numbers that belong to a variable.
#[derive(Clone, Debug)]
pub(super) enum Attribute {
    Text(String),
    Numbers(Kind, Vec<f64>),
}

impl Attribute {
    pub(super) fn of_text(text: &str) -> Self {
        Self::Text(text.into())
    }

    pub(super) fn text(&self) -> Option<String> {
        match self {
            Self::Text(text) => Some(text.trim_end_matches('\0').trim().to_string()),
            Self::Numbers(..) => None,
        }
    }

    pub(super) fn number(&self) -> Option<f64> {
        match self {
            Self::Numbers(_, numbers) => numbers.first().copied(),
            Self::Text(_) => None,
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Variable {
    pub(super) name: String,
    pub(super) dimensions: Vec<usize>,
    attributes: Vec<(String, Attribute)>,
    kind: Kind,
    begin: u64,
}

impl Variable {
    pub(super) fn attribute(&self, name: &str) -> Option<&Attribute> {
        self.attributes.iter().find(|a| a.0 == name).map(|a| &a.1)
    }

    /// The first `count` numbers.
    pub(super) fn numbers(&self, bytes: &[u8], count: usize) -> Result<Vec<f64>> {
        let size = self.kind.size();
        let end = count.checked_mul(size).and_then(|n| n.checked_add(usize::try_from(self.begin).ok()?));
        let stored = end.and_then(|end| bytes.get(self.begin as usize..end));
        let stored = stored.ok_or_else(|| Error::format(NAME, "it is truncated"))?;
        Ok(stored.chunks_exact(size).map(|b| self.kind.number(b)).collect())
    }
}

#[derive(Clone, Debug, Default)]
pub(super) struct Header {
    /// Names and lengths.
    pub(super) dimensions: Vec<(String, u64)>,
    variables: Vec<Variable>,
}

/// Where a reader stands.
struct Cursor<'a> {
    rest: &'a [u8],
    is_large: bool,
}

impl<'a> Cursor<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or_else(|| Error::format(NAME, "it is truncated"))?;
        self.rest = rest;
        Ok(taken)
    }

    fn word(&mut self) -> Result<u32> {
        let b = self.take(4)?;
        Ok(u32::from_be_bytes([b[0], b[1], b[2], b[3]]))
    }

    fn offset(&mut self) -> Result<u64> {
        let high = if self.is_large { u64::from(self.word()?) << 32 } else { 0 };
        Ok(high | u64::from(self.word()?))
    }

    /// Bytes that are padded to four.
    fn padded(&mut self, count: usize) -> Result<&'a [u8]> {
        let whole = self.take(count.checked_next_multiple_of(4).unwrap_or(usize::MAX))?;
        Ok(&whole[..count])
    }

    fn name(&mut self) -> Result<String> {
        let count = self.word()? as usize;
        Ok(String::from_utf8_lossy(self.padded(count)?).into_owned())
    }

    /// How many items a list has.
    fn list(&mut self, mark: u32) -> Result<u32> {
        let (found, count) = (self.word()?, self.word()?);
        // An item takes eight bytes at least.
        if found != mark && (found, count) != (0, 0) || count as usize > self.rest.len() / 8 {
            return Err(Error::format(NAME, "a list of its header is broken"));
        }
        Ok(count)
    }

    fn attributes(&mut self) -> Result<Vec<(String, Attribute)>> {
        let count = self.list(ATTRIBUTES)?;
        let mut list = Vec::new();
        for _ in 0..count {
            let (name, kind, length) = (self.name()?, Kind::of(self.word()?)?, self.word()? as usize);
            let bytes = self.padded(length.saturating_mul(kind.size()))?;
            let value = match kind {
                Kind::Char => Attribute::Text(String::from_utf8_lossy(bytes).into_owned()),
                _ => Attribute::Numbers(kind, bytes.chunks_exact(kind.size()).map(|b| kind.number(b)).collect()),
            };
            list.push((name, value));
        }
        Ok(list)
    }
}

impl Header {
    pub(super) fn read(bytes: &[u8]) -> Result<Self> {
        let is_large = match bytes {
            [b'C', b'D', b'F', 1, ..] => false,
            [b'C', b'D', b'F', 2, ..] => true,
            [0x89, b'H', b'D', b'F', ..] => {
                return Err(Error::Format {
                    format: NAME,
                    what: "it is a netCDF-4 file".into(),
                    hint: Some("nccopy -k classic in.nc out.nc turns it into the classic format".into()),
                });
            }
            _ => return Err(Error::format(NAME, "it does not begin as one of the classic format")),
        };
        let mut cursor = Cursor { rest: &bytes[4..], is_large };
        cursor.word()?;
        let mut header = Self::default();
        for _ in 0..cursor.list(DIMENSIONS)? {
            let (name, length) = (cursor.name()?, cursor.word()?);
            header.dimensions.push((name, u64::from(length)));
        }
        cursor.attributes()?;
        for _ in 0..cursor.list(VARIABLES)? {
            let (name, count) = (cursor.name()?, cursor.word()?);
            let mut dimensions = Vec::new();
            for _ in 0..count {
                let number = cursor.word()? as usize;
                if number >= header.dimensions.len() {
                    return Err(Error::format(NAME, format!("variable `{name}` lies over no dimension {number}")));
                }
                dimensions.push(number);
            }
            let (attributes, kind) = (cursor.attributes()?, Kind::of(cursor.word()?)?);
            cursor.word()?;
            let begin = cursor.offset()?;
            header.variables.push(Variable { name, dimensions, attributes, kind, begin });
        }
        Ok(header)
    }

    pub(super) fn named(&self, name: &str) -> Option<&Variable> {
        self.variables.iter().find(|v| v.name == name)
    }

    /// The first variable over two dimensions of fixed length.
    pub(super) fn raster(&self) -> Result<&Variable> {
        let is_raster = |v: &&Variable| {
            v.dimensions.len() == 2 && v.kind != Kind::Char && v.dimensions.iter().all(|&d| self.dimensions[d].1 > 0)
        };
        self.variables.iter().find(is_raster).ok_or_else(|| Error::Format {
            format: NAME,
            what: "it has no variable over two coordinates".into(),
            hint: Some("choose one time or level: ncks -d time,0 in.nc out.nc".into()),
        })
    }
}

/// A file that is put together.
pub(super) struct Writer {
    head: Vec<u8>,
    global: Vec<(&'static str, Attribute)>,
    /// Head, length of the numbers in the file, kind, numbers.
    variables: Vec<(Vec<u8>, usize, Kind, Vec<f64>)>,
}

fn word(out: &mut Vec<u8>, value: usize) {
    out.extend((value as u32).to_be_bytes());
}

fn padded(out: &mut Vec<u8>, bytes: &[u8]) {
    out.extend(bytes);
    out.resize(out.len() + bytes.len().next_multiple_of(4) - bytes.len(), 0);
}

fn name(out: &mut Vec<u8>, text: &str) {
    word(out, text.len());
    padded(out, text.as_bytes());
}

fn attributes(out: &mut Vec<u8>, list: &[(&'static str, Attribute)]) {
    if list.is_empty() {
        return out.extend([0; 8]);
    }
    out.extend(ATTRIBUTES.to_be_bytes());
    word(out, list.len());
    for (key, value) in list {
        name(out, key);
        let (kind, count, bytes) = match value {
            Attribute::Text(text) => (Kind::Char, text.len(), text.clone().into_bytes()),
            Attribute::Numbers(kind, numbers) => {
                let mut bytes = Vec::new();
                numbers.iter().for_each(|&v| kind.put(&mut bytes, v));
                (*kind, numbers.len(), bytes)
            }
        };
        out.extend((kind as u32).to_be_bytes());
        word(out, count);
        padded(out, &bytes);
    }
}

impl Writer {
    pub(super) fn new(dimensions: &[(&str, usize)]) -> Self {
        let mut head = DIMENSIONS.to_be_bytes().to_vec();
        word(&mut head, dimensions.len());
        for (key, length) in dimensions {
            name(&mut head, key);
            word(&mut head, *length);
        }
        Self { head, global: Vec::new(), variables: Vec::new() }
    }

    pub(super) fn global(&mut self, key: &'static str, value: Attribute) {
        self.global.push((key, value));
    }

    pub(super) fn variable(
        &mut self,
        key: &str,
        dimensions: &[usize],
        list: Vec<(&'static str, Attribute)>,
        kind: Kind,
        numbers: Vec<f64>,
    ) {
        let mut head = Vec::new();
        name(&mut head, key);
        word(&mut head, dimensions.len());
        dimensions.iter().for_each(|&d| word(&mut head, d));
        attributes(&mut head, &list);
        let length = (numbers.len() * kind.size()).next_multiple_of(4);
        head.extend((kind as u32).to_be_bytes());
        // Readers take the length from the dimensions where it is too large for its place.
        head.extend(u32::try_from(length).unwrap_or(u32::MAX).to_be_bytes());
        self.variables.push((head, length, kind, numbers));
    }

    pub(super) fn bytes(self) -> Result<Vec<u8>> {
        let Self { mut head, global, variables } = self;
        attributes(&mut head, &global);
        head.extend(VARIABLES.to_be_bytes());
        word(&mut head, variables.len());
        let all: u64 = variables.iter().map(|v| v.1 as u64).sum();
        let least = 8 + head.len() + variables.iter().map(|v| v.0.len()).sum::<usize>();
        let is_large = least as u64 + 4 * variables.len() as u64 + all > SMALL;
        let mut begin = least as u64 + if is_large { 8 } else { 4 } * variables.len() as u64;
        let mut out = vec![b'C', b'D', b'F', if is_large { 2 } else { 1 }, 0, 0, 0, 0];
        out.append(&mut head);
        for (head, length, ..) in &variables {
            out.extend(head);
            if is_large {
                out.extend(begin.to_be_bytes());
            } else {
                out.extend((begin as u32).to_be_bytes());
            }
            begin += *length as u64;
        }
        for (_, length, kind, numbers) in variables {
            let start = out.len();
            numbers.into_iter().for_each(|v| kind.put(&mut out, v));
            out.resize(start + length, 0);
        }
        Ok(out)
    }
}
