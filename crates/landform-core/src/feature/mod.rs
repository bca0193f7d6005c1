//! Features: objects with a name, a kind and a geometry, such as rivers, lakes and coasts.
//!
//! A stage finds them, the landscape keeps them, later stages read them, exports write them. A
//! feature that is found again nearby keeps its id ([`Features::keep_ids`]).
//!
//! ```
//! use landform_core::feature::{Feature, FeatureKind, Geometry, near};
//!
//! let river = Feature {
//!     id: "1".into(),
//!     kind: FeatureKind::River,
//!     geometry: Geometry::Line(vec![[0.0, 0.0, 5.0], [100.0, 0.0, 4.0]]),
//!     properties: Vec::new(),
//! };
//! let marked = near(std::iter::once(&river), 10.0, &[[50.0, 8.0], [50.0, 12.0]]);
//! assert_eq!(marked, [true, false]);
//! ```

mod conduits;
mod distance;
mod identity;

use serde::{Deserialize, Serialize};

use crate::{Error, Result};

pub use conduits::{Conduit, ConduitNetwork, Passage, adjacency};
pub use distance::near;

/// What a feature is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[non_exhaustive]
pub enum FeatureKind {
    /// A reach of a river, from its upper end down.
    River,
    /// The shore of a lake.
    Lake,
    /// The outline of a drainage basin.
    Basin,
    /// A line between land and sea.
    Coast,
    /// A line of one elevation.
    Contour,
    /// A passage under the ground between two junctions or ends ([`ConduitNetwork`]).
    Conduit,
    /// A place where water sinks into the ground.
    Sinkhole,
    /// A place where water leaves the ground.
    Spring,
    /// A place where a passage opens to the surface.
    Entrance,
    /// The middle of a road.
    Path,
    /// Objects of one kind that stand on the ground, such as trees.
    Object,
}

impl FeatureKind {
    /// All kinds, by the word for several of them.
    pub const ALL: &'static [(&'static str, Self)] = &[
        ("rivers", Self::River),
        ("lakes", Self::Lake),
        ("basins", Self::Basin),
        ("coasts", Self::Coast),
        ("contours", Self::Contour),
        ("conduits", Self::Conduit),
        ("sinkholes", Self::Sinkhole),
        ("springs", Self::Spring),
        ("entrances", Self::Entrance),
        ("paths", Self::Path),
        ("objects", Self::Object),
    ];

    /// The word for one: "river".
    pub fn word(self) -> &'static str {
        match self {
            Self::River => "river",
            Self::Lake => "lake",
            Self::Basin => "basin",
            Self::Coast => "coast",
            Self::Contour => "contour",
            Self::Conduit => "conduit",
            Self::Sinkhole => "sinkhole",
            Self::Spring => "spring",
            Self::Entrance => "entrance",
            Self::Path => "path",
            Self::Object => "object",
        }
    }

    /// Stages that leave features of this kind; none for those that are found on a surface.
    ///
    /// ```
    /// use landform_core::feature::FeatureKind;
    ///
    /// assert!(FeatureKind::Conduit.left_by().contains(&"karst_network"));
    /// ```
    pub fn left_by(self) -> &'static [&'static str] {
        match self {
            Self::Conduit | Self::Sinkhole | Self::Spring => &["karst_network", "cave"],
            Self::Entrance => &["karst_network"],
            Self::Path => &["carve_path"],
            Self::Object => &["scatter"],
            _ => &[],
        }
    }

    /// How to come by features of this kind.
    ///
    /// ```
    /// use landform_core::feature::FeatureKind;
    ///
    /// assert_eq!(FeatureKind::River.remedy(), "`find_features` makes them");
    /// ```
    pub fn remedy(self) -> String {
        match self.left_by() {
            [] => "`find_features` makes them".into(),
            [one] => format!("`{one}` makes them"),
            [raster, body, ..] => format!("`{raster}` makes them under a raster, `{body}` in voxels"),
        }
    }

    /// The kind that a word for several names: "rivers".
    pub fn of(word: &str) -> Option<Self> {
        Self::ALL.iter().find(|k| k.0 == word).map(|k| k.1)
    }
}

/// A part of the plane: rings of (x, y), the outer one first, m.
pub type Polygon = Vec<Vec<[f64; 2]>>;

/// Where a feature lies, m.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Geometry {
    /// A place.
    Point([f64; 3]),
    /// Places, in no order that means anything.
    Points(Vec<[f64; 3]>),
    /// A line.
    Line(Vec<[f64; 3]>),
    /// A line in the plane; closed ones begin and end at the same place.
    FlatLine(Vec<[f64; 2]>),
    /// Parts of the plane.
    Area(Vec<Polygon>),
    /// Places joined by edges.
    Network {
        /// The places.
        nodes: Vec<[f64; 3]>,
        /// Indices of the two ends of each edge.
        edges: Vec<[u32; 2]>,
    },
}

/// A property of a feature.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Property {
    /// Not known, or none.
    None,
    /// Yes or no.
    Flag(bool),
    /// A whole number.
    Whole(u32),
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
    /// The id of another feature.
    Id(String),
    /// A place in the plane, m.
    Place([f64; 2]),
    /// A number for each place of a line.
    Numbers(Vec<f64>),
}

/// An object with a name, a kind and a geometry.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Feature {
    /// Name among its kind.
    pub id: String,
    /// What it is.
    pub kind: FeatureKind,
    /// Where it lies.
    pub geometry: Geometry,
    /// Properties, in order.
    pub properties: Vec<(String, Property)>,
}

impl Feature {
    /// A property by its name.
    ///
    /// ```
    /// use landform_core::feature::{Feature, FeatureKind, Geometry, Property};
    ///
    /// let properties = vec![("pressure".into(), Property::Number(0.8))];
    /// let inlet =
    ///     Feature { id: "1".into(), kind: FeatureKind::Sinkhole, geometry: Geometry::Point([0.0; 3]), properties };
    /// assert_eq!(inlet.property("pressure"), Some(&Property::Number(0.8)));
    /// assert_eq!(inlet.property("depth"), None);
    /// ```
    pub fn property(&self, name: &str) -> Option<&Property> {
        self.properties.iter().find(|p| p.0 == name).map(|p| &p.1)
    }

    /// A property that is a number, in the unit that its name ends with.
    ///
    /// ```
    /// use landform_core::feature::{Feature, FeatureKind, Geometry, Property};
    ///
    /// let properties = vec![("width_m".into(), Property::Number(8.0))];
    /// let road = Feature { id: "1".into(), kind: FeatureKind::Path, geometry: Geometry::Line(Vec::new()), properties };
    /// assert_eq!((road.number("width_m"), road.number("depth_m")), (Some(8.0), None));
    /// ```
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.property(name) {
            Some(Property::Number(value)) => Some(*value),
            _ => None,
        }
    }

    /// A property that has a number for each place of a line.
    ///
    /// ```
    /// use landform_core::feature::{Feature, FeatureKind, Geometry, Property};
    ///
    /// let properties = vec![("left_m".into(), Property::Numbers(vec![1.0, 1.5]))];
    /// let geometry = Geometry::Line(vec![[0.0; 3], [9.0, 0.0, 0.0]]);
    /// let conduit = Feature { id: "1".into(), kind: FeatureKind::Conduit, geometry, properties };
    /// assert_eq!(conduit.numbers("left_m"), Some([1.0, 1.5].as_slice()));
    /// ```
    pub fn numbers(&self, name: &str) -> Option<&[f64]> {
        match self.property(name) {
            Some(Property::Numbers(values)) => Some(values),
            _ => None,
        }
    }
}

/// The features of a landscape.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Features(Vec<Feature>);

impl Features {
    /// All, in order.
    pub fn iter(&self) -> std::slice::Iter<'_, Feature> {
        self.0.iter()
    }

    /// Those of a kind.
    pub fn of(&self, kind: FeatureKind) -> impl Iterator<Item = &Feature> {
        self.0.iter().filter(move |f| f.kind == kind)
    }

    /// Those of a kind, where there are some.
    ///
    /// # Errors
    /// [`Error::Recipe`] that names the kind, `needed_by` and the stage that makes such features.
    ///
    /// ```
    /// use landform_core::feature::{FeatureKind, Features};
    ///
    /// let none = Features::default();
    /// assert!(none.need(FeatureKind::Conduit, "`write_survey`").is_err());
    /// ```
    pub fn need(&self, kind: FeatureKind, needed_by: &str) -> Result<Vec<&Feature>> {
        let found: Vec<&Feature> = self.of(kind).collect();
        if !found.is_empty() {
            return Ok(found);
        }
        let what = format!("the landscape has no {}s; {needed_by} needs some", kind.word());
        Err(Error::Recipe { at: None, what, hint: Some(kind.remedy()) })
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds a feature to those of its kind; one with the same id gets another: "path 1", "path
    /// 1-2".
    ///
    /// ```
    /// use landform_core::feature::{Feature, FeatureKind, Features, Geometry};
    ///
    /// let geometry = Geometry::Points(vec![[0.0; 3]]);
    /// let trees = Feature { id: "tree".into(), kind: FeatureKind::Object, geometry, properties: Vec::new() };
    /// let mut features = Features::default();
    /// features.add(trees.clone());
    /// features.add(trees);
    /// let ids: Vec<&str> = features.iter().map(|f| f.id.as_str()).collect();
    /// assert_eq!(ids, ["tree", "tree-2"]);
    /// ```
    pub fn add(&mut self, mut feature: Feature) {
        let is_used = |id: &str| self.of(feature.kind).any(|f| f.id == id);
        let others = (2..).map(|n: u32| format!("{}-{n}", feature.id));
        if let Some(id) = std::iter::once(feature.id.clone()).chain(others).find(|id| !is_used(id)) {
            feature.id = id;
        }
        self.0.push(feature);
    }

    /// Replaces all features of the kinds that `found` holds; they keep the ids of those that they
    /// lie nearest to.
    pub fn update(&mut self, mut found: Self) {
        found.keep_ids(self);
        let kinds: Vec<FeatureKind> = found.iter().map(|f| f.kind).collect();
        self.0.retain(|f| !kinds.contains(&f.kind));
        self.0.append(&mut found.0);
    }
}

impl FromIterator<Feature> for Features {
    fn from_iter<I: IntoIterator<Item = Feature>>(features: I) -> Self {
        Self(features.into_iter().collect())
    }
}

impl Feature {
    /// Places along the feature: points of lines, corners of areas.
    pub(crate) fn places(&self) -> Vec<[f64; 2]> {
        let flat = |p: &[f64; 3]| [p[0], p[1]];
        match &self.geometry {
            Geometry::Point(p) => vec![flat(p)],
            Geometry::Points(points) => points.iter().map(flat).collect(),
            Geometry::Line(line) => line.iter().map(flat).collect(),
            Geometry::FlatLine(line) => line.clone(),
            Geometry::Area(parts) => parts.iter().flatten().flatten().copied().collect(),
            Geometry::Network { nodes, .. } => nodes.iter().map(flat).collect(),
        }
    }
}
