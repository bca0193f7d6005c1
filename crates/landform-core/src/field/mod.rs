//! Named, typed values per node.
//!
//! ```
//! use landform_core::field::{Fields, names};
//!
//! let mut fields = Fields::sized(3);
//! fields.insert(&names::SLOPE, vec![0.0, 0.1, 0.2])?;
//! assert_eq!(fields.get(&names::SLOPE, "a map")?, [0.0, 0.1, 0.2]);
//! assert!(fields.get(&names::CHI, "a map").is_err());
//! assert!(fields.insert(&names::CHI, vec![0.0]).is_err());
//! # Ok::<(), landform_core::Error>(())
//! ```

pub mod names;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{Error, Result, parallel};

/// The name of a field with its type, unit and meaning: a misspelt field is a compile error.
#[derive(Debug)]
pub struct Key<T> {
    /// Name in recipes and files.
    pub name: &'static str,
    /// Unit of the stored values.
    pub unit: &'static str,
    /// Meaning, in a phrase.
    pub meaning: &'static str,
    /// Nodes, columns or voxels that have its values.
    pub at: At,
    kind: std::marker::PhantomData<T>,
}

/// Parts of a terrain that the values of a field belong to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum At {
    /// One for every node of a surface.
    #[default]
    Node,
    /// One for every column of a volume.
    Column,
    /// One for every voxel of a volume.
    Voxel,
}

impl<T> Key<T> {
    /// A key of values on nodes; used by [`names`] only.
    pub const fn new(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self { name, unit, meaning, at: At::Node, kind: std::marker::PhantomData }
    }
}

/// Values of one field, of one of the types that fields may have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Values {
    /// Real numbers.
    F64(Vec<f64>),
    /// Real numbers of single precision.
    F32(Vec<f32>),
    /// Counts and identifiers.
    U32(Vec<u32>),
    /// Classes.
    U8(Vec<u8>),
}

/// A type that fields may have.
pub trait Element: Copy + Send + Sync + 'static {
    /// The values, if they are of this type.
    fn of(values: &Values) -> Option<&Vec<Self>>;
    /// The values, if they are of this type.
    fn of_mut(values: &mut Values) -> Option<&mut Vec<Self>>;
    /// Wraps values.
    fn wrap(values: Vec<Self>) -> Values;
}

macro_rules! element {
    ($type:ty, $variant:ident) => {
        impl Element for $type {
            fn of(values: &Values) -> Option<&Vec<Self>> {
                if let Values::$variant(v) = values { Some(v) } else { None }
            }
            fn of_mut(values: &mut Values) -> Option<&mut Vec<Self>> {
                if let Values::$variant(v) = values { Some(v) } else { None }
            }
            fn wrap(values: Vec<Self>) -> Values {
                Values::$variant(values)
            }
        }
    };
}
element!(f64, F64);
element!(f32, F32);
element!(u32, U32);
element!(u8, U8);

impl Values {
    /// Number of values.
    pub fn len(&self) -> usize {
        match self {
            Self::F64(v) => v.len(),
            Self::F32(v) => v.len(),
            Self::U32(v) => v.len(),
            Self::U8(v) => v.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The values as real numbers.
    pub fn to_f64(&self) -> Vec<f64> {
        match self {
            Self::F64(v) => v.clone(),
            Self::F32(v) => v.iter().map(|&x| f64::from(x)).collect(),
            Self::U32(v) => v.iter().map(|&x| f64::from(x)).collect(),
            Self::U8(v) => v.iter().map(|&x| f64::from(x)).collect(),
        }
    }

    /// The values at some places.
    pub fn picked(&self, places: &[u32]) -> Self {
        fn of<T: Copy>(values: &[T], places: &[u32]) -> Vec<T> {
            places.iter().map(|&i| values[i as usize]).collect()
        }
        match self {
            Self::F64(v) => Self::F64(of(v, places)),
            Self::F32(v) => Self::F32(of(v, places)),
            Self::U32(v) => Self::U32(of(v, places)),
            Self::U8(v) => Self::U8(of(v, places)),
        }
    }
}

/// The optional fields of a terrain, by name, in the order of their names.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Fields {
    /// How many values a field has.
    nodes: usize,
    all: BTreeMap<String, Values>,
}

impl Fields {
    /// No fields yet, for this many nodes.
    pub fn sized(nodes: usize) -> Self {
        Self { nodes, all: BTreeMap::new() }
    }

    /// The field of a key.
    ///
    /// # Errors
    /// [`Error::MissingField`], naming `needed_by`.
    pub fn get<T: Element>(&self, key: &Key<T>, needed_by: &str) -> Result<&[T]> {
        self.all.get(key.name).and_then(T::of).map(Vec::as_slice).ok_or_else(|| self.missing(key.name, needed_by))
    }

    /// The field of a name, if there is one.
    pub fn find(&self, name: &str) -> Option<&Values> {
        self.all.get(name)
    }

    /// Adds a field, replacing one of the same name.
    ///
    /// # Errors
    /// [`Error::Shape`] if there is not one value a node.
    pub fn insert<T: Element>(&mut self, key: &Key<T>, values: Vec<T>) -> Result<()> {
        self.insert_values(key.name, T::wrap(values))
    }

    /// Adds a field under a name of the user's own, without a key.
    ///
    /// # Errors
    /// [`Error::Shape`] if there is not one value a node.
    pub fn insert_values(&mut self, name: &str, values: Values) -> Result<()> {
        if values.len() != self.nodes {
            let (found, expected) = (format!("{} values", values.len()), self.nodes.to_string());
            return Err(Error::Shape { what: format!("field `{name}`"), found, expected });
        }
        self.all.insert(name.into(), values);
        Ok(())
    }

    /// Adds values to a field, in its SI unit; one that was not there begins with zeros.
    ///
    /// ```
    /// use landform_core::field::{Fields, names};
    ///
    /// let mut fields = Fields::sized(2);
    /// fields.add(&names::INCISION, &[0.0, 1.0]);
    /// fields.add(&names::INCISION, &[5.0, 5.0]);
    /// assert_eq!(fields.get(&names::INCISION, "a map")?, [5.0, 6.0]);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn add(&mut self, key: &Key<f64>, values: &[f64]) {
        let mut sums = self.taken(key);
        parallel::map_pieces_mut([&mut sums], parallel::PIECE, |first, [sums]| {
            sums.iter_mut().zip(&values[first..]).for_each(|(sum, value)| *sum += value);
        });
        self.all.insert(key.name.into(), Values::F64(sums));
    }

    /// The field of a key, taken out; zeros where there is none.
    fn taken(&mut self, key: &Key<f64>) -> Vec<f64> {
        match self.all.remove(key.name) {
            Some(Values::F64(values)) => values,
            _ => vec![0.0; self.nodes],
        }
    }

    /// Adds what is above 0 of every value to one field, and what is below 0, as a positive number,
    /// to another.
    ///
    /// ```
    /// use landform_core::field::{Fields, names};
    ///
    /// let mut fields = Fields::sized(2);
    /// fields.add_parts(&names::INCISION, &names::DEPOSITION, &[2.0, -3.0]);
    /// assert_eq!(fields.get(&names::INCISION, "a map")?, [2.0, 0.0]);
    /// assert_eq!(fields.get(&names::DEPOSITION, "a map")?, [0.0, 3.0]);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn add_parts(&mut self, above: &Key<f64>, below: &Key<f64>, values: &[f64]) {
        let (mut more, mut less) = (self.taken(above), self.taken(below));
        parallel::for_pieces_mut2(&mut more, &mut less, parallel::PIECE, |first, more, less| {
            for ((more, less), &value) in more.iter_mut().zip(less).zip(&values[first..]) {
                *more += if value > 0.0 { value } else { 0.0 };
                *less += if value < 0.0 { -value } else { 0.0 };
            }
        });
        for (key, sums) in [(above, more), (below, less)] {
            self.all.insert(key.name.into(), Values::F64(sums));
        }
    }

    /// Takes a field out.
    pub fn remove(&mut self, name: &str) -> Option<Values> {
        self.all.remove(name)
    }

    /// Names, sorted.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.all.keys().map(String::as_str)
    }

    /// Names and values, sorted by name.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Values)> {
        self.all.iter().map(|(n, v)| (n.as_str(), v))
    }

    fn missing(&self, name: &str, needed_by: &str) -> Error {
        Error::MissingField {
            name: name.into(),
            needed_by: needed_by.into(),
            available: std::iter::once("elevation").chain(self.names()).map(String::from).collect(),
        }
    }
}
