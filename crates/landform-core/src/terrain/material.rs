//! Materials of the ground.

use std::collections::BTreeMap;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::nearest;
use crate::units::{Angle, Erodibility, Ratio};
use crate::{Error, Result};

/// A material, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Material {
    /// Name in recipes.
    pub name: String,
    /// Erodibility of the stream-power law, m^(1-2m)/s.
    pub erodibility: f64,
    /// Angle of repose, rad: the steepest slope that stands.
    pub repose: f64,
    /// Slope at which hillslope transport becomes unlimited, rise over run.
    pub limiting_slope: f64,
    /// How readily water dissolves it, 0 (not at all) to 1 (as pure limestone).
    pub solubility: f64,
    /// Density of the bulk, kg/m³.
    pub density: f64,
}

/// Changes to a material of the table, or a new one, which has the values of `rock` where none are
/// given.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MaterialParams {
    /// Erodibility of the stream-power law (lengths in metres), as `stream_power` takes it.
    #[schemars(extend("x-min" = 0.0))]
    pub erodibility: Option<Erodibility>,
    /// Angle of repose: the steepest slope that stands.
    #[schemars(extend("x-above" = 0.0, "x-max" = 89.0))]
    pub repose: Option<Angle>,
    /// Slope at which hillslope transport becomes unlimited, rise over run.
    #[schemars(extend("x-above" = 0.0, "x-max" = 100.0))]
    pub limiting_slope: Option<f64>,
    /// How readily water dissolves it: 0 not at all, 1 as pure limestone.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub solubility: Option<Ratio>,
    /// Density of the bulk, kg/m³.
    #[schemars(extend("x-above" = 0.0, "x-max" = 30_000.0))]
    pub density: Option<f64>,
}

/// A table of materials: the ones that come with landform, and a recipe's own.
///
/// ```
/// use landform_core::terrain::Materials;
///
/// let materials = Materials::default();
/// let sand = materials.get(materials.need("sand", "material")?);
/// assert!((sand.repose.to_degrees() - 33.0).abs() < 1e-9);
/// let error = materials.need("sandstne", "material").unwrap_err();
/// assert!(error.to_string().contains("\"sandstone\"?"));
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Materials(Arc<Vec<Material>>);

/// Name, erodibility (1/yr at m = 0.5), repose (deg), limiting slope, solubility, density. Loose
/// ones lie on each other in this order, the last uppermost.
///
/// Erodibilities are our own choice. Their spread follows Stock & Montgomery (1999), whose values
/// run over five orders of magnitude from granite to mudstone; `rock` is the default of
/// `stream_power`. Angles of repose: Selby (1993), table of strengths, rounded.
const TABLE: &[(&str, f64, f64, f64, f64, f64)] = &[
    ("rock", 2e-6, 60.0, 1.2, 0.0, 2700.0),
    ("granite", 5e-7, 70.0, 1.7, 0.0, 2700.0),
    ("basalt", 8e-7, 70.0, 1.7, 0.0, 2900.0),
    ("limestone", 1.5e-6, 65.0, 1.5, 1.0, 2600.0),
    ("sandstone", 1e-6, 60.0, 1.5, 0.0, 2400.0),
    ("shale", 8e-6, 30.0, 0.6, 0.0, 2400.0),
    ("coral", 2e-6, 50.0, 1.2, 1.0, 1500.0),
    ("clay", 2e-5, 25.0, 0.5, 0.0, 1900.0),
    ("gravel", 1e-5, 36.0, 0.75, 0.0, 1800.0),
    ("sediment", 2e-5, 32.0, 0.6, 0.0, 1700.0),
    ("soil", 2e-5, 32.0, 0.6, 0.0, 1500.0),
    ("sand", 4e-5, 33.0, 0.65, 0.0, 1600.0),
    ("snow", 1e-4, 45.0, 1.0, 0.0, 300.0),
];

impl Default for Materials {
    fn default() -> Self {
        let all = TABLE.iter().map(|&(name, erodibility, repose, limiting_slope, solubility, density)| Material {
            name: name.into(),
            erodibility: Erodibility::of(erodibility).si(),
            repose: Angle::of(repose).si(),
            limiting_slope,
            solubility,
            density,
        });
        Self(Arc::new(all.collect()))
    }
}

impl Materials {
    /// The table with a recipe's changes and additions. New materials follow the others in the
    /// order of their names.
    ///
    /// # Errors
    /// [`Error::Parameter`] for more than 255 materials.
    pub fn with(changes: &BTreeMap<String, MaterialParams>) -> Result<Self> {
        let mut all = (*Self::default().0).clone();
        for (name, change) in changes {
            let at = all.iter().position(|m| m.name == *name).unwrap_or_else(|| {
                all.push(Material { name: name.clone(), ..all[0].clone() });
                all.len() - 1
            });
            let m = &mut all[at];
            m.erodibility = change.erodibility.map_or(m.erodibility, Erodibility::si);
            m.repose = change.repose.map_or(m.repose, Angle::si);
            m.limiting_slope = change.limiting_slope.unwrap_or(m.limiting_slope);
            m.solubility = change.solubility.map_or(m.solubility, Ratio::si);
            m.density = change.density.unwrap_or(m.density);
        }
        if all.len() > usize::from(u8::MAX) {
            return Err(Error::parameter("materials", all.len(), "at most 255 with the built-in ones"));
        }
        Ok(Self(Arc::new(all)))
    }

    /// The table with more materials after the others.
    ///
    /// ```
    /// use landform_core::terrain::Materials;
    ///
    /// let materials = Materials::default();
    /// let ash = materials.get(materials.need("basalt", "material")?).clone();
    /// assert_eq!(materials.and(vec![ash])?.all().len(), materials.all().len() + 1);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Parameter`] for more than 255 materials.
    pub fn and(&self, more: Vec<Material>) -> Result<Self> {
        let mut all = (*self.0).clone();
        all.extend(more);
        if all.len() > usize::from(u8::MAX) {
            return Err(Error::parameter("materials", all.len(), "at most 255 with the built-in ones"));
        }
        Ok(Self(Arc::new(all)))
    }

    /// All, in order; a material's place is its number in the field `surface_material`.
    pub fn all(&self) -> &[Material] {
        &self.0
    }

    /// The number of a material.
    pub fn find(&self, name: &str) -> Option<u8> {
        self.0.iter().position(|m| m.name == name).map(|k| k as u8)
    }

    /// The number of a material that a parameter names.
    ///
    /// # Errors
    /// [`Error::Parameter`] with the nearest name if there is no such material.
    pub fn need(&self, name: &str, parameter: &str) -> Result<u8> {
        self.find(name).ok_or_else(|| {
            let names = || self.0.iter().map(|m| m.name.as_str());
            let near = nearest(name, names()).map(|n| format!("\"{n}\"? or ")).unwrap_or_default();
            let all = names().collect::<Vec<_>>().join(", ");
            Error::parameter(
                parameter,
                format!("\"{name}\""),
                &format!("{near}one of {all}, or an entry in [materials]"),
            )
        })
    }

    /// A material by its number.
    #[inline]
    pub fn get(&self, number: u8) -> &Material {
        &self.0[usize::from(number)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_recipe_changes_and_adds_materials() {
        let changes: BTreeMap<String, MaterialParams> = serde_json::from_str(
            r#"{"shale":{"repose":"25 deg"},"chalk":{"erodibility":"5e-6 1/yr","solubility":0.9}}"#,
        )
        .unwrap();
        let all = Materials::with(&changes).unwrap();
        let of = |name: &str| all.get(all.find(name).unwrap());
        assert!((of("shale").repose.to_degrees() - 25.0).abs() < 1e-12);
        assert_eq!(of("shale").erodibility, Erodibility::of(8e-6).si());
        assert_eq!((of("chalk").solubility, of("chalk").density), (0.9, 2700.0));
        assert!(all.need("sandstne", "beds").unwrap_err().to_string().contains("\"sandstone\"?"));
    }
}
