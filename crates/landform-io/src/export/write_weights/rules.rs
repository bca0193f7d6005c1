//! Where a layer lies, and weights as whole numbers.

use landform_core::algo::derivative::slope;
use landform_core::field::names;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Length, parse_as};
use landform_core::verb::is_plain_name;
use landform_core::{Error, Result, math, parallel};

use super::{Bound, WeightLayer, WriteWeights};

impl WeightLayer {
    /// Whether it lies everywhere.
    fn is_plain(&self) -> bool {
        self.slope.is_none() && self.height.is_none() && self.field.is_none()
    }

    /// Refuses a name that is none, and rules that do not go together.
    pub(super) fn check(&self, is_last: bool) -> Result<()> {
        if !is_plain_name(&self.name) {
            let expected = "a name of letters, digits, spaces, _ and -, at most 60 long";
            return Err(Error::parameter("layers", format!("with the name {:?}", self.name), expected));
        }
        if self.is_plain() != is_last {
            let (found, expected) = if is_last {
                ("a rule", "no rule: the last layer takes what the others leave")
            } else {
                ("no rule, so that none shows beneath it", "a rule (`slope`, `height` or `field`), or the last place")
            };
            return Err(Error::parameter("layers", format!("\"{}\" with {found}", self.name), expected));
        }
        if self.range.is_some() && self.field.is_none() {
            return Err(Error::Incomplete { name: "range".into(), needs: "field" });
        }
        self.slope.map_or(Ok(()), |span| span.check("layers.slope"))?;
        self.height.map_or(Ok(()), |span| span.check("layers.height"))?;
        self.ends().map(drop)
    }

    /// Values of the field at which it begins and is whole, in the field's unit.
    fn ends(&self) -> Result<[f64; 2]> {
        let unit = self.field.as_deref().and_then(names::unit_of).unwrap_or("1");
        let value = |bound: &Bound| match bound {
            Bound::Number(v) => Ok(*v),
            Bound::Text(text) => parse_as(text, unit),
        };
        let ends = match &self.range {
            Some([from, to]) => [value(from)?, value(to)?],
            None => [0.0, 1.0],
        };
        if ends.iter().all(|v| v.is_finite()) && ends[0] != ends[1] {
            return Ok(ends);
        }
        Err(Error::parameter("range", format!("{ends:?}"), "two different values"))
    }
}

/// A field that a layer follows, and the values at which it begins and is whole.
type Followed = (Vec<f64>, [f64; 2]);

/// The layers over a raster.
pub(super) struct Painted<'a> {
    layers: &'a [WeightLayer],
    z: &'a [f64],
    /// Angle of the slope, rad.
    slope: Vec<f64>,
    fields: Vec<Option<Followed>>,
    slope_softness: f64,
    height_softness: f64,
}

impl<'a> Painted<'a> {
    pub(super) fn of(params: &'a WriteWeights, ground: &'a HeightField) -> Result<Self> {
        let z = ground.elevation();
        let steep = slope(ground.grid(), z);
        let fields = params.layers.iter().map(|layer| match &layer.field {
            Some(name) => Ok(Some((ground.real(name, "`write_weights`")?, layer.ends()?))),
            None => Ok(None),
        });
        let of = |i: usize, sign: f64| if z[i].is_nan() { f64::NEG_INFINITY } else { sign * z[i] };
        let relief = parallel::max(z.len(), |i| of(i, 1.0)) + parallel::max(z.len(), |i| of(i, -1.0));
        Ok(Self {
            layers: &params.layers,
            z,
            slope: parallel::map(z.len(), |i| math::atan(steep[i])),
            fields: fields.collect::<Result<_>>()?,
            slope_softness: params.slope_softness.si(),
            height_softness: params.height_softness.map_or(0.05 * relief.max(0.0), Length::si),
        })
    }

    /// The share of each layer in a node, which sum to 1. Nodata has the last.
    pub(super) fn shares(&self, i: usize) -> Vec<f64> {
        let mut left = 1.0;
        let share = |k: usize, layer: &WeightLayer| {
            let by_slope = layer.slope.map_or(1.0, |span| span.share(self.slope[i], self.slope_softness));
            let by_height = layer.height.map_or(1.0, |span| span.share(self.z[i], self.height_softness));
            let by_field = self.fields[k].as_ref().map_or(1.0, |(values, [from, to])| {
                let t = (values[i] - from) / (to - from);
                if t.is_nan() { 0.0 } else { math::smoothstep(0.0, 1.0, t) }
            });
            by_slope * by_height * by_field
        };
        let last = self.layers.len() - 1;
        let shares = self.layers.iter().enumerate().map(|(k, layer)| {
            let part = match k == last {
                true => 1.0,
                false if self.z[i].is_nan() || self.slope[i].is_nan() => 0.0,
                false => share(k, layer),
            };
            let own = left * part;
            left -= own;
            own
        });
        shares.collect()
    }
}

/// Parts of 255 for shares that sum to 1: what is whole of each, and one more for the largest
/// remainders until the sum is 255.
pub(super) fn share_out(shares: &[f64]) -> Vec<u8> {
    let exact: Vec<f64> = shares.iter().map(|s| (255.0 * s).clamp(0.0, 255.0)).collect();
    let mut whole: Vec<u8> = exact.iter().map(|e| e.floor() as u8).collect();
    let missing = 255 - whole.iter().map(|&w| i32::from(w)).sum::<i32>();
    let mut order: Vec<usize> = (0..shares.len()).collect();
    // Stable: of equal remainders the layer named first comes first.
    order.sort_by(|&a, &b| (exact[b] - exact[b].floor()).total_cmp(&(exact[a] - exact[a].floor())));
    for k in 0..missing.max(0) as usize {
        let layer = order[k % order.len()];
        whole[layer] = whole[layer].saturating_add(1);
    }
    for _ in missing..0 {
        // Only by rounding: the heaviest gives.
        if let Some(heaviest) = whole.iter_mut().max() {
            *heaviest -= 1;
        }
    }
    whole
}
