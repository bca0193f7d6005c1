//! Features that are found again keep their ids.

use std::collections::{BTreeMap, BTreeSet};

use super::{Feature, Features, Property};

/// Part of a feature that must lie where the older one lay.
const LEAST_SHARE: f64 = 0.3;

type Cell = (i64, i64);

impl Features {
    /// Gives each feature the id of the older one of its kind that it shares most of its course
    /// with (at least three tenths of it, within a few of its own steps); the rest get ids that no
    /// feature had. References to ids are updated.
    pub fn keep_ids(&mut self, before: &Features) {
        if before.is_empty() {
            return;
        }
        let step = typical_step(self.0.iter().chain(&before.0));
        let older: Vec<BTreeSet<Cell>> = before.0.iter().map(|f| cells(f, step)).collect();
        let mut by_cell: BTreeMap<Cell, Vec<usize>> = BTreeMap::new();
        for (k, cells) in older.iter().enumerate() {
            cells.iter().for_each(|c| by_cell.entry(*c).or_default().push(k));
        }
        let mut pairs = Vec::new();
        for (new, feature) in self.0.iter().enumerate() {
            let own = cells(feature, step);
            let mut shared: BTreeMap<usize, usize> = BTreeMap::new();
            for k in own.iter().filter_map(|c| by_cell.get(c)).flatten() {
                *shared.entry(*k).or_default() += 1;
            }
            let same = shared.into_iter().filter(|(k, _)| before.0[*k].kind == feature.kind);
            pairs.extend(same.map(|(old, n)| (n as f64 / own.len().max(1) as f64, new, old)));
        }
        // The best matches first; of equals the earlier feature.
        pairs.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
        let (mut given, mut taken) = (BTreeMap::new(), BTreeSet::new());
        for (share, new, old) in pairs {
            if share >= LEAST_SHARE && !given.contains_key(&new) && taken.insert(old) {
                given.insert(new, before.0[old].id.clone());
            }
        }
        self.rename(&given, before);
    }

    fn rename(&mut self, given: &BTreeMap<usize, String>, before: &Features) {
        let mut used: BTreeSet<(super::FeatureKind, String)> =
            before.0.iter().map(|f| (f.kind, f.id.clone())).collect();
        let mut renamed = BTreeMap::new();
        for (k, feature) in self.0.iter_mut().enumerate() {
            let new = given.get(&k).cloned().unwrap_or_else(|| {
                let fresh = (1..).map(|n: u32| if n == 1 { feature.id.clone() } else { format!("{}-{n}", feature.id) });
                fresh.into_iter().find(|id| !used.contains(&(feature.kind, id.clone()))).unwrap_or_default()
            });
            used.insert((feature.kind, new.clone()));
            renamed.insert((feature.kind, std::mem::replace(&mut feature.id, new.clone())), new);
        }
        for feature in &mut self.0 {
            let kind = feature.kind;
            for (_, property) in &mut feature.properties {
                if let Property::Id(id) = property
                    && let Some(new) = renamed.get(&(kind, id.clone()))
                {
                    *id = new.clone();
                }
            }
        }
    }
}

/// Four times the median distance between neighbouring places.
fn typical_step<'a>(features: impl Iterator<Item = &'a Feature>) -> f64 {
    let mut steps: Vec<f64> = features
        .filter(|f| !matches!(f.geometry, super::Geometry::Points(_)))
        .flat_map(|f| f.places().windows(2).map(|w| length(w[0], w[1])).collect::<Vec<_>>())
        .filter(|d| *d > 0.0)
        .collect();
    steps.sort_by(f64::total_cmp);
    4.0 * steps.get(steps.len() / 2).copied().unwrap_or(1.0)
}

fn length(a: [f64; 2], b: [f64; 2]) -> f64 {
    ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt()
}

/// The cells of a lattice that a feature's places lie in or beside.
fn cells(feature: &Feature, step: f64) -> BTreeSet<Cell> {
    let cell = |p: [f64; 2]| ((p[0] / step).floor() as i64, (p[1] / step).floor() as i64);
    feature.places().into_iter().map(cell).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{FeatureKind, Geometry};
    use super::*;

    fn river(id: &str, shift: f64, to: Option<&str>) -> Feature {
        let line = (0..60).map(|k| [f64::from(k) * 10.0 + shift, 500.0 - f64::from(k), 0.0]).collect();
        let to = to.map_or(Property::None, |t| Property::Id(t.into()));
        let properties = vec![("flows_to".to_string(), to)];
        Feature { id: id.into(), kind: FeatureKind::River, geometry: Geometry::Line(line), properties }
    }

    #[test]
    fn a_river_that_moves_keeps_its_id_and_a_new_one_gets_another() {
        let before: Features = [river("1", 0.0, None), river("2", 3_000.0, Some("1"))].into_iter().collect();
        // Found in the other order, a little elsewhere, with a third one far away.
        let mut after: Features =
            [river("1", 3_015.0, Some("2")), river("2", -12.0, None), river("3", 9_000.0, Some("2"))]
                .into_iter()
                .collect();
        after.keep_ids(&before);
        let ids: Vec<&str> = after.iter().map(|f| f.id.as_str()).collect();
        assert_eq!(ids, ["2", "1", "3"]);
        assert_eq!(after.0[0].properties[0].1, Property::Id("1".into()));
        let mut whole = before.clone();
        whole.update(after.clone());
        assert_eq!(whole, after);
    }
}
