//! Measures of a cave as text.

use serde_json::Value as Json;

/// A cave's measures as a cell of the page; none if it is no cave.
pub(super) fn numbers(m: &Json) -> Option<String> {
    m["optimised"].as_object()?;
    let v = |path: &str| m.pointer(path).and_then(Json::as_f64).unwrap_or(f64::NAN);
    let outside = |source: &str, name: &str| {
        let classes = m["classes"].as_array().into_iter().flatten();
        let confined =
            classes.filter(|c| c["name"] == "confined" && c["source"].as_str().is_some_and(|s| s.starts_with(source)));
        let listed = confined.flat_map(|c| c["outside"].as_array().into_iter().flatten()).any(|o| o == name);
        if listed { "*" } else { "" }
    };
    let both = |name: &str, digits: usize| {
        let [near, all] = ["optimised", "rectangular"].map(|field| v(&format!("/{field}/{name}")));
        format!("{near:.digits$}{} ({all:.digits$}{})", outside("Klimchouk", name), outside("Frumkin", name))
    };
    let whole =
        |name: &str| format!("{:.2}{}{}", v(&format!("/{name}")), outside("Klimchouk", name), outside("Frumkin", name));
    Some(format!(
        "density {} m/m²<br>coverage {} %<br>porosity {} %<br>L:W {}, W {} m<br>length {:.0} m, depth {:.0} m, {:.0} m³<br>{} of {} inlets broke through, {} of them into another's passage<br>largest ball {:.1} m in radius; {:.0} % of floors are walked",
        both("density_m_m2", 3),
        both("coverage_percent", 1),
        both("porosity_percent", 2),
        whole("length_to_width"),
        whole("width_m"),
        v("/length_m"),
        v("/depth_range_m"),
        v("/volume_m3"),
        m["breakthroughs"],
        m["inlets"].as_array().map_or(0, Vec::len),
        m["captures"],
        v("/largest_chamber/radius_m"),
        v("/walkable_percent"),
    ))
}
