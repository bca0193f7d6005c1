//! Ranges with one end or two, as rules for what grows or lies where.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::{Angle, Dimension, Length, Quantity};
use crate::{Error, Result, math};

macro_rules! span {
    ($(#[$doc:meta])* $name:ident, $quantity:ty, $what:literal) => {
        $(#[$doc])*
        ///
        /// ```
        /// use landform_core::units::{Angle, Length};
        /// use landform_core::verb::{LengthSpan, SlopeSpan};
        ///
        /// let low = LengthSpan { above: None, below: Some(Length::of(500.0)) };
        /// assert_eq!([100.0, 500.0, 501.0].map(|v| low.share(v, 0.0)), [1.0, 1.0, 0.0]);
        /// let steep = SlopeSpan { above: Some(Angle::of(35.0)), below: None };
        /// let soft = Angle::of(10.0).si();
        /// assert_eq!([20.0, 35.0, 40.0].map(|v| steep.share(Angle::of(v).si(), soft)), [0.0, 0.5, 1.0]);
        /// ```
        #[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
        #[serde(default, deny_unknown_fields)]
        pub struct $name {
            #[doc = concat!("Least ", $what, ".")]
            pub above: Option<$quantity>,
            #[doc = concat!("Greatest ", $what, ".")]
            pub below: Option<$quantity>,
        }

        impl $name {
            /// How much a value (SI) lies within, as a part from 0 to 1: one half at an end, and
            /// all of it half of `soft` (SI) away. With `soft` 0 ends are sharp and belong to the
            /// range.
            ///
            /// ```
            /// use landform_core::verb::LengthSpan;
            ///
            /// assert_eq!(LengthSpan::default().share(7.0, 0.0), 1.0);
            /// ```
            pub fn share(&self, value: f64, soft: f64) -> f64 {
                share([self.above, self.below], value, soft)
            }

            /// Refuses a range without room.
            ///
            /// ```
            /// use landform_core::units::Length;
            /// use landform_core::verb::LengthSpan;
            ///
            /// let none = LengthSpan { above: Some(Length::of(9.0)), below: Some(Length::of(3.0)) };
            /// assert!(none.check("height").is_err());
            /// ```
            ///
            /// # Errors
            /// [`Error::Parameter`] if nothing lies above the one and below the other.
            pub fn check(&self, name: &str) -> Result<()> {
                check(name, [self.above, self.below])
            }
        }
    };
}

span!(
    /// Slopes above an angle, below one, or between two.
    SlopeSpan,
    Angle,
    "angle"
);
span!(
    /// Heights or distances above one, below one, or between two.
    LengthSpan,
    Length,
    "height or distance"
);

fn share<D: Dimension>([above, below]: [Option<Quantity<D>>; 2], value: f64, soft: f64) -> f64 {
    let rises = |end: f64| match soft > 0.0 {
        true => math::smoothstep(end - 0.5 * soft, end + 0.5 * soft, value),
        false => f64::from(u8::from(value >= end)),
    };
    let falls = |end: f64| match soft > 0.0 {
        true => 1.0 - math::smoothstep(end - 0.5 * soft, end + 0.5 * soft, value),
        false => f64::from(u8::from(value <= end)),
    };
    above.map_or(1.0, |end| rises(end.si())) * below.map_or(1.0, |end| falls(end.si()))
}

fn check<D: Dimension>(name: &str, ends: [Option<Quantity<D>>; 2]) -> Result<()> {
    match ends {
        [Some(above), Some(below)] if !(above.si() < below.si()) => {
            let expected = "`above` less than `below`: what lies between them is meant";
            Err(Error::parameter(name, format!("{{ above = \"{above}\", below = \"{below}\" }}"), expected))
        }
        _ => Ok(()),
    }
}
