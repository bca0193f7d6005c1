//! Erodibility and stable slope of rock and loose layers.

use landform_core::algo::flow::Flow;
use landform_core::grid::Domain;
use landform_core::terrain::Layers;
use landform_core::verb::Resolved;

use super::law::Law;

/// Erodibility and steepest slope of every node.
#[derive(Clone, Copy)]
pub(super) struct Rock<'a> {
    /// Erodibility of the parameter, m^(1-2m)/s; on layered ground that of rock, if it is given.
    pub(super) erodibility: &'a Resolved,
    /// What the ground is made of.
    pub(super) layers: Option<&'a Layers>,
    /// How many times as fast rock of its material's own erodibility wears at each node; none for
    /// once.
    pub(super) weakness: Option<&'a Resolved>,
    /// Whether rock has its own material's erodibility rather than the parameter's.
    pub(super) by_material: bool,
}

impl Rock<'_> {
    /// Erodibility of a material at a node, m^(1-2m)/s.
    fn of(&self, node: usize, number: u8, layers: &Layers, is_loose: bool) -> f64 {
        let of_material = layers.materials().get(number).erodibility;
        match is_loose {
            true => of_material,
            false if self.by_material => of_material * self.weakness.map_or(1.0, |weakness| weakness.at(node)),
            false => self.erodibility.at(node),
        }
    }

    /// Erodibility at the surface of a node at `z`.
    pub(super) fn erodibility(&self, node: usize, z: f64) -> f64 {
        match self.layers {
            None => self.erodibility.at(node),
            Some(layers) => {
                let number = layers.surface_number(node, z);
                let is_loose = layers.loose().any(|l| l == layers.materials().get(number).name);
                self.of(node, number, layers, is_loose)
            }
        }
    }

    /// The slope that ground of a material, or without layers, approaches and does not exceed.
    #[inline]
    fn limit_of(&self, law: &Law, number: impl FnOnce(&Layers) -> u8) -> f64 {
        match self.layers {
            Some(layers) if law.limits_by_material => layers.materials().get(number(layers)).limiting_slope,
            _ => law.limiting_slope,
        }
    }

    /// That slope at the surface of a node at `z`.
    #[inline]
    pub(super) fn limiting_slope(&self, law: &Law, node: usize, z: f64) -> f64 {
        self.limit_of(law, |layers| layers.surface_number(node, z))
    }

    /// Whether ground anywhere can stand no steeper than an angle.
    pub(super) fn may_slide(&self, law: &Law) -> bool {
        law.greatest_slope.is_finite() || self.layers.is_some() && !law.has_limit()
    }

    /// The drop over `length` that ground at `z` can stand above `base`.
    #[inline]
    pub(super) fn stable_drop(&self, law: &Law, node: usize, z: f64, base: f64, length: f64) -> f64 {
        match self.layers {
            Some(layers) if !law.greatest_slope.is_finite() && !law.has_limit() => {
                layers.stable_height(node, z, base, length) - base
            }
            _ => law.greatest_slope * length,
        }
    }

    /// The drop over `base` that erosion leaves in the step, through strata of different
    /// erodibility.
    ///
    /// The implicit step asks for the elevation at which ∫ dz/K from there up to the old surface
    /// equals Δt (Aᵐ Sⁿ − threshold), with S the slope at the end; with one K it is the plain one.
    /// Strata above the end only add to the left-hand side.
    fn worn(&self, law: &Law, layers: &Layers, node: usize, z: f64, base: f64, (area, length): (f64, f64)) -> f64 {
        // ∫ dz/K over the strata passed, and the time that the threshold spares, s.
        let (mut top, mut passed) = (z, law.threshold * law.dt);
        for stratum in layers.column(node, z) {
            let is_loose = layers.loose().any(|l| l == stratum.material.name);
            let erodibility = self.of(node, stratum.number, layers, is_loose);
            let strength = law.strength(erodibility, area, length);
            if strength == 0.0 {
                return top - base;
            }
            let most = self.limit_of(law, |_| stratum.number) * length;
            let drop = law.worn(top - base + passed * erodibility, strength, most).min(top - base);
            if base + drop >= stratum.bottom {
                return drop;
            }
            passed += (top - stratum.bottom) / erodibility;
            top = stratum.bottom;
        }
        top - base
    }
}

/// As [`super::braun_willett_2013::sweep`], through layers.
pub(super) fn sweep_layers<D: Domain>(
    domain: &D,
    flow: &Flow,
    law: &Law,
    rock: &Rock,
    layers: &Layers,
    area: &mut [f64],
    z: &mut [f64],
) {
    let slots = flow.slots();
    flow.up_with(z, area, |i, old, below, area| {
        let base = below.max(law.sea_level);
        let through = std::mem::take(area);
        if !(old > base) {
            return old;
        }
        let length = domain.distance(i, slots[i]);
        let worn = rock.worn(law, layers, i, old, base, (through, length));
        let new = base + law.standing(worn, rock.stable_drop(law, i, old, base, length), length).0;
        *area = old - new;
        new
    });
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};
    use landform_core::math;
    use landform_core::terrain::{Bed, Layer, Materials};
    use landform_core::terrain::{HeightField, NodeSurface};
    use landform_core::units::YEAR;

    use super::*;
    use crate::stream_power::StreamPower;

    fn layered(beds: &[(&str, f64)]) -> Layers {
        let all = Materials::default();
        let beds = beds.iter().map(|&(name, thickness)| Bed { material: all.find(name).unwrap(), thickness }).collect();
        Layers::bedded(&all, beds, vec![100.0; 9]).unwrap()
    }

    #[test]
    fn a_step_through_beds_solves_its_equation() {
        let layers = layered(&[("sandstone", 3.0), ("shale", 1e6)]);
        let k = Resolved::Uniform(0.0);
        let rock = Rock { erodibility: &k, layers: Some(&layers), weakness: None, by_material: true };
        for exponent in [1.0, 2.0, 0.7] {
            let params = StreamPower { slope_exponent: exponent, limiting_slope: Some(0.0), ..StreamPower::default() };
            let law = params.law(f64::NEG_INFINITY, 20_000.0 * YEAR, true);
            let at = (1e6, 30.0);
            let whole = rock.worn(&law, &layers, 4, 100.0, 90.0, at);
            // The equation itself, and that neither material alone would give it.
            let (sand, shale) = (layers.surface(4, 100.0).erodibility, layers.surface(4, 97.0).erodibility);
            let z = 90.0 + whole;
            let passed = if z < 97.0 { 3.0 / sand + (97.0 - z) / shale } else { (100.0 - z) / sand };
            let driven = law.dt * math::pow(at.0, 0.5) * math::pow(whole / at.1, exponent);
            assert!((passed / driven - 1.0).abs() < 1e-9, "n {exponent}: {passed} {driven}");
            let alone = |k: f64| law.worn(10.0, law.strength(k, at.0, at.1), f64::INFINITY);
            assert!(alone(shale) < whole && whole <= alone(sand), "n {exponent}: {whole}");
        }
    }

    #[test]
    fn one_material_in_beds_is_the_same_as_no_beds() {
        let grid = Grid::new(Shape::new(3, 3), [10.0; 2]).unwrap();
        let mut ground = HeightField::new(grid, (0..9).map(|i| f64::from(i * i)).collect()).unwrap();
        let domain = ground.domain();
        let (mut flow, mut area) = (Flow::new(), vec![1e5; 9]);
        flow.route(&*domain, ground.elevation(), &mut area);
        let layers = layered(&[("rock", 0.25), ("rock", 0.5)]);
        let law = StreamPower { talus_angle: Some(landform_core::units::Angle::of(80.0)), ..StreamPower::default() }
            .law(f64::NEG_INFINITY, 1e4 * YEAR, true);
        let k = Resolved::Uniform(layers.surface(0, 0.0).erodibility);
        let plain = Rock { erodibility: &k, layers: None, weakness: None, by_material: false };
        let mut z = ground.elevation().to_vec();
        super::super::braun_willett_2013::sweep(&*domain, &flow, &law, &plain, &mut area.clone(), &mut z);
        let beds = Rock { layers: Some(&layers), by_material: true, ..plain };
        ground.change(Layer::Bedrock, |new| sweep_layers(&*domain, &flow, &law, &beds, &layers, &mut area, new));
        for (a, b) in z.iter().zip(ground.elevation()) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
    }

    #[test]
    fn weak_rock_wears_faster() {
        let layers = layered(&[("sandstone", 1e6)]);
        let (k, weakness) = (Resolved::Uniform(3.0), Resolved::Uniform(4.0));
        let sandstone = layers.surface(4, 100.0).erodibility;
        let rock = Rock { erodibility: &k, layers: Some(&layers), weakness: Some(&weakness), by_material: true };
        assert_eq!(rock.erodibility(4, 90.0), 4.0 * sandstone);
    }
}
