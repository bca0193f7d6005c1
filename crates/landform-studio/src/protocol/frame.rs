//! Pictures of the ground in numbers, cut into messages.
//!
//! # Method
//! A message is the length of its header (u32, little endian), the header as JSON, zero bytes up to
//! a multiple of 8, and a band of rows. Numbers are f32 as they are, or u16: value = offset +
//! quantum · n, with 65535 for nodata; or differences of those along rows (the first of each row
//! from the one above it; the first row of a band from 0), wrapping, in zlib.

use std::io::Write;
use std::sync::Arc;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use serde_json::json;

/// Most bytes of a message.
pub(crate) const MOST_BYTES: usize = 1 << 20;
/// Bytes of a header are fewer.
const MOST_HEADER: usize = 2048;
/// Layers of more values are sent as whole numbers.
const MUCH: usize = 600_000;
/// Stands for nodata.
const NODATA: u16 = u16::MAX;

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    F32,
    U16,
    U16DeltaDeflate,
}

impl Encoding {
    fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::U16 => "u16",
            Self::U16DeltaDeflate => "u16_delta_deflate",
        }
    }

    fn bytes(self) -> usize {
        if self == Self::F32 { 4 } else { 2 }
    }
}

/// Values of one field.
#[derive(Debug)]
pub(crate) struct Layer {
    pub(crate) name: String,
    /// Row by row from the north; NaN where there is no data.
    pub(crate) values: Vec<f32>,
    pub(crate) min: f32,
    pub(crate) max: f32,
}

impl Layer {
    pub(crate) fn new(name: &str, values: Vec<f32>) -> Self {
        let valid = values.iter().copied().filter(|v| v.is_finite());
        let (min, max) = valid.fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let (min, max) = if min <= max { (min, max) } else { (0.0, 0.0) };
        Self { name: name.into(), values, min, max }
    }

    /// Value of 0 and of 1 as whole numbers.
    fn scale(&self) -> (f64, f64) {
        let (min, max) = (f64::from(self.min), f64::from(self.max));
        (min, ((max - min) / f64::from(NODATA - 1)).max(f64::MIN_POSITIVE))
    }
}

/// The ground at one moment.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) number: u64,
    pub(crate) revision: u64,
    pub(crate) level: String,
    pub(crate) rows: usize,
    pub(crate) cols: usize,
    pub(crate) cell_size: [f64; 2],
    /// Place of the south-west node, m.
    pub(crate) origin: [f64; 2],
    /// Time, s.
    pub(crate) time: f64,
    /// The step of the text that it is the ground of.
    pub(crate) stage: Option<usize>,
    pub(crate) sea_level: Option<f64>,
    /// The page's stamp of the change that it shows.
    pub(crate) stamp: Option<Stamp>,
    pub(crate) layers: Vec<Layer>,
}

/// Times of a change on its way, ms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stamp {
    /// By the page's clock.
    pub(crate) page: f64,
    /// When the server had it, by its own clock.
    pub(crate) received: f64,
    /// When the ground was there.
    pub(crate) computed: f64,
}

/// A message that is yet to be written.
#[derive(Clone, Debug)]
pub(crate) struct Band {
    frame: Arc<Frame>,
    layer: usize,
    first: usize,
    rows: usize,
    last: bool,
}

/// The messages of a frame with the fields that are wanted: elevation first.
pub(crate) fn bands(frame: &Arc<Frame>, wanted: &[String]) -> Vec<Band> {
    let most = (MOST_BYTES - MOST_HEADER) / (4 * frame.cols.max(1));
    let mut bands = Vec::new();
    for (k, layer) in frame.layers.iter().enumerate() {
        if k > 0 && !wanted.contains(&layer.name) {
            continue;
        }
        for first in (0..frame.rows).step_by(most.max(1)) {
            let rows = most.max(1).min(frame.rows - first);
            bands.push(Band { frame: frame.clone(), layer: k, first, rows, last: false });
        }
    }
    if let Some(band) = bands.last_mut() {
        band.last = true;
    }
    bands
}

impl Band {
    /// Whether it is of elevations so many that whole numbers are worth their loss.
    pub(crate) fn is_of_much(&self) -> bool {
        self.layer == 0 && self.frame.rows * self.frame.cols > MUCH
    }

    /// The message.
    pub(crate) fn write(&self, session: &str, encoding: Encoding) -> Vec<u8> {
        let (frame, layer) = (&*self.frame, &self.frame.layers[self.layer]);
        let (offset, quantum) = layer.scale();
        let (offset, quantum) = if encoding == Encoding::F32 { (0.0, 1.0) } else { (offset, quantum) };
        let header = json!({
            "protocol": 1, "session": session, "revision": frame.revision, "frame": frame.number,
            "layer": layer.name, "level": frame.level, "rows": frame.rows, "cols": frame.cols,
            "row0": self.first, "band_rows": self.rows, "last": self.last,
            "cell_size": frame.cell_size, "origin": frame.origin, "time": frame.time, "stage": frame.stage,
            "encoding": encoding.name(), "quantum": quantum, "offset": offset,
            "nodata": if encoding == Encoding::F32 { serde_json::Value::Null } else { NODATA.into() },
            "min": layer.min, "max": layer.max, "sea_level": frame.sea_level,
            "stamp": frame.stamp.map(|stamp| stamp.page),
        });
        let header = header.to_string();
        let values = &layer.values[self.first * frame.cols..(self.first + self.rows) * frame.cols];
        let mut message = Vec::with_capacity(header.len() + 16 + values.len() * encoding.bytes());
        message.extend((header.len() as u32).to_le_bytes());
        message.extend(header.as_bytes());
        message.resize(message.len().next_multiple_of(8), 0);
        match encoding {
            Encoding::F32 => message.extend(values.iter().flat_map(|v| v.to_le_bytes())),
            Encoding::U16 => message.extend(whole(values, offset, quantum).flat_map(u16::to_le_bytes)),
            Encoding::U16DeltaDeflate => {
                let numbers: Vec<u16> = whole(values, offset, quantum).collect();
                let mut packed = ZlibEncoder::new(message, Compression::fast());
                // Writing to memory cannot fail.
                let _ = packed.write_all(&differences(&numbers, frame.cols));
                message = packed.finish().unwrap_or_default();
            }
        }
        message
    }
}

/// The values as whole numbers of quanta.
fn whole(values: &[f32], offset: f64, quantum: f64) -> impl Iterator<Item = u16> + '_ {
    values.iter().map(move |&v| {
        if v.is_finite() {
            ((f64::from(v) - offset) / quantum).round().clamp(0.0, f64::from(NODATA - 1)) as u16
        } else {
            NODATA
        }
    })
}

/// Differences along rows; the first of a row from the first of the row above.
fn differences(numbers: &[u16], cols: usize) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(2 * numbers.len());
    let mut above = 0_u16;
    for row in numbers.chunks(cols.max(1)) {
        let mut left = above;
        for &number in row {
            bytes.extend(number.wrapping_sub(left).to_le_bytes());
            left = number;
        }
        above = row.first().copied().unwrap_or(0);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;

    fn frame(rows: usize, cols: usize) -> Arc<Frame> {
        let ramp = |k: usize| if k == 1 { f32::NAN } else { k as f32 - 5.0 };
        Arc::new(Frame {
            number: 3,
            revision: 2,
            level: "1/2".into(),
            rows,
            cols,
            cell_size: [10.0; 2],
            origin: [0.0, 90.0],
            time: 0.0,
            stage: None,
            sea_level: None,
            stamp: None,
            layers: ["elevation", "slope"].map(|n| Layer::new(n, (0..rows * cols).map(ramp).collect())).into(),
        })
    }

    fn parts(message: &[u8]) -> (serde_json::Value, &[u8]) {
        let length = u32::from_le_bytes(message[..4].try_into().unwrap()) as usize;
        let header = serde_json::from_slice(&message[4..4 + length]).unwrap();
        (header, &message[(4 + length).next_multiple_of(8)..])
    }

    #[test]
    fn bands_are_small_and_join_to_the_whole() {
        let frame = frame(600, 1000);
        let bands = bands(&frame, &["slope".to_string()]);
        let messages: Vec<_> = bands.iter().map(|b| b.write("s", Encoding::F32)).collect();
        assert!(messages.iter().all(|m| m.len() <= MOST_BYTES) && messages.len() == 6);
        let mut values = Vec::new();
        for (k, message) in messages.iter().enumerate() {
            let (header, data) = parts(message);
            assert_eq!(header["last"], k == 5);
            if header["layer"] == "elevation" {
                assert_eq!(header["row0"].as_u64().unwrap() as usize * 1000, values.len());
                values.extend(data.chunks(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())));
            }
        }
        assert_eq!(values.len(), 600_000);
        assert!(values[1].is_nan() && values[599_999] == 599_994.0);
    }

    #[test]
    fn whole_numbers_come_back_within_half_a_quantum() {
        let frame = frame(7, 9);
        let band = &bands(&frame, &[])[0];
        let (header, data) = parts(&band.write("s", Encoding::U16)).clone_data();
        let (offset, quantum) = (header["offset"].as_f64().unwrap(), header["quantum"].as_f64().unwrap());
        let numbers: Vec<u16> = data.chunks(2).map(|b| u16::from_le_bytes(b.try_into().unwrap())).collect();
        assert_eq!(numbers[1], NODATA);
        for (k, &n) in numbers.iter().enumerate().filter(|n| n.0 != 1) {
            assert!((offset + quantum * f64::from(n) - (k as f64 - 5.0)).abs() <= 0.5001 * quantum);
        }
        let (_, packed) = parts(&band.write("s", Encoding::U16DeltaDeflate)).clone_data();
        let mut bytes = Vec::new();
        flate2::read::ZlibDecoder::new(&packed[..]).read_to_end(&mut bytes).unwrap();
        let mut back = vec![0_u16; 63];
        for (k, b) in bytes.chunks(2).enumerate() {
            let before = if k % 9 > 0 {
                back[k - 1]
            } else if k > 0 {
                back[k - 9]
            } else {
                0
            };
            back[k] = before.wrapping_add(u16::from_le_bytes(b.try_into().unwrap()));
        }
        assert_eq!(back, numbers);
    }

    trait CloneData {
        fn clone_data(self) -> (serde_json::Value, Vec<u8>);
    }
    impl CloneData for (serde_json::Value, &[u8]) {
        fn clone_data(self) -> (serde_json::Value, Vec<u8>) {
            (self.0, self.1.to_vec())
        }
    }
}
