//! The samples of one band, strip by strip or tile by tile.

use landform_core::grid::Shape;
use landform_core::{Error, Result, parallel};
use tiff::tags::Tag;

use super::numbers::Kind;
use super::unpack::Packing;
use super::{NAME, Reader, fail};
use crate::format::{check_dimensions, most_unpacked};

/// How the samples of an image lie in a file.
pub(super) struct Blocks<'a> {
    bytes: &'a [u8],
    pub(super) shape: Shape,
    /// Bands in all.
    pub(super) bands: usize,
    /// Rows and columns of a strip or tile.
    size: [usize; 2],
    /// Whether every band has blocks of its own.
    is_planar: bool,
    kind: Kind,
    packing: Packing,
    offsets: Vec<u64>,
    lengths: Vec<u64>,
}

impl<'a> Blocks<'a> {
    /// Of the image that the decoder stands at.
    ///
    /// # Errors
    /// [`Error::Format`].
    pub(super) fn of(tiff: &mut Reader<'a>, bytes: &'a [u8], shape: Shape) -> Result<Self> {
        let packing = Packing::of(first(tiff, Tag::Compression, 1)?)?;
        let (bits, format) = (first(tiff, Tag::BitsPerSample, 1)?, first(tiff, Tag::SampleFormat, 1)?);
        let is_big = tiff.byte_order() == tiff::tags::ByteOrder::BigEndian;
        let sample = u64::from(bits).div_ceil(8);
        check_dimensions(NAME, shape.rows as u64, shape.cols as u64, sample, bytes.len())?;
        let kind = Kind::new(bits, format, first(tiff, Tag::Predictor, 1)?, is_big)?;
        let is_tiled = tiff.get_chunk_type() == tiff::decoder::ChunkType::Tile;
        let (cols, rows) = tiff.chunk_dimensions();
        let (at, long) =
            if is_tiled { (Tag::TileOffsets, Tag::TileByteCounts) } else { (Tag::StripOffsets, Tag::StripByteCounts) };
        let found = Self {
            bytes,
            shape,
            bands: usize::from(first(tiff, Tag::SamplesPerPixel, 1)?),
            size: [rows as usize, cols as usize],
            is_planar: first(tiff, Tag::PlanarConfiguration, 1)? == 2,
            kind,
            packing,
            offsets: tiff.get_tag_u64_vec(at).map_err(fail)?,
            lengths: tiff.get_tag_u64_vec(long).map_err(fail)?,
        };
        found.check_size()?;
        Ok(found)
    }

    /// Refuses blocks that reach so far beyond the image that to unpack them all is absurd.
    fn check_size(&self) -> Result<()> {
        let samples = self.size[1].checked_mul(if self.is_planar { 1 } else { self.bands });
        let row = samples.and_then(|n| self.kind.row_bytes(n));
        let bytes = row.and_then(|w| w.checked_mul(self.size[0].min(self.shape.rows))?.checked_mul(self.plane()));
        if bytes.is_some_and(|b| b as u64 <= 4 * most_unpacked(self.bytes.len())) {
            return Ok(());
        }
        let what = format!("its blocks of {} x {} are more than the file can hold", self.size[1], self.size[0]);
        Err(Error::format(NAME, what))
    }

    /// Refuses a file that ends before a block of its first band begins.
    ///
    /// # Errors
    /// [`Error::Format`].
    pub(super) fn check_whole(&self) -> Result<()> {
        (0..self.plane()).try_for_each(|k| self.packed(k).map(drop))
    }

    fn across(&self) -> usize {
        self.shape.cols.div_ceil(self.size[1])
    }

    fn plane(&self) -> usize {
        self.across() * self.shape.rows.div_ceil(self.size[0])
    }

    /// The samples of a band, and how many blocks are absent: there they are `absent`.
    ///
    /// # Errors
    /// [`Error::Format`] where a block is damaged.
    pub(super) fn band(&self, tiff: &mut Reader<'a>, band: usize, absent: f64) -> Result<(Vec<f64>, usize)> {
        let first = if self.is_planar { band * self.plane() } else { 0 };
        let blocks: Vec<Result<Option<Vec<f64>>>> = if self.packing == Packing::Jpeg {
            (0..self.plane()).map(|k| self.picture(tiff, first + k, band)).collect()
        } else {
            parallel::run_all((0..self.plane()).collect(), |k| self.block(first + k, k, band))
        };
        let mut samples = vec![absent; self.shape.len()];
        let mut missing = 0;
        for (k, block) in blocks.into_iter().enumerate() {
            let Some(block) = block? else {
                missing += 1;
                continue;
            };
            let (top, left, [_, cols]) = self.window(k);
            for (r, row) in block.chunks_exact(cols).enumerate() {
                let start = self.shape.index(top + r, left);
                samples[start..start + cols].copy_from_slice(row);
            }
        }
        Ok((samples, missing))
    }

    /// First row and column of a block, and its rows and columns within the image.
    fn window(&self, k: usize) -> (usize, usize, [usize; 2]) {
        let (top, left) = (k / self.across() * self.size[0], k % self.across() * self.size[1]);
        (top, left, [self.size[0].min(self.shape.rows - top), self.size[1].min(self.shape.cols - left)])
    }

    /// The bytes of a block; none if it is absent.
    fn packed(&self, number: usize) -> Result<Option<&[u8]>> {
        let range = self.offsets.get(number).zip(self.lengths.get(number));
        let (&offset, &length) = range.ok_or_else(|| Error::format(NAME, "it has too few strips or tiles"))?;
        if offset == 0 || length == 0 {
            return Ok(None);
        }
        let cut = || Error::format(NAME, "it ends before its data does: truncated");
        let start = usize::try_from(offset).map_err(|_| cut())?;
        let rest = self.bytes.get(start..).ok_or_else(cut)?;
        let length = usize::try_from(length).map_err(|_| cut())?;
        // What is packed says itself where it is cut off.
        Ok(Some(rest.get(..length).unwrap_or(rest)))
    }

    fn block(&self, number: usize, k: usize, band: usize) -> Result<Option<Vec<f64>>> {
        let Some(packed) = self.packed(number)? else { return Ok(None) };
        let (bands, first) = if self.is_planar { (1, 0) } else { (self.bands, band) };
        let (_, _, [rows, cols]) = self.window(k);
        // Neither overflows: the size was checked.
        let width = self.kind.row_bytes(self.size[1] * bands).unwrap_or(0).max(1);
        let mut bytes = self.packing.unpack(packed, width * rows)?;
        let mut samples = Vec::with_capacity(rows * cols);
        for row in bytes.chunks_exact_mut(width) {
            self.kind.undo_predictor(row, bands);
            self.kind.pick(row, first, bands, cols, &mut samples);
        }
        Ok(Some(samples))
    }

    /// A block of a picture.
    fn picture(&self, tiff: &mut Reader<'a>, number: usize, band: usize) -> Result<Option<Vec<f64>>> {
        if self.packed(number)?.is_none() {
            return Ok(None);
        }
        let k = if self.is_planar { number % self.plane() } else { number };
        let (_, _, [rows, cols]) = self.window(k);
        let number = u32::try_from(number).map_err(|e| Error::format(NAME, e))?;
        let tiff::decoder::DecodingResult::U8(samples) = tiff.read_chunk(number).map_err(fail)? else {
            return Err(Error::format(NAME, "its JPEG data are not of 8 bits"));
        };
        let bands = samples.len() / (rows * cols);
        if bands == 0 || samples.len() % (rows * cols) != 0 {
            return Err(Error::format(NAME, format!("a block has {} samples for {cols} x {rows}", samples.len())));
        }
        let first = if self.is_planar { 0 } else { band.min(bands - 1) };
        Ok(Some(samples.iter().skip(first).step_by(bands).map(|v| f64::from(*v)).collect()))
    }
}

/// The first number of a tag.
fn first(tiff: &mut Reader, tag: Tag, default: u16) -> Result<u16> {
    let values = tiff.find_tag_unsigned_vec::<u16>(tag).map_err(fail)?;
    Ok(values.and_then(|v| v.first().copied()).unwrap_or(default))
}
