//! As much of XML as the notes of GDAL need.

/// The attributes and the text of the first element of this name.
pub(super) fn element<'a>(text: &'a str, name: &str) -> Option<(&'a str, &'a str)> {
    elements(text, name).next()
}

/// The attributes and the text of every element of this name that lies in no other of it.
pub(super) fn elements<'a>(text: &'a str, name: &str) -> impl Iterator<Item = (&'a str, &'a str)> {
    let (open, close) = (format!("<{name}"), format!("</{name}>"));
    let mut rest = text;
    std::iter::from_fn(move || {
        loop {
            let (_, after) = rest.split_once(open.as_str())?;
            rest = after;
            // Not the beginning of a longer name.
            if !after.starts_with([' ', '>', '/', '\t', '\n', '\r']) {
                continue;
            }
            let (attributes, body) = after.split_once('>')?;
            if let Some(attributes) = attributes.strip_suffix('/') {
                rest = body;
                return Some((attributes, ""));
            }
            let (inner, after) = body.split_once(close.as_str())?;
            rest = after;
            return Some((attributes, inner));
        }
    })
}

/// The value of an attribute.
pub(super) fn attribute<'a>(attributes: &'a str, name: &str) -> Option<&'a str> {
    let (_, value) = attributes.split_once(&format!("{name}="))?;
    let quote = value.chars().next().filter(|c| ['"', '\''].contains(c))?;
    value.get(1..)?.split(quote).next()
}

/// Text with its marks as they are meant.
pub(super) fn plain(text: &str) -> String {
    let marks = [("&quot;", "\""), ("&apos;", "'"), ("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")];
    marks.iter().fold(text.trim().to_string(), |text, (mark, meant)| text.replace(mark, meant))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_and_attributes_are_found() {
        let text = r#"<A><Items n="x">no</Items><Item n="1" m='2'>a &amp; b</Item><Item/><Item>c</Item>"#;
        let found: Vec<_> = elements(text, "Item").collect();
        assert_eq!(found.len(), 3);
        assert_eq!((attribute(found[0].0, "n"), attribute(found[0].0, "m")), (Some("1"), Some("2")));
        assert_eq!((plain(found[0].1), found[2].1), ("a & b".into(), "c"));
        for text in ["", "<Item", "<Item>", "<Item n=", "<Item n=\">", "</Item>"] {
            assert!(element(text, "Item").is_none(), "{text}");
        }
        assert_eq!(attribute("n=é", "n"), None);
    }
}
