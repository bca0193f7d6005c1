//! What GDAL notes about bands, in a tag of XML.

use crate::format::said::Said;
use crate::format::xml::{attribute, elements, plain};

/// Scale, offset and unit of the first band.
pub(super) fn of_first_band(text: &str) -> Said {
    let item = |role: &str| {
        let mut items = elements(text, "Item").filter(|(a, _)| attribute(a, "role") == Some(role));
        items.find(|(a, _)| attribute(a, "sample").is_none_or(|s| s == "0")).map(|(_, text)| plain(text))
    };
    let number = |role: &str| item(role)?.parse().ok().filter(|v: &f64| v.is_finite());
    Said { scale: number("scale"), offset: number("offset"), unit: item("unittype"), ..Said::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_items_of_other_bands_are_theirs() {
        let text = r#"<GDALMetadata>
            <Item name="SCALE" sample="1" role="scale">0.001</Item><Item name="OFFSET" sample="1" role="offset">5</Item>
            <Item name="UNITTYPE" sample="0" role="unittype">ft</Item><Item name="SCALE" sample="0" role="scale">2</Item>
            </GDALMetadata>"#;
        let found = of_first_band(text);
        assert_eq!((found.scale, found.offset, found.unit.as_deref()), (Some(2.0), None, Some("ft")));
        assert_eq!(of_first_band(r#"<Item role="scale">NaN</Item>"#), Said::default());
    }
}
