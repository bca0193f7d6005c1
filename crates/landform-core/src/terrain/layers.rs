//! Layers under the surface: beds of rock, and loose layers on them.
//!
//! Beds follow from elevation, so that erosion of rock needs no bookkeeping: a node's rock at
//! elevation z lies at the depth `datum − z` in a sequence that repeats downwards, where `datum` is
//! the elevation of the sequence's top. Uplift moves the datum. Loose layers are depths on every
//! node, at most one a material, and lie on each other in the order of the table of materials.

use serde::{Deserialize, Serialize};

use super::material::{Material, Materials};
use crate::{Error, Result, math, parallel};

/// Which part of the ground a change moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer<'a> {
    /// Rock, with all that lies on it: uplift, faults, edits of the shape.
    Bedrock,
    /// The surface: where it sinks, the uppermost material is removed first; where it rises, this
    /// material is deposited.
    Surface(&'a str),
}

/// A bed of rock.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bed {
    /// Number of the material.
    pub material: u8,
    /// Thickness across the bedding's dip, measured vertically, m.
    pub thickness: f64,
}

/// A sequence of beds that repeats downwards.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Beds {
    sequence: Vec<Bed>,
    /// Depth of each bed's lower face below the sequence's top, m.
    below: Vec<f64>,
    /// Elevation of the sequence's top at every node, m.
    datum: Vec<f64>,
}

/// A loose layer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Loose {
    material: u8,
    /// Depth on every node, m.
    depth: Vec<f64>,
}

/// Volumes of a material that have moved since the layers were made, m³.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MovedVolume {
    /// Removed from the ground, m³.
    pub eroded: f64,
    /// Deposited, m³.
    pub deposited: f64,
}

/// The layers of the ground under every node of a surface.
///
/// The upper face of the first bed lies at 400 m:
///
/// ```
/// use landform_core::terrain::{Bed, Layers, Materials};
///
/// let materials = Materials::default();
/// let sandstone = Bed { material: materials.need("sandstone", "beds")?, thickness: 60.0 };
/// let shale = Bed { material: materials.need("shale", "beds")?, thickness: 90.0 };
/// let layers = Layers::bedded(&materials, vec![sandstone, shale], vec![400.0])?;
/// assert_eq!(layers.surface(0, 390.0).name, "sandstone");
/// assert_eq!(layers.surface(0, 330.0).name, "shale");
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layers {
    materials: Materials,
    beds: Option<Beds>,
    /// Lowest first.
    loose: Vec<Loose>,
    moved: Vec<MovedVolume>,
    nodes: usize,
}

/// A stretch of one material in a column of ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stratum<'a> {
    /// The material.
    pub material: &'a Material,
    /// Its number.
    pub number: u8,
    /// Elevation of its lower face, m; negative infinity at the bottom of the column.
    pub bottom: f64,
}

/// A loose layer thinner than this is not the surface material, m.
const THINNEST: f64 = 1e-3;
/// The number of the material of ground without beds.
const ROCK: u8 = 0;

impl Layers {
    /// Uniform rock without loose layers under `nodes` nodes.
    pub fn rock(materials: &Materials, nodes: usize) -> Self {
        let moved = vec![MovedVolume::default(); materials.all().len()];
        Self { materials: materials.clone(), beds: None, loose: Vec::new(), moved, nodes }
    }

    /// Rock in beds, from the top, repeated downwards (and upwards); `datum` is the elevation of
    /// the first bed's upper face at every node, m.
    ///
    /// # Errors
    /// [`Error::Parameter`] without beds, or for a bed that is not thicker than 0 m.
    pub fn bedded(materials: &Materials, sequence: Vec<Bed>, datum: Vec<f64>) -> Result<Self> {
        if sequence.is_empty() {
            return Err(Error::parameter("beds", "[]", "at least one bed"));
        }
        if let Some(bed) = sequence.iter().find(|b| !(b.thickness > 0.0 && b.thickness.is_finite())) {
            return Err(Error::parameter("beds.thickness", format!("{} m", bed.thickness), "> 0 m"));
        }
        let below = sequence.iter().scan(0.0, |sum, bed| {
            *sum += bed.thickness;
            Some(*sum)
        });
        let beds = Beds { below: below.collect(), sequence, datum };
        Ok(Self { beds: Some(beds), ..Self::rock(materials, 0) }.with_nodes())
    }

    fn with_nodes(mut self) -> Self {
        self.nodes = self.beds.as_ref().map_or(self.nodes, |b| b.datum.len());
        self
    }

    /// The table of materials.
    pub fn materials(&self) -> &Materials {
        &self.materials
    }

    /// Volumes moved of each material, in the order of the table.
    pub fn moved(&self) -> &[MovedVolume] {
        &self.moved
    }

    /// Whether rock differs from place to place.
    pub fn has_beds(&self) -> bool {
        self.beds.is_some()
    }

    /// Depth of a loose layer on every node, m; none where there never was such a layer.
    pub fn depth(&self, material: &str) -> Option<&[f64]> {
        let number = self.materials.find(material)?;
        self.loose.iter().find(|l| l.material == number).map(|l| l.depth.as_slice())
    }

    /// Names of the loose layers, lowest first.
    pub fn loose(&self) -> impl Iterator<Item = &str> {
        self.loose.iter().map(|l| self.materials.get(l.material).name.as_str())
    }

    /// Depth of a loose layer, made where there is none.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a material that is not in the table.
    pub(super) fn depth_mut(&mut self, material: &str) -> Result<&mut Vec<f64>> {
        let number = self.materials.need(material, "material")?;
        Ok(self.loose_mut(number))
    }

    /// Elevation of the upper face of the first bed at a node, m; none without beds.
    ///
    /// ```
    /// use landform_core::terrain::{Layers, Materials};
    ///
    /// assert_eq!(Layers::rock(&Materials::default(), 4).datum(0), None);
    /// ```
    pub fn datum(&self, node: usize) -> Option<f64> {
        self.beds.as_ref().map(|beds| beds.datum[node])
    }

    /// The strata under a node whose surface stands at `z` metres, from the surface down.
    pub fn column(&self, node: usize, z: f64) -> Column<'_> {
        Column { layers: self, node, top: z, loose: self.loose.len() }
    }

    /// The material at the surface of a node at `z` metres. Films thinner than a millimetre are
    /// ignored.
    pub fn surface(&self, node: usize, z: f64) -> &Material {
        self.materials.get(self.surface_number(node, z))
    }

    /// The number of the material at the surface of a node at `z`.
    pub fn surface_number(&self, node: usize, z: f64) -> u8 {
        let (mut top, mut number) = (z, ROCK);
        for stratum in self.column(node, z) {
            number = stratum.number;
            if top - stratum.bottom > THINNEST {
                break;
            }
            top = stratum.bottom;
        }
        number
    }

    /// The elevation (m) to which ground can stand at a node at `z`, `length` from a place at
    /// `base`: each stratum rises at its own angle of repose.
    pub fn stable_height(&self, node: usize, z: f64, base: f64, length: f64) -> f64 {
        // Strata from the surface down to the base, climbed from the lowest.
        let mut rises = [(0.0, 0.0); 16];
        let (mut count, mut top) = (0, z);
        for stratum in self.column(node, z) {
            let bottom = stratum.bottom.max(base);
            if count == rises.len() {
                // Finer than this, the lowest stratum is used for the rest.
                break;
            }
            rises[count] = (top, math::tan(stratum.material.repose));
            count += 1;
            top = bottom;
            if !(bottom > base) {
                break;
            }
        }
        let (mut height, mut left) = (base, length);
        for &(top, slope) in rises[..count].iter().rev() {
            let run = (top - height).max(0.0) / slope;
            if run >= left {
                return height + slope * left;
            }
            left -= run;
            height = height.max(top);
        }
        f64::INFINITY
    }

    /// Follows a change of the surface; `area` is that of each node, m².
    pub(super) fn follow(&mut self, layer: Layer, before: &[f64], after: &[f64], area: &dyn Fn(usize) -> f64) {
        match layer {
            Layer::Bedrock => {
                if let Some(beds) = &mut self.beds {
                    parallel::update(&mut beds.datum, |i, d| {
                        let moved = after[i] - before[i];
                        if moved.is_finite() {
                            *d += moved;
                        }
                    });
                }
            }
            Layer::Surface(lays) => {
                self.cut(before, after, area);
                self.lay(lays, before, after, area);
            }
        }
    }

    /// Follows a change of one node's surface from one elevation to another; `material` is what is
    /// laid where it rises. `tell` is given the number of each material cut, and its volume.
    pub(super) fn follow_node(
        &mut self,
        node: usize,
        [before, after]: [f64; 2],
        material: u8,
        area: f64,
        tell: &mut impl FnMut(u8, f64),
    ) {
        if after > before {
            self.loose_mut(material)[node] += after - before;
            self.moved[usize::from(material)].deposited += (after - before) * area;
        } else {
            self.cut_node(node, [before, after], area, tell);
        }
    }

    /// Takes what was cut from the uppermost down.
    fn cut(&mut self, before: &[f64], after: &[f64], area: &dyn Fn(usize) -> f64) {
        for i in 0..self.nodes {
            if before[i] - after[i] > 0.0 {
                self.cut_node(i, [before[i], after[i]], area(i), &mut |_, _| {});
            }
        }
    }

    fn cut_node(&mut self, node: usize, [before, after]: [f64; 2], area: f64, tell: &mut impl FnMut(u8, f64)) {
        let (mut cut, mut z) = (before - after, before);
        if !(cut > 0.0) {
            return;
        }
        for loose in self.loose.iter_mut().rev() {
            let taken = cut.min(loose.depth[node]);
            if taken > 0.0 {
                loose.depth[node] -= taken;
                self.moved[usize::from(loose.material)].eroded += taken * area;
                tell(loose.material, taken * area);
                (cut, z) = (cut - taken, z - taken);
            }
        }
        // Rock follows from elevation: only the volumes are counted.
        while cut > 0.0 {
            let (number, bottom) = self.rock_at(node, z);
            let taken = cut.min(z - bottom);
            self.moved[usize::from(number)].eroded += taken * area;
            tell(number, taken * area);
            (cut, z) = (cut - taken, bottom);
        }
    }

    /// Depth of the loose layer of a material's number, made where there is none.
    fn loose_mut(&mut self, number: u8) -> &mut Vec<f64> {
        let at = self.loose.partition_point(|l| l.material < number);
        if self.loose.get(at).is_none_or(|l| l.material != number) {
            self.loose.insert(at, Loose { material: number, depth: vec![0.0; self.nodes] });
        }
        &mut self.loose[at].depth
    }

    fn lay(&mut self, lays: &str, before: &[f64], after: &[f64], area: &dyn Fn(usize) -> f64) {
        let rises = |i: usize| after[i] - before[i] > 0.0;
        if parallel::find_first(self.nodes, rises).is_none() {
            return;
        }
        let Some(number) = self.materials.find(lays) else { return };
        let mut volume = 0.0;
        let depth = self.loose_mut(number);
        for i in (0..depth.len()).filter(|&i| rises(i)) {
            depth[i] += after[i] - before[i];
            volume += (after[i] - before[i]) * area(i);
        }
        self.moved[usize::from(number)].deposited += volume;
    }

    /// The rock at an elevation of a node, looking down: its number, and the elevation of its lower
    /// face.
    fn rock_at(&self, node: usize, z: f64) -> (u8, f64) {
        let Some(beds) = &self.beds else { return (ROCK, f64::NEG_INFINITY) };
        let whole = beds.below[beds.below.len() - 1];
        let depth = beds.datum[node] - z;
        if !depth.is_finite() {
            return (ROCK, f64::NEG_INFINITY);
        }
        let mut turn = (depth / whole).floor();
        loop {
            for (bed, below) in beds.sequence.iter().zip(&beds.below) {
                let bottom = beds.datum[node] - (turn * whole + below);
                // On a face, or a rounding error above it, the lower bed counts.
                if bottom < z - 1e-9 {
                    return (bed.material, bottom);
                }
            }
            turn += 1.0;
        }
    }

    /// The same make-up on other nodes, by a map of values from these nodes to those.
    pub fn mapped(&self, map: impl Fn(&[f64]) -> Vec<f64>) -> Self {
        let beds = self.beds.as_ref().map(|b| Beds { datum: map(&b.datum), ..b.clone() });
        let no_hole = |v: f64| if v.is_nan() { 0.0 } else { v.max(0.0) };
        let loose: Vec<Loose> = self
            .loose
            .iter()
            .map(|l| Loose { material: l.material, depth: map(&l.depth).into_iter().map(no_hole).collect() })
            .collect();
        let nodes = beds.as_ref().map(|b| b.datum.len()).or(loose.first().map(|l| l.depth.len()));
        let nodes = nodes.unwrap_or_else(|| map(&vec![0.0; self.nodes]).len());
        Self { materials: self.materials.clone(), beds, loose, moved: self.moved.clone(), nodes }
    }

    /// The first node whose depth of a loose layer is not a number.
    /// Adds what changed between two states of a coarser form, brought to these nodes by `spread`:
    /// the datum of beds, and depths, of which none falls below 0.
    pub(super) fn add_change(&mut self, before: &Self, after: &Self, spread: impl Fn(&[f64]) -> Vec<f64>) {
        if let (Some(beds), Some(old), Some(new)) = (&mut self.beds, &before.beds, &after.beds) {
            let moved = spread(&parallel::map(old.datum.len(), |i| new.datum[i] - old.datum[i]));
            parallel::update(&mut beds.datum, |i, d| *d += moved[i]);
        }
        for loose in &after.loose {
            let old = before.loose.iter().find(|l| l.material == loose.material);
            let more = |i: usize| loose.depth[i] - old.map_or(0.0, |l| l.depth[i]);
            let more = spread(&parallel::map(loose.depth.len(), more));
            let name = after.materials.get(loose.material).name.clone();
            if let Ok(depth) = self.depth_mut(&name) {
                parallel::update(depth, |i, d| *d = (*d + more[i]).max(0.0));
            }
        }
    }

    pub(super) fn find_non_finite(&self) -> Option<usize> {
        self.loose.iter().find_map(|l| parallel::find_first(l.depth.len(), |i| !l.depth[i].is_finite()))
    }
}

/// The strata under a node, from the surface down.
#[derive(Clone, Debug)]
pub struct Column<'a> {
    layers: &'a Layers,
    node: usize,
    top: f64,
    /// Loose layers not yet passed.
    loose: usize,
}

impl<'a> Iterator for Column<'a> {
    type Item = Stratum<'a>;

    fn next(&mut self) -> Option<Stratum<'a>> {
        if self.top == f64::NEG_INFINITY {
            return None;
        }
        while self.loose > 0 {
            self.loose -= 1;
            let layer = &self.layers.loose[self.loose];
            let depth = layer.depth[self.node];
            if depth > 0.0 {
                self.top -= depth;
                let material = self.layers.materials.get(layer.material);
                return Some(Stratum { material, number: layer.material, bottom: self.top });
            }
        }
        let (number, bottom) = self.layers.rock_at(self.node, self.top);
        self.top = bottom;
        Some(Stratum { material: self.layers.materials.get(number), number, bottom })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ledge() -> Layers {
        let all = Materials::default();
        let bed = |name: &str, thickness: f64| Bed { material: all.find(name).unwrap(), thickness };
        Layers::bedded(&all, vec![bed("sandstone", 60.0), bed("shale", 90.0)], vec![400.0, 380.0]).unwrap()
    }

    #[test]
    fn beds_repeat_downwards_and_a_face_belongs_to_the_bed_below() {
        let layers = ledge();
        let column: Vec<_> = layers.column(0, 390.0).take(3).map(|s| (s.material.name.clone(), s.bottom)).collect();
        assert_eq!(column, [("sandstone".into(), 340.0), ("shale".into(), 250.0), ("sandstone".into(), 190.0)]);
        assert_eq!(layers.surface(0, 340.0).name, "shale");
        assert_eq!(layers.surface(1, 345.0).name, "sandstone");
        // Above the first bed the sequence repeats too.
        assert_eq!(layers.surface(0, 401.0).name, "shale");
    }

    #[test]
    fn what_is_cut_is_the_uppermost_first_and_is_told_by_material() {
        let mut layers = ledge();
        layers.depth_mut("sand").unwrap().copy_from_slice(&[2.0, 0.0]);
        layers.depth_mut("soil").unwrap().copy_from_slice(&[1.0, 1.0]);
        assert_eq!(layers.loose().collect::<Vec<_>>(), ["soil", "sand"]);
        let (before, after) = ([343.0, 390.0], [338.0, 391.0]);
        layers.follow(Layer::Surface("gravel"), &before, &after, &|_| 10.0);
        let of = |name: &str| layers.moved()[usize::from(layers.materials().find(name).unwrap())];
        assert_eq!((of("sand").eroded, of("soil").eroded, of("shale").eroded), (20.0, 10.0, 20.0));
        assert_eq!(of("gravel").deposited, 10.0);
        assert_eq!((layers.depth("sand").unwrap()[0], layers.depth("gravel").unwrap()[1]), (0.0, 1.0));
        // Uplift carries the beds along.
        layers.follow(Layer::Bedrock, &[338.0, 391.0], &[438.0, 391.0], &|_| 10.0);
        assert_eq!(layers.surface(0, 438.0).name, "shale");
        assert_eq!(layers.surface(0, 441.0).name, "sandstone");
    }

    #[test]
    fn ground_stands_at_the_angle_of_each_bed() {
        let layers = ledge();
        let (steep, gentle) = (math::tan(60.0_f64.to_radians()), math::tan(30.0_f64.to_radians()));
        // From 330 m, ten metres of shale, then sandstone.
        let reach = 10.0 / gentle;
        let expected = 340.0 + (40.0 - reach) * steep;
        assert!((layers.stable_height(0, 400.0, 330.0, 40.0) - expected).abs() < 1e-9);
        assert!((layers.stable_height(0, 400.0, 330.0, 5.0) - (330.0 + 5.0 * gentle)).abs() < 1e-9);
        assert_eq!(layers.stable_height(0, 335.0, 330.0, 40.0), f64::INFINITY);
    }
}
