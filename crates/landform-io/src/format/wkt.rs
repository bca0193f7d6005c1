//! Coordinate reference systems in well-known text, as far as codes and units go.
//!
//! # Sources
//! OGC 01-009 (WKT 1) and 18-010 (WKT 2), and how Esri writes the first.

use super::system::System;
use super::systems::length_by_name;

const MOST_BYTES: usize = 1 << 16;
const MOST_DEPTH: usize = 24;

/// A word with what stands in its brackets.
#[derive(Debug, Default)]
struct Node {
    word: String,
    values: Vec<String>,
    children: Vec<Node>,
}

/// The system that a text describes; none if it is no such text.
pub(super) fn system(text: &str) -> Option<System> {
    if text.len() > MOST_BYTES {
        return None;
    }
    let node = Parser { rest: text.trim_start_matches('\u{feff}') }.node(0)?;
    node.system()
}

struct Parser<'a> {
    rest: &'a str,
}

impl Parser<'_> {
    fn node(&mut self, depth: usize) -> Option<Node> {
        let word = self.word();
        self.next_if(&['[', '('])?;
        let mut node = Node { word: word.to_uppercase(), ..Node::default() };
        if node.word.is_empty() || depth > MOST_DEPTH {
            return None;
        }
        loop {
            self.rest = self.rest.trim_start();
            if self.rest.starts_with('"') {
                let (text, rest) = self.rest.get(1..)?.split_once('"')?;
                node.values.push(text.into());
                self.rest = rest;
            } else if self.begins_node() {
                node.children.push(self.node(depth + 1)?);
            } else {
                let value = self.word();
                node.values.push(value);
            }
            match self.next_if(&[',', ']', ')'])? {
                ',' => {}
                _ => return Some(node),
            }
        }
    }

    fn word(&mut self) -> String {
        self.rest = self.rest.trim_start();
        let end = self.rest.find(|c: char| "[](),\"".contains(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word.trim().into()
    }

    fn begins_node(&self) -> bool {
        let end = self.rest.find(|c: char| "[](),\"".contains(c));
        end.is_some_and(|e| e > 0 && self.rest[e..].starts_with(['[', '(']))
    }

    fn next_if(&mut self, wanted: &[char]) -> Option<char> {
        self.rest = self.rest.trim_start();
        let next = self.rest.chars().next().filter(|c| wanted.contains(c))?;
        self.rest = &self.rest[next.len_utf8()..];
        Some(next)
    }
}

impl Node {
    fn is(&self, words: &[&str]) -> bool {
        words.contains(&self.word.as_str())
    }

    fn child(&self, words: &[&str]) -> Option<&Self> {
        self.children.iter().find(|c| c.is(words))
    }

    fn system(&self) -> Option<System> {
        const VERTICAL: &[&str] = &["VERT_CS", "VERTCS", "VERTCRS", "VERTICALCRS"];
        if self.is(&["COMPD_CS", "COMPOUNDCRS"]) {
            let mut system = self.children.iter().find(|c| !c.is(VERTICAL))?.system()?;
            let vertical = self.child(VERTICAL);
            system.height_unit = vertical.and_then(Self::unit);
            system.vertical = vertical.and_then(Self::epsg);
            return Some(system);
        }
        if self.is(&["BOUNDCRS"]) {
            return self.child(&["SOURCECRS"])?.children.first()?.system();
        }
        let geographic = self.is(&["GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS", "BASEGEOGCRS"]);
        let projected = self.is(&["PROJCS", "PROJCRS", "PROJECTEDCRS", "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"]);
        (geographic || projected).then(|| System {
            epsg: self.epsg().or_else(|| by_name(self.values.first()?)),
            geographic,
            unit: self.unit(),
            name: self.values.first().cloned(),
            ..System::default()
        })
    }

    fn epsg(&self) -> Option<u16> {
        let id = self.child(&["AUTHORITY", "ID"])?;
        id.values.first().filter(|a| a.eq_ignore_ascii_case("EPSG"))?;
        id.values.get(1)?.parse().ok()
    }

    /// Metres, or degrees, in the unit of its coordinates.
    fn unit(&self) -> Option<f64> {
        const UNITS: &[&str] = &["UNIT", "LENGTHUNIT", "ANGLEUNIT"];
        let axis = || self.child(&["AXIS"])?.child(UNITS);
        let unit = self.child(UNITS).or_else(axis)?;
        let size = unit.values.get(1)?.parse::<f64>().ok().filter(|v| v.is_finite() && *v > 0.0)?;
        let is_angle = self.word.starts_with("GEO") || self.word.starts_with("BASEGEO");
        let by_name = unit.values.first().and_then(|n| length_by_name(n));
        Some(if is_angle { size.to_degrees() } else { by_name.unwrap_or(size) })
    }
}

/// Codes of systems that Esri writes without one.
fn by_name(name: &str) -> Option<u16> {
    let plain = name.replace(['_', '/'], " ").to_uppercase();
    let words: Vec<&str> = plain.split_whitespace().collect();
    let zone = |text: &str| {
        let (number, side) = text.split_at_checked(text.len().checked_sub(1)?)?;
        let zone: u16 = number.parse().ok().filter(|z| (1..=60).contains(z))?;
        match side {
            "N" => Some(32_600 + zone),
            "S" => Some(32_700 + zone),
            _ => None,
        }
    };
    match words.as_slice() {
        ["GCS", "WGS", "1984"] | ["WGS", "84"] => Some(4326),
        ["GCS", "NORTH", "AMERICAN", "1983"] => Some(4269),
        ["WGS", "1984" | "84", "UTM", "ZONE", text] => zone(text),
        ["WGS", "1984", "WEB", "MERCATOR", ..] => Some(3857),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_and_units_are_found_in_every_dialect() {
        let utm = r#"PROJCS["WGS 84 / UTM zone 11N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.25]],
            PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4326"]],PROJECTION["Transverse_Mercator"],
            PARAMETER["central_meridian",-117],UNIT["metre",1],AXIS["Easting",EAST],AUTHORITY["EPSG","32611"]]"#;
        let found = system(utm).unwrap();
        assert_eq!((found.epsg, found.geographic, found.unit), (Some(32_611), false, Some(1.0)));
        let esri = r#"PROJCS["NAD_1983_StatePlane_California_V_FIPS_0405_Feet",GEOGCS["GCS_North_American_1983",
            UNIT["Degree",0.0174532925199433]],UNIT["Foot_US",0.3048006096012192]]"#;
        let found = system(esri).unwrap();
        assert!(found.epsg.is_none() && (found.unit.unwrap() - 0.304_800_609_6).abs() < 1e-9);
        let esri = r#"PROJCS["WGS_1984_UTM_Zone_33S",GEOGCS["GCS_WGS_1984"],UNIT["Meter",1.0]]"#;
        assert_eq!(system(esri).unwrap().epsg, Some(32_733));
        let second = r#"GEOGCRS["WGS 84",DATUM["World Geodetic System 1984"],CS[ellipsoidal,2],
            AXIS["geodetic latitude (Lat)",north,ORDER[1],ANGLEUNIT["degree",0.0174532925199433]],ID["EPSG",4326]]"#;
        let found = system(second).unwrap();
        assert!(found.geographic && found.epsg == Some(4326) && (found.unit.unwrap() - 1.0).abs() < 1e-9);
        let compound =
            format!(r#"COMPD_CS["x",{utm},VERT_CS["NAVD88 height (ftUS)",UNIT["US survey foot",0.3048006096012192]]]"#);
        let found = system(&compound).unwrap();
        assert!(found.epsg == Some(32_611) && (found.height_unit.unwrap() - 0.304_800_609_6).abs() < 1e-9);
    }

    #[test]
    fn what_is_no_such_text_gives_nothing() {
        for text in
            ["", "[", "PROJCS", "PROJCS[", "PROJCS[\"a", "EPSG:4326", "]]", "A[B[C[", &"A[".repeat(5000), "PROJCS[é\"ü"]
        {
            assert!(system(text).is_none(), "{text}");
        }
    }
}
